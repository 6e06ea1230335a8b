#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace falciform::test {

/// A source file of the tree, path relative to its root with forward slashes.
struct SourceFile {
  std::string path;
  std::vector<std::string> lines;
  /// Root-relative include paths in quotes, and those in angle brackets.
  std::vector<std::string> quotedIncludes, systemIncludes;

  [[nodiscard]] bool isHeader() const { return path.ends_with(".h"); }
  /// First `count` folders, "Logic/Core" for 2.
  [[nodiscard]] std::string folder(int count) const;
};

[[nodiscard]] std::filesystem::path sourceRoot();
/// All .h and .cpp files under Logic, Widgets, Modules and Testing.
[[nodiscard]] const std::vector<SourceFile>& sourceFiles();

}  // namespace falciform::test
