#include "Logic/IO/PcdHeader.h"

#include "Logic/Core/Errors.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/SurfaceFormats.h"

namespace falciform {

namespace {

constexpr double kLzfAtBest = 264.0 / 3;  // the longest copy for the shortest code

class HeaderReader {
 public:
  HeaderReader(const std::string& bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  PcdHeader read() {
    TextCursor cursor(bytes_);
    for (std::string_view line; cursor.nextLine(line);) {
      const std::string_view whole = line;
      const std::string_view keyword = nextWord(line);
      if (keyword.starts_with('#')) {
        if (const auto tag = spaceTagIn(whole)) header_.space = *tag;
      } else if (keyword == "DATA") {
        setCoding(nextWord(line));
        header_.bodyBegin = cursor.position();
        return finish();
      } else {
        readLine(keyword, line);
      }
      if (cursor.line() > 100) break;
    }
    refuse("its header has no DATA line");
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(name_ + " is not a sound PCD file: " + why + "; export it again");
  }

  template <class Number>
  Number number(std::string_view word, const char* what) const {
    Number value{};
    if (!parseNumber(word, value)) refuse(std::string("its ") + what + " is no number");
    return value;
  }

  template <class Take>
  void eachField(std::string_view line, Take take) {
    for (PcdField& field : header_.fields) take(field, nextWord(line));
  }

  void readLine(std::string_view keyword, std::string_view line) {
    if (keyword == "FIELDS" || keyword == "COLUMNS") {
      for (std::string_view word = nextWord(line); !word.empty(); word = nextWord(line))
        header_.fields.push_back({std::string(word), 'F', 4, 1});
    } else if (keyword == "SIZE") {
      eachField(line, [&](PcdField& field, std::string_view word) {
        field.size = number<std::size_t>(word, "SIZE");
      });
    } else if (keyword == "TYPE") {
      eachField(line,
                [&](PcdField& field, std::string_view word) { field.type = word.empty() ? '?' : word[0]; });
    } else if (keyword == "COUNT") {
      eachField(line, [&](PcdField& field, std::string_view word) {
        field.count = number<std::size_t>(word, "COUNT");
      });
    } else if (keyword == "WIDTH") {
      header_.width = number<int>(nextWord(line), "WIDTH");
    } else if (keyword == "HEIGHT") {
      header_.height = number<int>(nextWord(line), "HEIGHT");
    } else if (keyword == "VIEWPOINT") {
      for (double& value : header_.viewpoint) value = number<double>(nextWord(line), "VIEWPOINT");
    } else if (keyword == "POINTS") {
      announced_ = number<std::size_t>(nextWord(line), "POINTS");
    } else if (!keyword.empty() && keyword != "VERSION") {
      refuse("its header has an unknown line '" + std::string(keyword.substr(0, 20)) + "'");
    }
  }

  void setCoding(std::string_view word) {
    if (word == "ascii")
      header_.coding = PcdCoding::Ascii;
    else if (word == "binary")
      header_.coding = PcdCoding::Binary;
    else if (word == "binary_compressed")
      header_.coding = PcdCoding::Compressed;
    else
      refuse("its data are '" + std::string(word.substr(0, 20)) +
             "', not ascii, binary or binary_compressed");
  }

  PcdHeader finish() {
    if (header_.fields.empty()) refuse("it names no FIELDS");
    if (header_.width < 1 || header_.height < 1) refuse("its WIDTH or HEIGHT is below 1");
    if (!header_.viewpoint.allFinite()) refuse("its VIEWPOINT is not finite");
    for (const PcdField& field : header_.fields) {
      const bool real = field.type == 'F' && (field.size == 4 || field.size == 8);
      const bool whole = (field.type == 'I' || field.type == 'U') &&
                         (field.size == 1 || field.size == 2 || field.size == 4 || field.size == 8);
      if (!real && !whole) refuse("field '" + field.name.substr(0, 20) + "' has an unknown TYPE or SIZE");
      if (field.count < 1 || field.count > 10'000)
        refuse("field '" + field.name.substr(0, 20) + "' has an impossible COUNT");
    }
    const double points = static_cast<double>(header_.width) * header_.height;
    if (announced_ && static_cast<double>(*announced_) != points) refuse("POINTS is not WIDTH x HEIGHT");
    const auto rest = static_cast<double>(bytes_.size() - header_.bodyBegin);
    // In a text every value takes at least a digit and a blank.
    double values = 0;
    for (const PcdField& field : header_.fields) values += static_cast<double>(field.count);
    const double least = header_.coding == PcdCoding::Ascii ? (2 * values - 1) * points
                         : header_.coding == PcdCoding::Binary
                             ? points * double(header_.pointBytes())
                             : points * double(header_.pointBytes()) / kLzfAtBest;
    if (least > rest) refuse("it announces more points than its bytes hold (truncated)");
    return header_;
  }

  const std::string& bytes_;
  const std::string& name_;
  PcdHeader header_;
  std::optional<std::size_t> announced_;
};

}  // namespace

std::size_t PcdHeader::pointBytes() const {
  std::size_t bytes = 0;
  for (const PcdField& field : fields) bytes += field.size * field.count;
  return bytes;
}

PcdHeader readPcdHeader(const std::string& bytes, const std::string& name) {
  return HeaderReader(bytes, name).read();
}

}  // namespace falciform
