#include "Logic/IO/HeaderText.h"

#include <array>
#include <charconv>
#include <cstdio>

#include "Logic/IO/ByteReader.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/VolumeLayout.h"

namespace falciform {

namespace {

constexpr std::size_t kLongestHeader = std::size_t{4} << 20;
constexpr std::string_view kBlanks = " \t\r\n";

template <class T>
std::optional<T> parsed(std::string_view text) {
  T value{};
  return parseNumber(trimmed(text), value) ? std::optional(value) : std::nullopt;
}

template <class T, class Parse>
std::vector<T> listOf(const std::filesystem::path& file, std::string_view key, std::string_view text,
                      std::size_t count, const char* kind, Parse parse) {
  std::vector<T> values;
  for (const std::string_view word : words(text)) {
    const std::optional<T> value = parse(word);
    if (!value || values.size() == count) {
      values.clear();
      break;
    }
    values.push_back(*value);
  }
  if (values.size() != count)
    refuseVolume(file, "the header's '" + std::string(key) + "' is " + inQuotes(text) + "; it must be " +
                           std::to_string(count) + " " + kind + ": correct the header");
  return values;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> found;
  constexpr std::string_view separators = " \t\r\n,";
  for (std::size_t at = text.find_first_not_of(separators); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(separators, at), text.size());
    found.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(separators, end);
  }
  return found;
}

std::optional<double> toNumber(std::string_view text) { return parsed<double>(text); }
std::optional<std::int64_t> toWhole(std::string_view text) { return parsed<std::int64_t>(text); }

std::vector<double> numbersOf(const std::filesystem::path& file, std::string_view key, std::string_view text,
                              std::size_t count) {
  return listOf<double>(file, key, text, count, "numbers", toNumber);
}

std::vector<std::int64_t> wholesOf(const std::filesystem::path& file, std::string_view key,
                                   std::string_view text, std::size_t count) {
  return listOf<std::int64_t>(file, key, text, count, "whole numbers", toWhole);
}

std::string inQuotes(std::string_view text) {
  std::string shown = "'";
  for (const char c : text.substr(0, 60)) shown += c >= ' ' && c <= '~' ? c : '?';
  return shown + (text.size() > 60 ? "...'" : "'");
}

std::string shortText(double value) {
  std::array<char, 40> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6).ptr;
  return {text.data(), end};
}

HeaderLines readHeaderLines(const std::filesystem::path& file, bool (*isLast)(std::string_view line)) {
  ByteReader reader(file, 0, Packing::Raw);
  HeaderLines header;
  std::string line;
  std::array<char, 4096> block;
  while (const std::size_t count = reader.read(block.data(), block.size())) {
    for (std::size_t i = 0; i < count; ++i) {
      ++header.end;
      if (block[i] != '\n') {
        line += block[i];
        continue;
      }
      if (line.ends_with('\r')) line.pop_back();
      header.lines.push_back(std::move(line));
      line.clear();
      if (isLast(header.lines.back())) {
        header.complete = true;
        return header;
      }
    }
    if (header.end > kLongestHeader)
      refuseVolume(file, "its header does not end within 4 MB; it is damaged: export it again");
  }
  if (!line.empty()) header.lines.push_back(std::move(line));
  header.complete = !header.lines.empty() && isLast(header.lines.back());
  return header;
}

std::optional<double> mmOfUnit(std::string_view unit) {
  const std::string name = lowerCase(unit);
  if (name == "mm" || name == "millimeter" || name == "millimeters" || name == "millimetre") return 1.0;
  if (name == "m" || name == "meter" || name == "meters" || name == "metre") return 1000.0;
  if (name == "cm" || name == "centimeter" || name == "centimetre") return 10.0;
  if (name == "um" || name == "\xc2\xb5m" || name == "\xce\xbcm" || name == "micrometer" ||
      name == "micrometre" || name == "micron" || name == "microns")
    return 0.001;
  return std::nullopt;
}

}  // namespace falciform
