#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>

#include "Testing/Benchmarks/Peers.h"

namespace falciform::bench {

namespace {

pcl::PointCloud<pcl::PointXYZ>::Ptr cloudOf(const Points& points) {
  auto cloud = pcl::PointCloud<pcl::PointXYZ>::Ptr(new pcl::PointCloud<pcl::PointXYZ>);
  for (Index i = 0; i < points.rows(); ++i)
    cloud->emplace_back(static_cast<float>(points(i, 0)), static_cast<float>(points(i, 1)),
                        static_cast<float>(points(i, 2)));
  return cloud;
}

}  // namespace

Isometry3d pclIcp(const Surface& preop, const Surface& scan, int iterations) {
  pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ, double> icp;
  icp.setInputSource(cloudOf(scan.points));
  icp.setInputTarget(cloudOf(preop.points));
  icp.setMaximumIterations(iterations);
  icp.setTransformationEpsilon(1e-10);
  icp.setEuclideanFitnessEpsilon(1e-8);
  pcl::PointCloud<pcl::PointXYZ> moved;
  icp.align(moved);
  return Isometry3d(icp.getFinalTransformation());
}

}  // namespace falciform::bench
