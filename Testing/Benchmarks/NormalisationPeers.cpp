#include "Testing/Benchmarks/NormalisationPeers.h"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>

#include "Logic/Core/Volume.h"
#include "Logic/Geometry/VolumeSampling.h"
#include "Logic/IO/OutputFile.h"
#include "Logic/IO/VolumeFiles.h"
#include "Testing/Benchmarks/ChildProcess.h"

namespace falciform::bench {

namespace fs = std::filesystem;

namespace {

void writeField(const fs::path& file, const GridField& field) {
  Image image{field.counts, Matrix4d::Identity(), field.values};
  image.worldFromIndex.topLeftCorner<3, 3>() *= field.cellMm;
  image.worldFromIndex.topRightCorner<3, 1>() = field.origin;
  writeImage(file, image, Overwrite::Replace);
}

void writeImages(const GridField& target, const GridField& source, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  writeField(folder / "target.mha", target);
  writeField(folder / "source.mha", source);
}

constexpr char kElastixCommon[] = R"((FixedInternalImagePixelType "float")
(MovingInternalImagePixelType "float")
(FixedImageDimension 3)
(MovingImageDimension 3)
(UseDirectionCosines "true")
(Registration "MultiResolutionRegistration")
(Interpolator "LinearInterpolator")
(ResampleInterpolator "FinalBSplineInterpolator")
(Resampler "DefaultResampler")
(FixedImagePyramid "FixedSmoothingImagePyramid")
(MovingImagePyramid "MovingSmoothingImagePyramid")
(Optimizer "AdaptiveStochasticGradientDescent")
(Metric "AdvancedMeanSquares")
(HowToCombineTransforms "Compose")
(NumberOfResolutions 4)
(ImageSampler "RandomCoordinate")
(NewSamplesEveryIteration "true")
(NumberOfSpatialSamples 5000)
(DefaultPixelValue 8)
(WriteResultImage "false")
(AutomaticTransformInitialization "true")
)";

Points readPoints(const fs::path& file, Index count) {
  std::ifstream in(file);
  Points points(count, 3);
  Index row = 0;
  for (std::string line; std::getline(in, line) && row < count;) {
    const std::size_t at = line.find("OutputPoint = [");
    if (at == std::string::npos) continue;
    std::istringstream values(line.substr(at + std::strlen("OutputPoint = [")));
    values >> points(row, 0) >> points(row, 1) >> points(row, 2);
    ++row;
  }
  return row == count ? points : Points();
}

/// The displacement field that plastimatch writes: MetaImage, three floats a voxel, uncompressed.
std::optional<DisplacementGrid> readField(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  DisplacementGrid grid;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string key, equals;
    words >> key >> equals;
    if (key == "DimSize") words >> grid.size.x() >> grid.size.y() >> grid.size.z();
    if (key == "Offset")
      for (int a = 0; a < 3; ++a) words >> grid.worldFromIndex(a, 3);
    if (key == "ElementSpacing")
      for (int a = 0; a < 3; ++a) words >> grid.worldFromIndex(a, a);
    if (key == "ElementDataFile") break;
  }
  if (!in || grid.size.prod() <= 0) return std::nullopt;
  grid.voxels.resize(static_cast<std::size_t>(grid.size.cast<Index>().prod()));
  in.read(reinterpret_cast<char*>(grid.voxels.data()),
          static_cast<std::streamsize>(grid.voxels.size() * sizeof(Eigen::Vector3f)));
  return in ? std::optional(std::move(grid)) : std::nullopt;
}

bool installed(const char* program) {
  return std::system((std::string("command -v ") + program + " > /dev/null 2>&1").c_str()) == 0;
}

}  // namespace

std::optional<PeerMap> elastix(const GridField& target, const GridField& source, const Points& places,
                               const fs::path& folder) {
  if (!installed("elastix")) return std::nullopt;
  writeImages(target, source, folder);
  std::ofstream(folder / "affine.txt") << kElastixCommon << "(Transform \"AffineTransform\")\n"
                                       << "(MaximumNumberOfIterations 300)\n";
  std::ofstream(folder / "spline.txt") << kElastixCommon << "(Transform \"BSplineTransform\")\n"
                                       << "(FinalGridSpacingInPhysicalUnits 8)\n"
                                       << "(MaximumNumberOfIterations 500)\n";
  PeerMap map;
  const ChildRun run = runChild({"elastix", "-f", "target.mha", "-m", "source.mha", "-p", "affine.txt", "-p",
                                 "spline.txt", "-out", "."},
                                folder);
  map.wallS = run.wallS;
  if (run.exitCode != 0) return std::nullopt;
  {
    std::ofstream points(folder / "points.txt");
    points.precision(9);
    points << "point\n" << places.rows() << "\n";
    for (Index i = 0; i < places.rows(); ++i)
      points << places(i, 0) << " " << places(i, 1) << " " << places(i, 2) << "\n";
  }
  if (runChild({"transformix", "-def", "points.txt", "-tp", "TransformParameters.1.txt", "-out", "."}, folder)
          .exitCode != 0)
    return std::nullopt;
  map.toSource = readPoints(folder / "outputpoints.txt", places.rows());
  return map.toSource.rows() > 0 ? std::optional(std::move(map)) : std::nullopt;
}

std::optional<PeerMap> plastimatch(const GridField& target, const GridField& source, const Points& places,
                                   const fs::path& folder) {
  if (!installed("plastimatch")) return std::nullopt;
  writeImages(target, source, folder);
  {
    std::ofstream command(folder / "command.txt");
    command << "[GLOBAL]\nfixed=target.mha\nmoving=source.mha\nvf_out=field.mha\ndefault_value=8\n"
            << "[STAGE]\nxform=align_center\n[STAGE]\nxform=affine\noptim=versor\nmax_its=50\nres=4 4 4\n";
    const char* stages[][2] = {{"30 30 30", "4 4 4"}, {"15 15 15", "2 2 2"}, {"8 8 8", "1 1 1"}};
    for (const auto& stage : stages)
      command << "[STAGE]\nxform=bspline\noptim=lbfgsb\nimpl=plastimatch\nmetric=mse\nmax_its=50\n"
              << "threading=openmp\ngrid_spac=" << stage[0] << "\nres=" << stage[1] << "\n";
  }
  PeerMap map;
  const ChildRun run = runChild({"plastimatch", "register", "command.txt"}, folder);
  map.wallS = run.wallS;
  const std::optional<DisplacementGrid> field = readField(folder / "field.mha");
  if (run.exitCode != 0 || !field) return std::nullopt;
  const Matrix4d indexFromWorld = field->worldFromIndex.inverse();
  map.toSource.resize(places.rows(), 3);
  for (Index i = 0; i < places.rows(); ++i) {
    const Vector3d place = places.row(i).transpose();
    map.toSource.row(i) =
        (place + displacementAt(*field, (indexFromWorld * place.homogeneous()).head<3>())).transpose();
  }
  return map;
}

}  // namespace falciform::bench
