#pragma once
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

#include "Logic/Core/NumberText.h"

namespace falciform {

/// Reads a text line by line and number by number, always with a decimal point, whatever the locale. Inside
/// Logic/IO only.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text) : text_(text) {}

  /// The next line without its end (LF, CR LF or CR); false at the end of the text.
  [[nodiscard]] bool nextLine(std::string_view& line) {
    if (at_ >= text_.size()) return false;
    const std::size_t end = std::min(text_.find_first_of("\r\n", at_), text_.size());
    line = text_.substr(at_, end - at_);
    at_ = end + (text_.substr(end, 2) == "\r\n" ? 2 : 1);
    ++line_;
    return true;
  }
  /// 1-based number of the line last read.
  [[nodiscard]] std::size_t line() const { return line_; }
  /// Bytes read so far.
  [[nodiscard]] std::size_t position() const { return std::min(at_, text_.size()); }

 private:
  std::string_view text_;
  std::size_t at_ = 0, line_ = 0;
};

/// Takes the next word off the front of `rest`; empty when there is none.
[[nodiscard]] inline std::string_view nextWord(std::string_view& rest,
                                               std::string_view separators = " \t\r\n\f\v") {
  const std::size_t begin = std::min(rest.find_first_not_of(separators), rest.size());
  const std::size_t end = std::min(rest.find_first_of(separators, begin), rest.size());
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

/// True if all of `word` is one number, which is then in `value`. Takes "nan" and "inf"; the caller checks
/// what it needs.
template <class Number>
[[nodiscard]] bool parseNumber(std::string_view word, Number& value) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() && !word.empty();
}

}  // namespace falciform
