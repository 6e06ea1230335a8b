#include "Testing/Benchmarks/Open3dPeer.h"

#include <open3d/geometry/PointCloud.h>
#include <open3d/pipelines/registration/CorrespondenceChecker.h>
#include <open3d/pipelines/registration/FastGlobalRegistration.h>
#include <open3d/pipelines/registration/Feature.h>
#include <open3d/pipelines/registration/Registration.h>
#include <open3d/pipelines/registration/TransformationEstimation.h>
#include <open3d/utility/Logging.h>
#include <open3d/utility/Random.h>

#include "Logic/Geometry/Measures.h"

namespace falciform::bench {

namespace {

namespace geometry = open3d::geometry;
namespace registration = open3d::pipelines::registration;

constexpr double kIcpReachMm = 7.5;

geometry::PointCloud cloudOf(const Points& points, const Points& normals) {
  geometry::PointCloud cloud;
  cloud.points_.reserve(static_cast<std::size_t>(points.rows()));
  for (Index i = 0; i < points.rows(); ++i) cloud.points_.emplace_back(points.row(i).transpose());
  for (Index i = 0; i < normals.rows(); ++i) cloud.normals_.emplace_back(normals.row(i).transpose());
  return cloud;
}

struct Prepared {
  std::shared_ptr<geometry::PointCloud> cloud;
  std::shared_ptr<registration::Feature> feature;
};

Prepared prepare(const geometry::PointCloud& all, double voxelMm) {
  Prepared prepared;
  prepared.cloud = all.VoxelDownSample(voxelMm);
  prepared.cloud->EstimateNormals(geometry::KDTreeSearchParamHybrid(2 * voxelMm, 30));
  prepared.feature =
      registration::ComputeFPFHFeature(*prepared.cloud, geometry::KDTreeSearchParamHybrid(5 * voxelMm, 100));
  return prepared;
}

Isometry3d poseOf(const registration::RegistrationResult& result) {
  return Isometry3d(Matrix4d(result.transformation_));
}

}  // namespace

struct Open3dTarget::Clouds {
  geometry::PointCloud all;  // with the mesh's normals
  Prepared coarse;
};

Open3dTarget::Open3dTarget(const Surface& preop, double voxelMm) : voxelMm_(voxelMm) {
  open3d::utility::SetVerbosityLevel(open3d::utility::VerbosityLevel::Error);
  auto clouds = std::make_unique<Clouds>();
  clouds->all = cloudOf(preop.points, vertexNormals(preop));
  clouds->coarse = prepare(clouds->all, voxelMm_);
  clouds_ = std::move(clouds);
}

Open3dTarget::~Open3dTarget() = default;

Isometry3d Open3dTarget::ransac(const Surface& scan, int seed) const {
  open3d::utility::random::Seed(seed);
  const Prepared source = prepare(cloudOf(scan.points, scan.normals), voxelMm_);
  const double reach = 1.5 * voxelMm_;
  const registration::CorrespondenceCheckerBasedOnEdgeLength edges(0.9);
  const registration::CorrespondenceCheckerBasedOnDistance distances(reach);
  const auto found = registration::RegistrationRANSACBasedOnFeatureMatching(
      *source.cloud, *clouds_->coarse.cloud, *source.feature, *clouds_->coarse.feature, true, reach,
      registration::TransformationEstimationPointToPoint(false), 3, {edges, distances},
      registration::RANSACConvergenceCriteria(100000, 0.999));
  return icp(scan, poseOf(found), 30, kIcpReachMm);
}

Isometry3d Open3dTarget::fgr(const Surface& scan) const {
  const Prepared source = prepare(cloudOf(scan.points, scan.normals), voxelMm_);
  registration::FastGlobalRegistrationOption option;
  option.maximum_correspondence_distance_ = 0.5 * voxelMm_;
  const auto found = registration::FastGlobalRegistrationBasedOnFeatureMatching(
      *source.cloud, *clouds_->coarse.cloud, *source.feature, *clouds_->coarse.feature, option);
  return icp(scan, poseOf(found), 30, kIcpReachMm);
}

Isometry3d Open3dTarget::icp(const Surface& scan, const Isometry3d& preopFromScan, int iterations,
                             double reachMm) const {
  return poseOf(registration::RegistrationICP(cloudOf(scan.points, {}), clouds_->all, reachMm,
                                              preopFromScan.matrix(),
                                              registration::TransformationEstimationPointToPlane(),
                                              registration::ICPConvergenceCriteria(1e-6, 1e-6, iterations)));
}

}  // namespace falciform::bench
