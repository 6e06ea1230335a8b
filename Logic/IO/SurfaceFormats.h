#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "Logic/Core/Surface.h"

namespace falciform {

struct DepthFrameFiles;

// The formats behind readSurface and writeSurface, one function each. Inside Logic/IO only.

/// What an OBJ file says of its materials: their library, and which of them each point has.
struct ObjMaterials {
  std::string library;
  std::vector<std::string> names;
  std::vector<int> ofPoint;  ///< index into `names`, or -1; one a point, or empty
};

/// What stands in a file, before the space tag is honoured and the whole is checked.
struct RawSurface {
  Surface surface;
  std::optional<std::string> space;  ///< the tag as written, if there is one
  std::vector<std::string> warnings;
  std::string textureFile;  ///< the image that the file names for surface.textureAt; empty: none
  std::vector<int> seam;    ///< points with several places in the image, ascending
  ObjMaterials materials;
};

/// Readers take the whole file as text or bytes, `name` for messages, and throw InputError for damage.
[[nodiscard]] RawSurface readPly(const std::string& bytes, const std::string& name);
[[nodiscard]] RawSurface readObj(const std::string& text, const std::string& name);
[[nodiscard]] RawSurface readStl(const std::string& bytes, const std::string& name);
/// XYZ and CSV: one point a line.
[[nodiscard]] RawSurface readCloudText(const std::string& text, const std::string& name);
/// Point Cloud Library: ASCII, binary and compressed; organised clouds are joined.
[[nodiscard]] RawSurface readPcd(const std::string& bytes, const std::string& name);
[[nodiscard]] RawSurface readDepthFrame(const DepthFrameFiles& files);
[[nodiscard]] RawSurface readVtp(const std::string& bytes, const std::string& name);
[[nodiscard]] RawSurface readLegacyVtk(const std::string& bytes, const std::string& name);

/// Throws InputError where the counts and cells of a legacy file cannot be right: VTK's reader trusts them.
void checkLegacyVtk(const std::string& bytes, const std::string& name);

/// The same for the arrays of a VTP file, with its texts taken out (VtpFieldTexts.h).
void checkVtp(const std::string& bytes, const std::string& name);

/// Writers return the file's bytes.
/// Binary little endian, double precision; `textureFile`: named in a comment, empty: none.
[[nodiscard]] std::string plyOf(const Surface& surface, const std::string& textureFile);
/// Points in their order, 17 digits; `library`: of the material that names the texture, empty: none.
[[nodiscard]] std::string objOf(const Surface& surface, const std::string& library);
[[nodiscard]] std::string stlOf(const Surface& surface);  ///< binary, float precision; needs triangles
[[nodiscard]] std::string vtpOf(const Surface& surface);
[[nodiscard]] std::string legacyVtkOf(const Surface& surface);

/// "LPS" of "3D Slicer output. SPACE=LPS": the text after "SPACE=" up to the line's end or a semicolon; none
/// if not there.
[[nodiscard]] std::optional<std::string> spaceTagIn(std::string_view comment);
/// "SPACE=frame" for headers and comments: on one line, whatever the frame is called.
[[nodiscard]] std::string spaceTagOf(const Surface& surface);

}  // namespace falciform
