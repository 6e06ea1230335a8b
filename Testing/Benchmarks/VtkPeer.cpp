#include <vtkIterativeClosestPointTransform.h>
#include <vtkLandmarkTransform.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticPointLocator.h>

#include "Logic/Core/Parallel.h"
#include "Logic/VtkBridge/PolyDataBridge.h"
#include "Testing/Benchmarks/Peers.h"

namespace falciform::bench {

Isometry3d vtkIcp(const Surface& preop, const Surface& scan, int iterations) {
  const auto target = toVtk(preop), source = toVtk(scan);
  vtkNew<vtkIterativeClosestPointTransform> icp;
  icp->SetSource(source);
  icp->SetTarget(target);
  icp->GetLandmarkTransform()->SetModeToRigidBody();
  icp->SetMaximumNumberOfLandmarks(2000);
  icp->SetMaximumNumberOfIterations(iterations);
  icp->CheckMeanDistanceOn();
  icp->SetMaximumMeanDistance(1e-4);
  icp->Update();
  Isometry3d pose;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) pose.matrix()(r, c) = icp->GetMatrix()->GetElement(r, c);
  return pose;
}

struct VtkNeighbours::Locator {
  vtkSmartPointer<vtkPolyData> data;
  vtkNew<vtkStaticPointLocator> locator;
};

VtkNeighbours::VtkNeighbours(const Points& points) {
  auto made = std::make_unique<Locator>();
  Surface cloud;
  cloud.points = points;
  made->data = toVtk(cloud);
  made->locator->SetDataSet(made->data);
  made->locator->BuildLocator();
  locator_ = std::move(made);
}

VtkNeighbours::~VtkNeighbours() = default;

void VtkNeighbours::nearest(const Points& queries, std::vector<int>& rows) const {
  forEachChunk(rows.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      rows[i] = static_cast<int>(locator_->locator->FindClosestPoint(queries.data() + 3 * i));
  });
}

}  // namespace falciform::bench
