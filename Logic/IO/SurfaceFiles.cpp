#include "Logic/IO/SurfaceFiles.h"

#include <algorithm>
#include <cctype>

#include "Logic/Core/Errors.h"
#include "Logic/IO/SpaceAndUnits.h"
#include "Logic/IO/SurfaceFormats.h"

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
  const auto& known = surfaceExtensions();
  if (std::find(known.begin(), known.end(), extension) == known.end())
    throw InputError("'" + name +
                     "' has no surface extension; give .vtp, .vtk, .stl, .ply, .obj, .xyz or .csv");
  const std::string bytes = readTextFile(file);
  if (bytes.empty()) throw InputError(name + " is empty (0 bytes); copy or export it again");
  if (extension == ".vtp") return readVtp(bytes, name);
  if (extension == ".vtk") return readLegacyVtk(bytes, name);
  if (extension == ".stl") return readStl(bytes, name);
  if (extension == ".ply") return readPly(bytes, name);
  if (extension == ".obj") return readObj(bytes, name);
  return readCloudText(bytes, name);
}

void checkRead(const RawSurface& raw, const std::string& name) {
  if (raw.surface.size() == 0) throw InputError(name + " holds no points; export the surface again");
  checkSurface(raw.surface, name);
}

}  // namespace

Loaded<Surface> readSurface(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  RawSurface raw = readRaw(file, name);
  Surface& surface = raw.surface;
  const bool turned = honourSpace(surface.points, surface.frame, raw.space, name, raw.warnings);
  if (turned && surface.normals.rows() > 0) surface.normals.leftCols<2>() *= -1;
  checkRead(raw, name);
  checkUnits(surface.points, name, raw.warnings);
  return {std::move(raw.surface), std::move(raw.warnings)};
}

void writeSurface(const std::filesystem::path& file, const Surface& surface, Overwrite overwrite) {
  checkSurface(surface, file.filename().string());
  if (surface.size() == 0)
    throw InputError("the surface for '" + file.string() + "' has no points; there is nothing to write");
  const std::string extension = extensionOf(file);
  if (extension == ".vtp")
    writeTextFile(file, overwrite, vtpOf(surface));
  else if (extension == ".vtk")
    writeTextFile(file, overwrite, legacyVtkOf(surface));
  else if (extension == ".stl")
    writeTextFile(file, overwrite, stlOf(surface));
  else if (extension == ".ply")
    writeTextFile(file, overwrite, plyOf(surface));
  else if (extension == ".obj")
    writeTextFile(file, overwrite, objOf(surface));
  else
    throw InputError("cannot write a surface as '" + file.filename().string() +
                     "'; choose .vtp, .vtk, .stl, .ply or .obj");
}

Surface scaled(const Surface& surface, double factor) {
  Surface result = surface;
  result.points *= factor;
  return result;
}

const std::vector<std::string>& surfaceExtensions() {
  static const std::vector<std::string> kExtensions{".vtp", ".vtk", ".stl", ".ply", ".obj", ".xyz", ".csv"};
  return kExtensions;
}

}  // namespace falciform
