#include "Logic/IO/SurfaceFiles.h"

#include <algorithm>
#include <cctype>

#include "Logic/Core/Errors.h"
#include "Logic/IO/DepthFrames.h"
#include "Logic/IO/ImageFiles.h"
#include "Logic/IO/SpaceAndUnits.h"
#include "Logic/IO/SurfaceFormats.h"
#include "Logic/IO/SurfaceTextures.h"

namespace falciform {

namespace {

std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

RawSurface readRaw(const std::filesystem::path& file, const std::string& name) {
  const std::string extension = extensionOf(file);
  if (!isSurfaceFile(file))
    throw InputError(
        "'" + name +
        "' has no surface extension; give .vtp, .vtk, .stl, .ply, .obj, .pcd, .xyz, .csv, .rgbd or a "
        ".png of depths");
  const std::string bytes = readTextFile(file);
  if (bytes.empty()) throw InputError(name + " is empty (0 bytes); copy or export it again");
  if (isDepthFrame(file)) return readDepthFrame(depthFrameBeside(file));
  if (extension == ".vtp") return readVtp(bytes, name);
  if (extension == ".vtk") return readLegacyVtk(bytes, name);
  if (extension == ".stl") return readStl(bytes, name);
  if (extension == ".ply") return readPly(bytes, name);
  if (extension == ".obj") return readObj(bytes, name);
  if (extension == ".pcd") return readPcd(bytes, name);
  return readCloudText(bytes, name);
}

void checkRead(const RawSurface& raw, const std::string& name) {
  if (raw.surface.size() == 0) throw InputError(name + " holds no points; export the surface again");
  checkSurface(raw.surface, name);
}

Loaded<Surface> checked(RawSurface raw, const std::string& name) {
  Surface& surface = raw.surface;
  const bool turned = honourSpace(surface.points, surface.frame, raw.space, name, raw.warnings);
  if (turned && surface.normals.rows() > 0) surface.normals.leftCols<2>() *= -1;
  checkRead(raw, name);
  checkUnits(surface.points, name, raw.warnings);
  return {std::move(raw.surface), std::move(raw.warnings)};
}

}  // namespace

Loaded<Surface> readSurface(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  RawSurface raw = readRaw(file, name);
  attachTexture(raw, file);
  return checked(std::move(raw), name);
}

Loaded<Surface> readSurface(const DepthFrameFiles& files) {
  return checked(readDepthFrame(files), files.depth.filename().string());
}

void writeSurface(const std::filesystem::path& file, const Surface& surface, Overwrite overwrite) {
  checkSurface(surface, file.filename().string());
  if (surface.size() == 0)
    throw InputError("the surface for '" + file.string() + "' has no points; there is nothing to write");
  const std::string extension = extensionOf(file);
  const bool textured = surface.texture && surface.textureAt.rows() > 0 && extension != ".stl";
  const std::vector<std::filesystem::path> beside =
      textured ? filesBeside(file) : std::vector<std::filesystem::path>{};
  std::string bytes;
  if (extension == ".vtp")
    bytes = vtpOf(surface);
  else if (extension == ".vtk")
    bytes = legacyVtkOf(surface);
  else if (extension == ".stl")
    bytes = stlOf(surface);
  else if (extension == ".ply")
    bytes = plyOf(surface, textured ? beside[0].filename().string() : "");
  else if (extension == ".obj")
    bytes = objOf(surface, textured ? beside[1].filename().string() : "");
  else
    throw InputError("cannot write a surface as '" + file.filename().string() +
                     "'; choose .vtp, .vtk, .stl, .ply or .obj");
  for (const auto& other : beside)
    if (overwrite == Overwrite::Refuse && std::filesystem::exists(other))
      throw InputError("'" + other.string() + "', the texture of '" + file.filename().string() +
                       "', exists; choose another name or give --force");
  writeTextFile(file, overwrite, bytes);
  if (!textured) return;
  writePng(beside[0], *surface.texture, overwrite);
  if (extension == ".obj")
    writeTextFile(beside[1], overwrite, "newmtl scan\nmap_Kd " + beside[0].filename().string() + "\n");
}

std::vector<std::filesystem::path> filesBeside(const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  std::vector<std::filesystem::path> files{file.parent_path() / (stem + "_texture.png")};
  if (extensionOf(file) == ".obj") files.push_back(file.parent_path() / (stem + ".mtl"));
  return files;
}

Surface scaled(const Surface& surface, double factor) {
  Surface result = surface;
  result.points *= factor;
  return result;
}

const std::vector<std::string>& surfaceExtensions() {
  static const std::vector<std::string> kExtensions{".vtp", ".vtk", ".stl", ".ply", ".obj",
                                                    ".pcd", ".xyz", ".csv", ".rgbd"};
  return kExtensions;
}

bool isSurfaceFile(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  const auto& known = surfaceExtensions();
  return std::find(known.begin(), known.end(), extension) != known.end() ||
         (extension == ".png" && isDepthImage(file));
}

}  // namespace falciform
