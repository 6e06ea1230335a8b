#include "Logic/IO/DicomWords.h"

#include <openssl/evp.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "Logic/IO/DicomSeries.h"
#include "Logic/IO/HeaderText.h"
#include "Logic/IO/OutputFile.h"

namespace falciform {

namespace {

using namespace dicomtag;

constexpr std::size_t kLongest = 64;

bool isLetter(unsigned char c) { return std::isalnum(c) != 0 || c >= 0x80; }

/// Latin-1 (ISO_IR 100) and UTF-8 (ISO_IR 192) are known; of other sets the ASCII letters are kept.
std::string inUtf8(std::string_view text, std::string_view characterSet) {
  const bool utf8 = characterSet == "ISO_IR 192", latin = characterSet == "ISO_IR 100";
  std::string out;
  for (const char letter : text) {
    const auto c = static_cast<unsigned char>(letter);
    if (c < 0x20 || c == 0x7F)
      out += ' ';
    else if (c < 0x80 || utf8)
      out += letter;
    else if (latin)
      out.append({static_cast<char>(0xC0 | c >> 6), static_cast<char>(0x80 | (c & 0x3F))});
    else
      out += '?';
  }
  return out;
}

/// True for well-formed UTF-8: JSON takes nothing else.
bool isUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const std::size_t more = c < 0x80                ? 0
                             : c >= 0xC2 && c < 0xE0 ? 1
                             : c >= 0xE0 && c < 0xF0 ? 2
                             : c >= 0xF0 && c < 0xF5 ? 3
                                                     : 9;
    if (more == 9 || i + more >= text.size()) return false;
    for (std::size_t k = 1; k <= more; ++k)
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0) != 0x80) return false;
    i += more + 1;
  }
  return true;
}

std::vector<std::string> wordsOf(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  for (const char letter : text) {
    if (isLetter(static_cast<unsigned char>(letter))) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    } else if (!word.empty()) {
      words.push_back(std::move(word));
      word.clear();
    }
  }
  if (!word.empty()) words.push_back(std::move(word));
  return words;
}

/// Organs stay even where an anonymiser has put them into the patient's name.
bool isAnatomy(std::string_view lower) {
  static constexpr std::string_view kStems[] = {
      "abdom",  "aort",    "arter", "bile",  "bone",   "body",  "cava",  "couinaud", "cyst",    "duct",
      "gall",   "heart",   "hepat", "kidne", "lesion", "liver", "lung",  "metas",    "pancrea", "porta",
      "resect", "segment", "skin",  "splee", "tumo",   "vein",  "venou", "vessel"};
  return std::any_of(std::begin(kStems), std::end(kStems),
                     [&](auto stem) { return lower.starts_with(stem); });
}

/// Without numbers of six and more digits, as they stand in dates, times and IDs ("20221208", "2022-12-08").
std::string withoutLongNumbers(const std::string& text) {
  std::string kept, run;
  std::size_t digits = 0;
  const auto end = [&] {
    if (digits < 6) kept += run;
    run.clear();
    digits = 0;
  };
  for (const char letter : text) {
    const bool digit = std::isdigit(static_cast<unsigned char>(letter)) != 0;
    if (!digit && std::string_view("./-:").find(letter) == std::string_view::npos) {
      end();
      kept += letter;
      continue;
    }
    digits += digit;
    run += letter;
  }
  end();
  return kept;
}

}  // namespace

namespace {

std::string sha256(std::string_view text, std::size_t bytes) {
  unsigned char digest[EVP_MAX_MD_SIZE] = {};
  unsigned int length = 0;
  EVP_Digest(text.data(), text.size(), digest, &length, EVP_sha256(), nullptr);
  std::string hexadecimal;
  for (std::size_t b = 0; b < bytes; ++b) {
    hexadecimal += "0123456789abcdef"[digest[b] >> 4];
    hexadecimal += "0123456789abcdef"[digest[b] & 15];
  }
  return hexadecimal;
}

}  // namespace

std::string digestOf(std::string_view identifier) { return sha256(identifier, 8); }

std::string sha256OfSeries(const DicomSeries& series) {
  std::string digests;
  const std::filesystem::path* last = nullptr;
  for (const DicomSlice& slice : series.slices) {
    if (!last || slice.file != *last) digests += sha256OfFile(slice.file);
    last = &slice.file;
  }
  return sha256(digests, 32);
}

std::string plainWords(const DicomItem& data, std::string_view text) {
  const std::string_view characterSet = data.text(kCharacterSet);
  std::vector<std::string> secret;
  for (const DicomTag tag : {kPatientName, kPatientId, kBirthDate, kStudyDate})
    for (std::string& word : wordsOf(inUtf8(data.text(tag).substr(0, 4096), characterSet)))
      if (word.size() > 1) secret.push_back(std::move(word));
  const std::string all = withoutLongNumbers(inUtf8(text.substr(0, 4096), characterSet));
  std::string kept, word;
  const auto keepWord = [&] {
    const auto lower = wordsOf(word);
    const bool known = !lower.empty() && !isAnatomy(lower.front()) &&
                       std::find(secret.begin(), secret.end(), lower.front()) != secret.end();
    if (!known) kept += word;
    word.clear();
  };
  for (const char letter : all) {
    if (isLetter(static_cast<unsigned char>(letter))) {
      word += letter;
      continue;
    }
    keepWord();
    if (letter != ' ' || (!kept.empty() && kept.back() != ' ')) kept += letter;
  }
  keepWord();
  kept = std::string(trimmed(kept));
  if (kept.size() > kLongest) {
    std::size_t end = kLongest;
    while (end > 0 && (static_cast<unsigned char>(kept[end]) & 0xC0) == 0x80) --end;
    kept.resize(end);
  }
  return isUtf8(kept) ? kept : std::string();
}

std::string codeWord(std::string_view text) {
  const bool code = text.size() <= 16 && std::all_of(text.begin(), text.end(), [](char c) {
                      return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
                    });
  return code ? std::string(text) : std::string();
}

}  // namespace falciform
