#pragma once
#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace falciform::test {

/// A file of the given name whose bytes stand in memory (a link to a memfd), so that thousands of mutants
/// cost no disk time.
class MemoryFile {
 public:
  explicit MemoryFile(std::filesystem::path name)
      : name_(std::move(name)), descriptor_(memfd_create("mutant", MFD_CLOEXEC)) {
    if (descriptor_ < 0) throw std::runtime_error("no file in memory can be had");
    std::filesystem::create_symlink("/proc/self/fd/" + std::to_string(descriptor_), name_);
  }
  ~MemoryFile() {
    std::error_code ignored;
    std::filesystem::remove(name_, ignored);
    close(descriptor_);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// Replaces the whole content; returns the name.
  const std::filesystem::path& write(const std::string& bytes) {
    if (ftruncate(descriptor_, 0) != 0 ||
        pwrite(descriptor_, bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
      throw std::runtime_error("cannot write a file in memory");
    return name_;
  }

 private:
  std::filesystem::path name_;
  int descriptor_;
};

}  // namespace falciform::test
