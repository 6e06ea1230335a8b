#include <array>

#include "Logic/Core/Errors.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/SurfaceFormats.h"
#include "Logic/IO/SurfaceParts.h"

// vtkOBJReader reorders and multiplies the points; other files (edges, landmark ids) count on the order of
// the `v` lines.

namespace falciform {

namespace {

class ObjReader {
 public:
  explicit ObjReader(const std::string& name) : name_(name) {}

  RawSurface read(const std::string& text) {
    TextCursor cursor(text);
    std::string joined;
    for (std::string_view line; cursor.nextLine(line);) {
      line_ = cursor.line();
      if (!line.empty() && line.back() == '\\') {  // goes on in the next line
        joined += std::string(line.substr(0, line.size() - 1)) + ' ';
        continue;
      }
      joined += line;
      readLine(joined);
      joined.clear();
    }
    readLine(joined);
    return finish();
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(name_ + ", line " + std::to_string(line_) + ": " + why + "; export it again");
  }

  void readLine(std::string_view line) {
    const std::string_view rest = line;
    const std::string_view keyword = nextWord(line);
    if (keyword == "v")
      addPoint(line);
    else if (keyword == "f")
      addFace(line);
    else if (keyword.starts_with('#')) {
      if (const auto tag = spaceTagIn(rest); tag && !raw_.space) raw_.space = tag;
    }
  }

  void addPoint(std::string_view line) {
    std::array<double, 7> values{};
    std::size_t count = 0;
    for (std::string_view word = nextWord(line); !word.empty() && count < values.size();
         word = nextWord(line))
      if (!parseNumber(word, values[count++])) refuse("a point has a word where a number should stand");
    if (count < 3) refuse("a point has only " + std::to_string(count) + " coordinates");
    coordinates_.insert(coordinates_.end(), values.begin(), values.begin() + 3);
    // x y z r g b, or x y z w r g b.
    if (count >= 6) colours_.insert(colours_.end(), values.begin() + (count - 3), values.begin() + count);
  }

  void addFace(std::string_view line) {
    const long long points = static_cast<long long>(coordinates_.size() / 3);
    const std::size_t begin = faceIds_.size();
    for (std::string_view word = nextWord(line); !word.empty(); word = nextWord(line)) {
      long long id = 0;
      if (!parseNumber(word.substr(0, word.find('/')), id) || id == 0)
        refuse("a face has a corner that is no point number");
      faceIds_.push_back(id > 0 ? id - 1 : points + id);  // negative: counted back from the last point so far
    }
    faceSizes_.push_back(faceIds_.size() - begin);
  }

  RawSurface finish() {
    Surface& surface = raw_.surface;
    surface.points =
        Eigen::Map<const Points>(coordinates_.data(), static_cast<Index>(coordinates_.size() / 3), 3);
    if (!colours_.empty() && colours_.size() == coordinates_.size()) {
      const Points rgb = Eigen::Map<const Points>(colours_.data(), surface.size(), 3);
      surface.colours = coloursFrom(rgb.maxCoeff() <= 1 ? Points(rgb * 255) : rgb);
    }
    TriangleCollector triangles(surface.size(), name_);
    std::span<const long long> rest(faceIds_);
    for (const std::size_t size : faceSizes_) {
      triangles.addPolygon(rest.first(size));
      rest = rest.subspan(size);
    }
    surface.triangles = triangles.triangles();
    return std::move(raw_);
  }

  const std::string& name_;
  std::size_t line_ = 0;
  RawSurface raw_;
  std::vector<double> coordinates_, colours_;
  std::vector<long long> faceIds_;  // faces may stand before their points
  std::vector<std::size_t> faceSizes_;
};

}  // namespace

RawSurface readObj(const std::string& text, const std::string& name) { return ObjReader(name).read(text); }

}  // namespace falciform
