#pragma once
#include <filesystem>
#include <functional>
#include <string>

namespace falciform {

/// Whether an existing file may be replaced.
enum class Overwrite { Refuse, Replace };

/// Creates the file under a temporary name in the same folder by calling `write(temporaryPath)` (same
/// extension), flushes it to disk and renames it; on any failure the temporary file is removed and the old
/// file is as it was. Throws InputError: exists and not to be replaced, folder missing or unwritable, disk
/// full.
void writeFile(const std::filesystem::path& file, Overwrite overwrite,
               const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for a text.
void writeTextFile(const std::filesystem::path& file, Overwrite overwrite, const std::string& text);

/// Creates `folder` with its parents if need be; throws InputError if that cannot be done or it is no
/// writable folder.
void makeFolder(const std::filesystem::path& folder);

/// The whole file; throws InputError if it is missing, a folder or unreadable.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& file);

/// Lower-case hexadecimal SHA-256 of a file's bytes.
[[nodiscard]] std::string sha256OfFile(const std::filesystem::path& file);

}  // namespace falciform
