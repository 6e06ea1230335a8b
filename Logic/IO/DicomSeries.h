#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "Logic/Core/Progress.h"
#include "Logic/Core/Volume.h"
#include "Logic/IO/Loaded.h"

namespace falciform {

/// One slice of a series: where its pixels are, and where it lies in the series' grid.
struct DicomSlice {
  std::filesystem::path file;
  std::size_t frame = 0, frames = 1;  ///< of the file
  double index = 0;                   ///< k of the grid; between two whole numbers if the series is resampled
  int segment = 0;                    ///< of a DICOM SEG
};

/// A DICOM series as a volume, before its pixels are read. Holds no name, ID or date of the patient.
struct DicomSeries {
  std::string code;      ///< 8 hexadecimal digits, from a digest of its identifier: the same on every reading
  std::string modality;  ///< "CT", "SEG", ...
  std::string
      description;  ///< of the series, else the name of its folder; words that name the patient are dropped
  Vector3i size = Vector3i::Zero();
  Matrix4d worldFromIndex = Matrix4d::Identity();  ///< LPS mm of a voxel's centre
  std::size_t files = 0;
  bool segmentation = false;            ///< a DICOM SEG: its voxels are labels
  std::map<int, std::string> segments;  ///< names of a DICOM SEG's labels
  std::vector<DicomSlice> slices;       ///< sorted by index
  bool resampled = false;               ///< uneven slices: see the warnings
  std::vector<std::string> warnings;    ///< gantry tilt, uneven or missing slices, copies
  std::string refusal;                  ///< why it cannot be read as a volume; empty: it can

  [[nodiscard]] Vector3d spacingMm() const { return worldFromIndex.topLeftCorner<3, 3>().colwise().norm(); }
};

/// What was found in a folder.
struct DicomListing {
  std::vector<DicomSeries> series;  ///< in the order of their files' names
  std::size_t otherFiles = 0;       ///< that are no DICOM
  std::vector<std::string>
      unreadable;  ///< reasons why DICOM files were left out, each with its number of files
};

/// Finds all series in a folder and those below it, by their content: names and extensions do not matter,
/// DICOMDIR and files of other kinds are passed over. A file that is given stands for its series, with the
/// files beside it. Throws InputError if nothing there is DICOM.
[[nodiscard]] DicomListing listDicom(const std::filesystem::path& folderOrFile,
                                     const Progress& progress = {});

/// True for a file that begins as DICOM files do, and for a folder with such a file in it or below it.
[[nodiscard]] bool isDicom(const std::filesystem::path& folderOrFile);

/// "1: CT 'portal phase', 512 x 512 x 119 voxels of 0.743 x 0.743 x 1.600 mm, 119 files [3fa91c20]".
[[nodiscard]] std::string describeSeries(const DicomSeries& series, std::size_t number);

/// The one that `choice` means: its number in the list (from 1) or its code; empty: the only one that can be
/// read. Throws InputError that lists the choices.
[[nodiscard]] const DicomSeries& chooseSeries(const DicomListing& listing, const std::string& choice);

/// SHA-256 over those of its files, in the order of its slices: for a result's record of its inputs.
[[nodiscard]] std::string sha256OfSeries(const DicomSeries& series);

/// The voxels of a series of intensities, rescaled (CT: Hounsfield units). MONOCHROME1 says how to display,
/// not what a value is: values are as in MONOCHROME2. Throws InputError for damaged files.
[[nodiscard]] Loaded<Image> readDicomImage(const DicomSeries& series, const Progress& progress = {});

/// A label map: of a DICOM SEG (a label is its segment's number), of a series with two values (the larger is
/// label 1) or of a series whose values are labels already. Throws InputError for intensities (a CT).
[[nodiscard]] Loaded<LabelMap> readDicomLabels(const DicomSeries& series, const Progress& progress = {});

/// Several mask series on one grid as one label map: label 1 is the largest. Where they overlap the smaller
/// is kept, so that tumours and vessels stand in the liver.
struct NamedLabels {
  LabelMap map;
  std::map<int, std::string> names;
};
[[nodiscard]] Loaded<NamedLabels> readDicomMasks(const std::vector<DicomSeries>& series,
                                                 const Progress& progress = {});

/// The series that `choice` means as labels with their names; without a choice, of a folder with nothing but
/// masks, all of them together. Throws InputError that lists the choices where it is not clear.
[[nodiscard]] Loaded<NamedLabels> readChosenLabels(const DicomListing& listing, const std::string& choice,
                                                   const Progress& progress = {});

/// The one slice through the middle of a series, values as readDicomImage has them, for a thumbnail; width
/// columns, height rows.
struct DicomThumbnail {
  int width = 0, height = 0;
  std::vector<float> values;
};
[[nodiscard]] DicomThumbnail readDicomMiddle(const DicomSeries& series);

}  // namespace falciform
