#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "Logic/IO/DicomHeader.h"
#include "Logic/IO/DicomSeries.h"

namespace falciform {

/// A file that has slices. Inside Logic/IO only.
struct DicomFileHeader {
  std::filesystem::path file;
  std::string folderWords;  ///< its folder's name without words that name the patient
  DicomHeader header;
};

/// Files to series: by identifier, size and direction; where several slices lie at one place, by folder,
/// acquisition and time; copies are dropped.
[[nodiscard]] std::vector<DicomSeries> groupDicom(std::vector<DicomFileHeader> files);

}  // namespace falciform
