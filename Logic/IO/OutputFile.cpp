#include "Logic/IO/OutputFile.h"

#include <fcntl.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "Logic/Core/Errors.h"

namespace falciform {

namespace {

namespace fs = std::filesystem;

/// What went wrong with a file, in the user's words.
[[noreturn]] void refuse(const fs::path& file, const std::string& deed, int error) {
  const std::string start = "cannot " + deed + " '" + file.string() + "': ";
  switch (error) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      throw InputError(start +
                       "the disk is full or a size limit is reached; make room or choose another folder");
    case EACCES:
    case EPERM:
    case EROFS:
      throw InputError(start + "no permission; choose another folder or change its permissions");
    case ENOENT:
      throw InputError(start + "there is no such file or folder; check the path");
    case EISDIR:
      throw InputError(start + "it is a folder; give a file");
    default:
      throw InputError(start + std::strerror(error) + "; check the path and the disk");
  }
}

class Descriptor {
 public:
  Descriptor(const fs::path& file, int flags, mode_t mode = 0666)
      : id(open(file.c_str(), flags | O_CLOEXEC, mode)) {}
  ~Descriptor() {
    if (id >= 0) ::close(id);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  const int id;
};

/// Hidden, unique, and with the same extensions, since writers and compressors go by these (".nii.gz",
/// ".seg.nrrd").
fs::path temporaryBeside(const fs::path& file) {
  static std::atomic<unsigned> counter = 0;
  const std::string extension = fs::path(file.stem()).extension().string() + file.extension().string();
  return file.parent_path() / (".partial-" + std::to_string(getpid()) + "-" + std::to_string(counter++) +
                               (extension.size() < 40 ? extension : file.extension().string()));
}

class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path) : path_(std::move(path)) {}
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  const fs::path path_;
};

[[noreturn]] void refuseExisting(const fs::path& file) {
  throw InputError("'" + file.string() +
                   "' exists already; give --force to replace it, or choose another name");
}

/// Says early what would only show after minutes of computing.
void checkTarget(const fs::path& file, Overwrite overwrite) {
  if (file.filename().empty()) throw InputError("'" + file.string() + "' names no file; give a file name");
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw InputError("cannot write '" + file.string() + "': there is no folder '" + folder.string() +
                     "'; make it first");
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) return;
  if (fs::is_directory(status)) refuse(file, "write", EISDIR);
  if (!fs::is_regular_file(status))
    throw InputError("'" + file.string() + "' is a device or a pipe; give the name of an ordinary file");
  if (overwrite == Overwrite::Refuse) refuseExisting(file);
}

void flush(const fs::path& file, const fs::path& shownAs, int flags) {
  const Descriptor open(file, flags);
  if (open.id < 0) refuse(shownAs, "write", errno);
  if (fsync(open.id) != 0 && errno != EINVAL) refuse(shownAs, "write", errno);
}

}  // namespace

void writeFile(const fs::path& given, Overwrite overwrite,
               const std::function<void(const fs::path&)>& write) {
  checkTarget(given, overwrite);
  std::error_code error;
  const fs::path file =
      fs::is_symlink(given, error) ? fs::weakly_canonical(given) : given;  // keep a link a link
  const TemporaryFile temporary(temporaryBeside(file));
  {
    const Descriptor probe(temporary.path(), O_WRONLY | O_CREAT | O_EXCL);
    if (probe.id < 0) refuse(given, "write", errno);
  }
  write(temporary.path());
  flush(temporary.path(), given, O_RDONLY);

  struct stat old {};
  if (stat(file.c_str(), &old) == 0) (void)chmod(temporary.path().c_str(), old.st_mode & 07777);
  // A file that appeared meanwhile is not ours to replace. Some file systems do not know the flag: then plain
  // rename.
  const unsigned flag = overwrite == Overwrite::Refuse ? RENAME_NOREPLACE : 0;
  if (renameat2(AT_FDCWD, temporary.path().c_str(), AT_FDCWD, file.c_str(), flag) != 0) {
    if (errno == EEXIST) refuseExisting(given);
    if (rename(temporary.path().c_str(), file.c_str()) != 0) refuse(given, "write", errno);
  }
  flush(file.has_parent_path() ? file.parent_path() : fs::path("."), given, O_RDONLY | O_DIRECTORY);
}

void writeTextFile(const fs::path& file, Overwrite overwrite, const std::string& text) {
  writeFile(file, overwrite, [&](const fs::path& temporary) {
    const Descriptor out(temporary, O_WRONLY | O_TRUNC);
    if (out.id < 0) refuse(file, "write", errno);
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t count = ::write(out.id, text.data() + done, text.size() - done);
      if (count < 0 && errno != EINTR) refuse(file, "write", errno);
      if (count > 0) done += static_cast<std::size_t>(count);
    }
  });
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) {
    if (!error || fs::exists(folder))
      throw InputError("cannot make the folder '" + folder.string() +
                       "': a file is in the way; choose another name");
    refuse(folder, "make the folder", error.value());
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0) refuse(folder, "write into the folder", errno);
}

namespace {

/// Calls `take` with the bytes of an ordinary file, block by block.
template <class Take>
void readBlocks(const fs::path& file, Take&& take) {
  const Descriptor in(file, O_RDONLY);
  if (in.id < 0) refuse(file, "read", errno);
  struct stat status {};
  if (fstat(in.id, &status) != 0) refuse(file, "read", errno);
  if (S_ISDIR(status.st_mode)) refuse(file, "read", EISDIR);
  if (!S_ISREG(status.st_mode))
    throw InputError("'" + file.string() + "' is a device or a pipe; give an ordinary file");
  std::array<char, 1 << 16> block;
  for (;;) {
    const ssize_t count = ::read(in.id, block.data(), block.size());
    if (count == 0) return;
    if (count > 0)
      take(block.data(), static_cast<std::size_t>(count));
    else if (errno != EINTR)
      refuse(file, "read", errno);
  }
}

}  // namespace

std::string readTextFile(const fs::path& file) {
  std::string text;
  readBlocks(file, [&](const char* bytes, std::size_t count) { text.append(bytes, count); });
  return text;
}

std::string sha256OfFile(const fs::path& file) {
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
  if (!context || EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL offers no SHA-256");
  readBlocks(file,
             [&](const char* bytes, std::size_t count) { EVP_DigestUpdate(context.get(), bytes, count); });
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned length = 0;
  EVP_DigestFinal_ex(context.get(), digest.data(), &length);
  std::string text;
  for (unsigned i = 0; i < length; ++i) {
    char pair[3];
    std::snprintf(pair, sizeof pair, "%02x", digest[i]);
    text += pair;
  }
  return text;
}

}  // namespace falciform
