#pragma once
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "Logic/Atlas/BentImages.h"
#include "Modules/CommandLine/Arguments.h"
#include "Modules/CommandLine/CommandRun.h"
#include "Modules/CommandLine/ParsedArguments.h"

namespace falciform::commandline {

/// In which coordinates bent images are written.
enum class ImageFrame { Scan, Preop, Both };
inline std::span<const std::string_view> enumNames(ImageFrame) {
  static constexpr std::string_view kNames[]{"scan", "preop", "both"};
  return kNames;
}

/// What is to be made of a model update beside surfaces and points; empty names: not asked for.
struct ImageOutputsPlan {
  std::filesystem::path ct, labels;  ///< to be read
  std::string series = {};           ///< which of a DICOM folder the CT is
  std::filesystem::path grid;        ///< displacements, to be written
  std::filesystem::path toolTips;    ///< to be read
  double gridSpacingMm = 3;          ///< 0: the CT's own grid
  ImageFrame frame = ImageFrame::Scan;
};

/// --ct, --labels, --images-in, --grid, --grid-spacing, --tool-tips.
void declareUpdateImages(Syntax& syntax, const std::string& group);
/// Of these --images-in and --grid-spacing alone, for a case that names its volumes itself.
void declareImageFrame(Syntax& syntax, const std::string& group);
void readImageFrame(const ParsedArguments& arguments, ImageFrame& frame, double& gridSpacingMm);
/// Throws InputError for file names of the wrong kind.
[[nodiscard]] ImageOutputsPlan imageOutputs(const ParsedArguments& arguments);

/// Says which files may come, before any computation: updated_mesh.vtu, ct_updated.*, labels_updated.*,
/// tool_tips_preop.* in `folder`, and the grid where it is named.
void announceImages(const ImageOutputsPlan& plan, const std::filesystem::path& folder, CommandRun& run);

/// What a picture of a slice needs; null without a CT.
struct BentCt {
  std::shared_ptr<const Image> before, after;  ///< `after` in bent coordinates
};

/// Writes them. `mesh` and `displacements` are an update's, `scanFrame` the scan's name. Throws InputError
/// where a volume has no part of the liver in it.
BentCt writeImages(const ImageOutputsPlan& plan, const UpdateMap& map, const TetrahedralMesh& mesh,
                   const Points& displacements, const std::string& scanFrame,
                   const std::filesystem::path& folder, CommandRun& run, const Progress& progress);

}  // namespace falciform::commandline
