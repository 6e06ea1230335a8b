#pragma once
#include <map>
#include <string>
#include <vector>

#include "Logic/Core/Types.h"
#include "Logic/IO/DicomElements.h"

namespace falciform {

/// One slice of a file: most files hold one, enhanced CT and DICOM SEG many.
struct DicomFrame {
  Vector3d position = Vector3d::Zero();  ///< LPS mm of its first voxel's centre
  double slope = 1, intercept = 0;
  int segment = 0;  ///< of a DICOM SEG: the segment it belongs to
};

/// How pixels stand in a file.
struct DicomPixelFormat {
  int rows = 0, columns = 0;
  int bitsAllocated = 16, bitsStored = 16, highBit = 15;
  bool isSigned = false, bigEndian = false;
  std::string transferSyntax;
};

/// What one DICOM file says of its slices. Inside Logic/IO only; identity is kept as digests, to tell series
/// and copies apart.
struct DicomHeader {
  std::string seriesDigest, instanceDigest;  ///< 16 hexadecimal digits of the identifiers' SHA-256
  std::string modality, description;         ///< words of the patient's name, ID and dates taken out
  DicomPixelFormat format;
  Eigen::Vector2d spacingMm = Eigen::Vector2d::Zero();  ///< between columns (along a row), between rows
  Eigen::Matrix<double, 3, 2> axes = Eigen::Matrix<double, 3, 2>::Zero();  ///< along a row, along a column
  double thicknessMm = 0, betweenSlicesMm = 0;  ///< 0 where missing; the first is no spacing
  double acquisition = 0, temporalPosition = 0;
  std::vector<DicomFrame> frames;
  bool segmentation = false;            ///< a DICOM SEG
  bool fractional = false;              ///< its voxels are shares of
  int maximumFraction = 255;            ///< this; half of it and more is inside
  bool labelMap = false;                ///< its voxels are the segments' numbers
  std::map<int, std::string> segments;  ///< its names
};

/// The header of one file with slices that lie somewhere in the patient. Throws InputError (no file, no
/// content named) for anything else: reports, screenshots, colour images, and headers that contradict
/// themselves.
[[nodiscard]] DicomHeader dicomHeader(const DicomFile& file);

}  // namespace falciform
