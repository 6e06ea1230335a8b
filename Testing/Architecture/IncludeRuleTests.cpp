#include <gtest/gtest.h>

#include <map>
#include <set>

#include "Testing/Architecture/SourceTree.h"

namespace falciform::test {
namespace {

/// Which rooms a room may include, itself apart: the picture in Docs/Architecture.md, checked.
const std::map<std::string, std::set<std::string>>& allowedRooms() {
  static const std::map<std::string, std::set<std::string>> rule{
      {"Logic/Core", {}},
      {"Logic/VtkBridge", {"Logic/Core"}},
      {"Logic/Geometry", {"Logic/Core"}},
      // A raster of ranges is a surface only once neighbours are joined, and joining is geometry.
      {"Logic/IO", {"Logic/Core", "Logic/VtkBridge", "Logic/Geometry"}},
      {"Logic/Segmentation", {"Logic/Core", "Logic/Geometry", "Logic/VtkBridge"}},
      {"Logic/Acquisition", {"Logic/Core", "Logic/Geometry", "Logic/VtkBridge"}},
      {"Logic/Patches", {"Logic/Core", "Logic/Geometry"}},
      {"Logic/Registration", {"Logic/Core", "Logic/Geometry", "Logic/Patches"}},
      {"Logic/Deformation", {"Logic/Core", "Logic/Geometry", "Logic/Registration"}},
      {"Logic/Biomechanics", {"Logic/Core", "Logic/Geometry"}},
      {"Logic/Atlas", {"Logic/Core", "Logic/Geometry", "Logic/Biomechanics", "Logic/Registration"}},
  };
  return rule;
}

/// The room an include path leads to: two folders for Logic, one for the rest.
std::string roomOf(const std::string& path) {
  SourceFile file;
  file.path = path;
  return file.folder(path.starts_with("Logic/") ? 2 : 1);
}

bool startsWithAny(const std::string& text, const std::vector<std::string>& beginnings) {
  for (const std::string& beginning : beginnings)
    if (text.starts_with(beginning)) return true;
  return false;
}

bool isQtHeader(const std::string& header) {
  return header.size() > 1 && header[0] == 'Q' &&
         (std::isupper(static_cast<unsigned char>(header[1])) || header.starts_with("Qt"));
}

TEST(IncludeRule, LogicRoomsIncludeOnlyTheRoomsBelow) {
  for (const SourceFile& file : sourceFiles()) {
    if (file.folder(1) != "Logic") continue;
    const std::string room = file.folder(2);
    const auto rule = allowedRooms().find(room);
    ASSERT_NE(rule, allowedRooms().end())
        << room << " is a new room: give it a line in this test and in Docs/Architecture.md";
    for (const std::string& include : file.quotedIncludes) {
      if (include == "Version.h") continue;  // generated
      const std::string other = roomOf(include);
      EXPECT_TRUE(other == room || rule->second.contains(other)) << file.path << " includes " << include;
    }
  }
}

TEST(IncludeRule, WidgetsKnowLogicAndModulesKnowBoth) {
  for (const SourceFile& file : sourceFiles())
    for (const std::string& include : file.quotedIncludes) {
      const std::string top = file.folder(1), other = include.substr(0, include.find('/'));
      if (top == "Widgets") {
        EXPECT_NE(other, "Modules") << file.path << " includes " << include;
      }
      if (top != "Testing") {
        EXPECT_NE(other, "Testing") << file.path << " includes " << include;
      }
    }
}

TEST(IncludeRule, QuotedIncludesAreRootRelative) {
  for (const SourceFile& file : sourceFiles())
    for (const std::string& include : file.quotedIncludes) {
      const bool generated =
          include == "Version.h" || include.starts_with("ui_") || include.ends_with(".moc");
      EXPECT_TRUE(generated || std::filesystem::exists(sourceRoot() / include))
          << file.path << " includes " << include;
    }
}

TEST(IncludeRule, LogicAndRenderingKnowNothingOfQt) {
  for (const SourceFile& file : sourceFiles()) {
    if (file.folder(1) != "Logic" && file.folder(2) != "Widgets/Rendering" &&
        file.folder(2) != "Modules/CommandLine")
      continue;
    for (const std::string& include : file.systemIncludes)
      EXPECT_FALSE(isQtHeader(include)) << file.path << " includes " << include;
  }
}

TEST(IncludeRule, VtkStandsInVtkBridgeAndInSourceFilesOfIO) {
  for (const SourceFile& file : sourceFiles()) {
    if (file.folder(1) != "Logic" || file.folder(2) == "Logic/VtkBridge") continue;
    for (const std::string& include : file.systemIncludes)
      if (include.starts_with("vtk")) {
        EXPECT_TRUE(file.folder(2) == "Logic/IO" && !file.isHeader()) << file.path << " includes " << include;
      }
  }
}

TEST(IncludeRule, ForeignLibrariesStandInSourceFilesOnly) {
  const std::vector<std::string> foreign{"flann/", "tetgen",   "opencv", "cholmod", "tbb/",
                                         "zlib",   "openssl/", "gdcm",   "png.h",   "jpeglib"};
  for (const SourceFile& file : sourceFiles()) {
    if (file.folder(1) != "Logic" || !file.isHeader()) continue;
    for (const std::string& include : file.systemIncludes)
      EXPECT_FALSE(startsWithAny(include, foreign)) << file.path << " includes " << include;
  }
}

}  // namespace
}  // namespace falciform::test
