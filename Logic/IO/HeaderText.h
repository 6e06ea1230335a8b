#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace falciform {

// Words and numbers of text headers, always in the C locale.

/// Without blanks, tabs and carriage returns at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);
[[nodiscard]] std::string lowerCase(std::string_view text);
/// The words between blanks, tabs and commas.
[[nodiscard]] std::vector<std::string_view> words(std::string_view text);

/// The whole of `text` as a number ("nan" and "inf" included); nothing if it is anything else.
[[nodiscard]] std::optional<double> toNumber(std::string_view text);
[[nodiscard]] std::optional<std::int64_t> toWhole(std::string_view text);

/// All of `text` as exactly `count` numbers; throws InputError naming `file` and `key` otherwise.
[[nodiscard]] std::vector<double> numbersOf(const std::filesystem::path& file, std::string_view key,
                                            std::string_view text, std::size_t count);
[[nodiscard]] std::vector<std::int64_t> wholesOf(const std::filesystem::path& file, std::string_view key,
                                                 std::string_view text, std::size_t count);

/// In quotes, on one line, printable and no longer than 60 characters, for messages.
[[nodiscard]] std::string inQuotes(std::string_view text);
/// Six significant digits, for messages.
[[nodiscard]] std::string shortText(double value);

/// The lines of a text file's first 4 MB, without line ends, up to and including the first for which `isLast`
/// is true, with the byte after it. Throws InputError if the file cannot be read or holds a line that is no
/// header text.
struct HeaderLines {
  std::vector<std::string> lines;
  std::uint64_t end = 0;  ///< bytes up to and with the last line's end
  bool complete = false;  ///< `isLast` was met
};
[[nodiscard]] HeaderLines readHeaderLines(const std::filesystem::path& file,
                                          bool (*isLast)(std::string_view line));

/// "0.001" for metres and so on: mm in one `unit`, from its name ("mm", "micrometer", "um", "cm", "m");
/// nothing if unknown.
[[nodiscard]] std::optional<double> mmOfUnit(std::string_view unit);

}  // namespace falciform
