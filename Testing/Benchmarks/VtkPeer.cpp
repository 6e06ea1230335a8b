#include <vtkIterativeClosestPointTransform.h>
#include <vtkLandmarkTransform.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include "Logic/VtkBridge/PolyDataBridge.h"
#include "Testing/Benchmarks/Peers.h"

namespace falciform::bench {

Isometry3d vtkIcp(const Surface& preop, const Surface& scan) {
  const auto target = toVtk(preop), source = toVtk(scan);
  vtkNew<vtkIterativeClosestPointTransform> icp;
  icp->SetSource(source);
  icp->SetTarget(target);
  icp->GetLandmarkTransform()->SetModeToRigidBody();
  icp->SetMaximumNumberOfLandmarks(static_cast<int>(scan.size()));
  icp->SetMaximumNumberOfIterations(1000);
  icp->CheckMeanDistanceOn();
  icp->SetMaximumMeanDistance(1e-4);
  icp->Update();
  Isometry3d pose;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) pose.matrix()(r, c) = icp->GetMatrix()->GetElement(r, c);
  return pose;
}

}  // namespace falciform::bench
