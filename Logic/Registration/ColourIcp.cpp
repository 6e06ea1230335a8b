#include "Logic/Registration/ColourIcp.h"

#include <cmath>
#include <flann/flann.hpp>

#include "Logic/Core/Errors.h"
#include "Logic/Core/Parallel.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Registration/ClosestPointLoop.h"

namespace falciform {

namespace {

constexpr double kLightnessShare = 0.1;  // shading differs between a CT's rendering, a lamp and a laser
constexpr double kColourShare = 0.3;     // of the RMS radius, for one standard deviation of colour

/// N x 3 YIQ (NTSC), lightness scaled down.
Points yiqOf(const Colours& colours) {
  Matrix3d fromRgb;
  fromRgb << 0.299, 0.587, 0.114, 0.596, -0.274, -0.322, 0.211, -0.523, 0.312;
  fromRgb.row(0) *= kLightnessShare;
  return colours.cast<double>() / 255 * fromRgb.transpose();
}

/// Root mean square distance of the rows from their mean.
double spreadOf(const Points& points) {
  const Eigen::RowVector3d middle = centroid(points).transpose();
  return std::sqrt((points.rowwise() - middle).rowwise().squaredNorm().mean());
}

using Places = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>;

/// FLANN reads through a pointer that is not const and changes nothing.
flann::Matrix<double> viewOf(Places& places, std::size_t begin, std::size_t end) {
  return {places.data() + 6 * begin, end - begin, 6};
}

void needColours(const Surface& surface, const std::string& what) {
  if (surface.colours.rows() != surface.size() || surface.size() == 0)
    throw InputError(what +
                     " has no colours and the method is colour; give one with red, green and blue a "
                     "point (PLY, VTP), or choose another method");
}

}  // namespace

PatchIcpResult registerColourIcp(const PreparedPreop& preop, const Surface& scan,
                                 const RegistrationSettings& settings, const Isometry3d& start,
                                 const Progress& progress, const IterationObserver& observer) {
  needColours(preop.surface(), "pre-op surface");
  needColours(scan, "scan");
  const Points& points = preop.surface().points;
  const Points colours = yiqOf(preop.surface().colours);
  const double spread = spreadOf(colours);
  // Where all is of one colour, colour says nothing and this is plain ICP.
  const double millimetresPerColour = spread > 1e-9 ? kColourShare * spreadOf(points) / spread : 0;
  Places target(points.rows(), 6), query(scan.size(), 6);
  target << points, millimetresPerColour * colours;
  query.rightCols<3>() = millimetresPerColour * yiqOf(scan.colours);
  flann::KDTreeSingleIndex<flann::L2<double>> tree(viewOf(target, 0, static_cast<std::size_t>(target.rows())),
                                                   flann::KDTreeSingleIndexParams(10));
  tree.buildIndex();

  const MatchPoints match = [&](const Points& moved, Points& matched) {
    query.leftCols<3>() = moved;
    matched.resize(moved.rows(), 3);
    forEachChunk(static_cast<std::size_t>(moved.rows()), 256, [&](std::size_t begin, std::size_t end) {
      std::vector<std::size_t> found(end - begin);
      std::vector<double> squared(end - begin);
      flann::Matrix<std::size_t> ids(found.data(), end - begin, 1);
      flann::Matrix<double> distances(squared.data(), end - begin, 1);
      tree.knnSearch(viewOf(query, begin, end), ids, distances, 1,
                     flann::SearchParams(flann::FLANN_CHECKS_UNLIMITED));
      for (std::size_t i = begin; i < end; ++i)
        matched.row(static_cast<Index>(i)) = points.row(static_cast<Index>(found[i - begin]));
    });
  };
  return runClosestPointLoop(scan.points, match, settings, start, progress, observer);
}

}  // namespace falciform
