#include "Logic/IO/SurfaceFiles.h"

#include <algorithm>
#include <cctype>

#include "Logic/Core/Errors.h"
#include "Logic/IO/NumberText.h"
#include "Logic/IO/SurfaceFormats.h"

namespace falciform {

namespace {

constexpr double kAbsurdMm = 1e6;   ///< no operating theatre is a kilometre wide
constexpr double kMetresBelow = 1;  ///< a liver of 0.2 units is in metres
constexpr double kMicrometresAbove = 20'000;

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

/// World is LPS: RAS is turned by 180 degrees about the third axis, which keeps the triangles' sense.
void honourSpace(RawSurface& raw, const std::string& name) {
  Surface& surface = raw.surface;
  surface.frame = raw.space.value_or("LPS");
  if (!raw.space)
    raw.warnings.push_back(
        name + " does not say its space; LPS is assumed (SPACE=LPS or SPACE=RAS in the file says it)");
  if (surface.frame != "RAS") return;
  surface.points.leftCols<2>() *= -1;
  if (surface.normals.rows() > 0) surface.normals.leftCols<2>() *= -1;
  surface.frame = "LPS";
}

void checkRead(const RawSurface& raw, const std::string& name) {
  const Surface& surface = raw.surface;
  if (surface.size() == 0) throw InputError(name + " holds no points; export the surface again");
  checkSurface(surface, name);
  if (const double largest = surface.points.cwiseAbs().maxCoeff(); largest > kAbsurdMm)
    throw InputError(name + " has a coordinate of " + numberText(largest) +
                     " mm, beyond 1e6 mm; it is damaged or in other units, export it again in mm");
}

void warnOfUnits(RawSurface& raw, const std::string& name) {
  const Surface& surface = raw.surface;
  const double extent =
      (surface.points.colwise().maxCoeff() - surface.points.colwise().minCoeff()).maxCoeff();
  const std::string size = name + " is " + numberText(static_cast<float>(extent)) + " units wide: ";
  if (surface.size() < 2) return;
  if (extent < kMetresBelow)
    raw.warnings.push_back(size + "it looks like metres, not mm; scale it by 1000 if so");
  if (extent > kMicrometresAbove)
    raw.warnings.push_back(size + "it looks like micrometres, not mm; scale it by 0.001 if so");
}

}  // namespace

Loaded<Surface> readSurface(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  RawSurface raw = readRaw(file, name);
  honourSpace(raw, name);
  checkRead(raw, name);
  warnOfUnits(raw, name);
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
