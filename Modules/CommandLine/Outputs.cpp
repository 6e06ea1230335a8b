#include "Modules/CommandLine/Outputs.h"

#include <unistd.h>

#include <algorithm>

#include "Logic/Core/Errors.h"
#include "Logic/IO/SurfaceFiles.h"

namespace falciform::commandline {

namespace fs = std::filesystem;

namespace {

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

}  // namespace

std::string Outputs::hiddenName() { return ".falciform-" + std::to_string(getpid()); }

Outputs::~Outputs() {
  std::error_code ignored;
  for (const auto& [folder, hidden] : staging_) fs::remove_all(hidden, ignored);
  // Only empty folders go: after commit() ours are not.
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, ignored);
}

fs::path Outputs::stagingFor(const fs::path& folder) {
  if (const auto found = staging_.find(folder); found != staging_.end()) return found->second;
  // A folder inside one that is staged already is staged inside that one's hidden folder.
  for (fs::path up = folder.parent_path(); !up.empty() && up != up.root_path(); up = up.parent_path())
    if (const auto found = staging_.find(up); found != staging_.end()) {
      const fs::path inside = found->second / folder.lexically_relative(up);
      makeFolder(inside);
      return staging_[folder] = inside;
    }
  noteMissing(folder);
  makeFolder(folder);
  const fs::path hidden = folder / hiddenName();
  staging_[folder] = hidden;
  makeFolder(hidden);
  return hidden;
}

void Outputs::noteMissing(const fs::path& folder) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  for (fs::path up = fs::absolute(folder).lexically_normal();
       !up.empty() && up != up.root_path() && !fs::exists(up, ignored); up = up.parent_path())
    if (up.has_filename()) missing.insert(missing.begin(), up);
  made_.insert(made_.end(), missing.begin(), missing.end());
}

void Outputs::announce(const fs::path& file) {
  if (!file.has_filename()) throw InputError("'" + file.string() + "' is a folder; name a file to write");
  std::error_code ignored;
  if (fs::is_directory(file, ignored))
    throw InputError("'" + file.string() + "' is a folder; name a file to write");
  if (overwrite == Overwrite::Refuse && fs::exists(file, ignored))
    throw InputError("'" + file.string() + "' exists; choose another name or give --force");
  if (std::find(announced_.begin(), announced_.end(), file) != announced_.end())
    throw InputError("'" + file.string() + "' would be written twice; give different names");
  stagingFor(folderOf(file));
  announced_.push_back(file);
}

fs::path Outputs::staged(const fs::path& file) const {
  const auto found = staging_.find(folderOf(file));
  if (found == staging_.end()) throw std::logic_error("'" + file.string() + "' was not announced");
  return found->second / file.filename();
}

void Outputs::commit() {
  std::error_code error;
  // The texture of a surface is written beside it.
  std::vector<fs::path> along;
  for (const fs::path& file : announced_)
    for (const fs::path& beside : filesBeside(file))
      if (fs::exists(staged(beside)) &&
          std::find(announced_.begin(), announced_.end(), beside) == announced_.end())
        along.push_back(beside);
  for (const fs::path& file : along) announce(file);
  for (const auto& [folder, hidden] : staging_) {
    noteMissing(folder);
    makeFolder(folder);
  }
  for (const fs::path& file : announced_) {
    const fs::path from = staged(file);
    if (!fs::exists(from)) {
      if (overwrite == Overwrite::Replace) fs::remove(file, error);
      continue;
    }
    fs::rename(from, file, error);
    if (error) throw InputError("cannot write '" + file.string() + "': " + error.message());
    written_.push_back(file);
  }
  announced_.clear();
  for (const fs::path& file : superseded_) fs::remove(file, error);
}

}  // namespace falciform::commandline
