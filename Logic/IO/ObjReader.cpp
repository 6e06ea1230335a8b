#include <algorithm>
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
    else if (keyword == "vt")
      addPlace(line);
    else if (keyword == "f")
      addFace(line);
    else if (keyword == "mtllib")
      raw_.materials.library = trimmed(line);
    else if (keyword == "usemtl")
      useMaterial(trimmed(line));
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

  void addPlace(std::string_view line) {
    float u = 0, v = 0;
    if (!parseNumber(nextWord(line), u)) refuse("a texture coordinate is no number");
    if (const std::string_view word = nextWord(line); !word.empty() && !parseNumber(word, v))
      refuse("a texture coordinate is no number");
    places_.insert(places_.end(), {u, v});
  }

  void useMaterial(const std::string& name) {
    auto& names = raw_.materials.names;
    const auto found = std::find(names.begin(), names.end(), name);
    material_ = static_cast<int>(found - names.begin());
    if (found == names.end()) names.push_back(name);
  }

  static std::string trimmed(std::string_view text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    const std::size_t end = text.find_last_not_of(" \t");
    return std::string(text.substr(begin, end == std::string_view::npos ? 0 : end + 1 - begin));
  }

  /// The second number of "12/34/56", which counts as the first one does, from 0; -1 if there is none.
  long long placeOf(std::string_view corner) {
    const std::size_t slash = corner.find('/');
    if (slash == std::string_view::npos) return -1;
    const std::string_view rest = corner.substr(slash + 1);
    const std::string_view number = rest.substr(0, rest.find('/'));
    if (number.empty()) return -1;
    const auto known = static_cast<long long>(places_.size() / 2);
    long long id = 0;
    if (!parseNumber(number, id) || id == 0) refuse("a face has a corner that is no texture number");
    return id > 0 ? id - 1 : known + id;
  }

  void addFace(std::string_view line) {
    const long long points = static_cast<long long>(coordinates_.size() / 3);
    const std::size_t begin = faceIds_.size();
    for (std::string_view word = nextWord(line); !word.empty(); word = nextWord(line)) {
      long long id = 0;
      if (!parseNumber(word.substr(0, word.find('/')), id) || id == 0)
        refuse("a face has a corner that is no point number");
      faceIds_.push_back(id > 0 ? id - 1 : points + id);  // negative: counted back from the last point so far
      facePlaces_.push_back(placeOf(word));
    }
    faceMaterials_.push_back(material_);
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
    takePlaces();
    takeMaterials();
    return std::move(raw_);
  }

  void takePlaces() {
    const auto known = static_cast<long long>(places_.size() / 2);
    TextureCollector corners;
    for (std::size_t k = 0; k < faceIds_.size(); ++k) {
      const long long place = facePlaces_[k];
      if (place == -1) continue;
      if (place < 0 || place >= known)
        throw InputError(name_ + ": a face names texture coordinate " + std::to_string(place + 1) +
                         ", but there are " + std::to_string(known) + "; export it again");
      const std::size_t at = 2 * static_cast<std::size_t>(place);
      corners.put(faceIds_[k], places_[at], places_[at + 1]);
    }
    corners.finish(raw_.surface.size(), name_, raw_);
  }

  void takeMaterials() {
    if (raw_.materials.names.empty()) return;
    raw_.materials.ofPoint.assign(static_cast<std::size_t>(raw_.surface.size()), -1);
    std::size_t corner = 0;
    for (std::size_t f = 0; f < faceSizes_.size(); ++f)
      for (const std::size_t end = corner + faceSizes_[f]; corner < end; ++corner)
        if (int& own = raw_.materials.ofPoint[static_cast<std::size_t>(faceIds_[corner])]; own < 0)
          own = faceMaterials_[f];
  }

  const std::string& name_;
  std::size_t line_ = 0;
  RawSurface raw_;
  std::vector<double> coordinates_, colours_;
  std::vector<long long> faceIds_;  // faces may stand before their points
  std::vector<std::size_t> faceSizes_;
  std::vector<float> places_;          // u v of each vt line
  std::vector<long long> facePlaces_;  // by corner; -1: none
  std::vector<int> faceMaterials_;     // by face; -1: none
  int material_ = -1;
};

}  // namespace

RawSurface readObj(const std::string& text, const std::string& name) { return ObjReader(name).read(text); }

}  // namespace falciform
