#include "Logic/IO/SurfaceTextures.h"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <optional>

#include "Logic/Core/Errors.h"
#include "Logic/IO/ImageFiles.h"
#include "Logic/IO/NumberText.h"

namespace falciform {

namespace {

namespace fs = std::filesystem;

/// `named` in a file: where it says, or, since files are moved without their folders, beside the file.
std::optional<fs::path> beside(const fs::path& file, std::string named) {
  std::replace(named.begin(), named.end(), '\\', '/');
  if (named.empty() || named.find('\0') != std::string::npos) return std::nullopt;
  const fs::path folder = file.parent_path(), as = fs::path(named);
  std::error_code ignored;
  if (as.is_relative() && fs::is_regular_file(folder / as, ignored)) return folder / as;
  if (fs::is_regular_file(folder / as.filename(), ignored)) return folder / as.filename();
  return std::nullopt;
}

std::optional<fs::path> ofSameName(const fs::path& file) {
  for (const char* ending : {"_texture.png", ".png", ".jpg", ".jpeg", ".PNG", ".JPG"})
    if (const auto found = beside(file, file.stem().string() + ending)) return found;
  return std::nullopt;
}

/// Image by material name, from an OBJ's library.
std::map<std::string, std::string> imagesOfMaterials(const fs::path& library) {
  std::map<std::string, std::string> images;
  const std::string text = readTextFile(library);
  TextCursor cursor(text);
  std::string material;
  for (std::string_view line; cursor.nextLine(line);) {
    const std::string_view keyword = nextWord(line);
    if (keyword == "newmtl") {
      material = nextWord(line);
    } else if (keyword == "map_Kd") {
      // Options such as -s 1 1 1 stand before the name, which is the last word.
      std::string_view last;
      for (std::string_view word = nextWord(line); !word.empty(); word = nextWord(line)) last = word;
      images[material] = last;
    }
  }
  return images;
}

class Attacher {
 public:
  Attacher(RawSurface& raw, const fs::path& file)
      : raw_(raw), surface_(raw.surface), file_(file), name_(file.filename().string()) {}

  void attach() {
    const std::map<std::string, std::string> images = materialImages();
    if (images.size() > 1 && !raw_.materials.ofPoint.empty()) return paintByMaterials(images);
    std::string named = images.empty() ? raw_.textureFile : images.begin()->second;
    auto image = beside(file_, named);
    if (!image) image = ofSameName(file_);
    // A material without an image says that there is none.
    if (!image && named.empty() && library_) return surface_.textureAt.resize(0, 2);
    if (!image)
      return drop(named.empty() ? "has texture coordinates, but no image " + file_.stem().string() +
                                      "_texture.png or " + file_.stem().string() + ".png stands beside it"
                                : "names the texture '" + named + "', which is not beside it");
    surface_.texture = load(*image);
    if (!surface_.texture) return surface_.textureAt.resize(0, 2);
    if (surface_.colours.rows() == 0) surface_.colours = coloursAt(*surface_.texture, surface_.textureAt);
    for (const int point : raw_.seam)
      surface_.textureAt.row(point).setConstant(std::numeric_limits<float>::quiet_NaN());
  }

 private:
  void drop(const std::string& why) {
    surface_.textureAt.resize(0, 2);
    raw_.warnings.push_back(name_ + " " + why);
  }

  /// A damaged picture is no reason to be without the shape.
  std::shared_ptr<const ColourImage> load(const fs::path& image) {
    try {
      return std::make_shared<const ColourImage>(readColourImage(image));
    } catch (const InputError& error) {
      raw_.warnings.push_back(name_ + " is read without its texture: " + error.what());
      return nullptr;
    }
  }

  std::map<std::string, std::string> materialImages() {
    std::map<std::string, std::string> images;
    const auto library = beside(file_, raw_.materials.library);
    library_ = library.has_value();
    if (!library) return images;
    const auto all = imagesOfMaterials(*library);
    for (const std::string& material : raw_.materials.names)
      if (const auto found = all.find(material); found != all.end()) images.insert(*found);
    // A library of one material serves files that do not say which they use.
    if (images.empty() && raw_.materials.names.empty() && all.size() == 1) images = all;
    return images;
  }

  void paintByMaterials(const std::map<std::string, std::string>& images) {
    if (surface_.colours.rows() > 0) {
      surface_.textureAt.resize(0, 2);
      return;
    }
    surface_.colours = Colours::Constant(surface_.size(), 3, 128);
    for (const auto& [material, named] : images) {
      const auto path = beside(file_, named);
      if (!path) {
        raw_.warnings.push_back(name_ + " names the texture '" + named + "', which is not beside it");
        continue;
      }
      const auto image = load(*path);
      if (!image) continue;
      const Colours colours = coloursAt(*image, surface_.textureAt);
      const auto own = std::find(raw_.materials.names.begin(), raw_.materials.names.end(), material) -
                       raw_.materials.names.begin();
      for (Index i = 0; i < surface_.size(); ++i)
        if (raw_.materials.ofPoint[static_cast<std::size_t>(i)] == own)
          surface_.colours.row(i) = colours.row(i);
    }
    surface_.textureAt.resize(0, 2);
    raw_.warnings.push_back(name_ + " has " + std::to_string(images.size()) +
                            " texture images; its points take their colours, and none is drawn as it is");
  }

  RawSurface& raw_;
  Surface& surface_;
  const fs::path& file_;
  const std::string name_;
  bool library_ = false;
};

}  // namespace

void attachTexture(RawSurface& raw, const fs::path& file) {
  if (raw.surface.textureAt.rows() == 0 || raw.surface.texture) return;  // none, or a depth frame's own
  if (raw.surface.textureAt.rows() != raw.surface.size()) return;        // checkSurface says what is wrong
  Attacher(raw, file).attach();
}

}  // namespace falciform
