#include "Testing/Benchmarks/MetricPeers.h"

#include <vtkCellLocator.h>
#include <vtkCurvatures.h>
#include <vtkDoubleArray.h>
#include <vtkGenericCell.h>
#include <vtkImplicitPolyDataDistance.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

#include "Logic/VtkBridge/PolyDataBridge.h"

#ifdef FALCIFORM_BENCH_CGAL
#include "Testing/Benchmarks/CgalPeer.h"
#endif

namespace falciform::bench {

struct MeshDistancePeers::Trees {
  vtkSmartPointer<vtkPolyData> mesh;
  vtkNew<vtkImplicitPolyDataDistance> implicit;
  vtkNew<vtkCellLocator> locator;
#ifdef FALCIFORM_BENCH_CGAL
  std::unique_ptr<CgalTree> cgal;
#endif
};

MeshDistancePeers::MeshDistancePeers(const Surface& mesh) : trees_(std::make_unique<Trees>()) {
  trees_->mesh = toVtk(mesh);
  trees_->implicit->SetInput(trees_->mesh);
  trees_->locator->SetDataSet(trees_->mesh);
  trees_->locator->BuildLocator();
#ifdef FALCIFORM_BENCH_CGAL
  trees_->cgal = std::make_unique<CgalTree>(mesh);
#endif
}

MeshDistancePeers::~MeshDistancePeers() = default;

std::vector<MetricPeer> MeshDistancePeers::all() const {
  const Trees* trees = trees_.get();
  std::vector<MetricPeer> list;
  // VTK's two keep scratch for all callers: asked by two threads at once they answer wrongly.
  list.push_back({"vtkImplicitPolyDataDistance",
                  [trees](const Points& queries) {
                    VectorXd values(queries.rows());
                    for (Index i = 0; i < queries.rows(); ++i)
                      values[i] =
                          trees->implicit->EvaluateFunction(queries(i, 0), queries(i, 1), queries(i, 2));
                    return values;
                  },
                  false});
  list.push_back({"vtkCellLocator, no sign",
                  [trees](const Points& queries) {
                    VectorXd values(queries.rows());
                    vtkNew<vtkGenericCell> cell;
                    for (Index i = 0; i < queries.rows(); ++i) {
                      double at[3] = {queries(i, 0), queries(i, 1), queries(i, 2)}, closest[3], squared = 0;
                      vtkIdType id = -1;
                      int part = 0;
                      trees->locator->FindClosestPoint(at, closest, cell, id, part, squared);
                      values[i] = std::sqrt(squared);
                    }
                    return values;
                  },
                  false});
#ifdef FALCIFORM_BENCH_CGAL
  list.push_back({"CGAL AABB tree, no sign",
                  [trees](const Points& queries) { return trees->cgal->distances(queries); }, true});
#endif
  return list;
}

std::vector<MetricPeer> curvaturePeers(const Surface& surface) {
  std::vector<MetricPeer> list;
  list.push_back({"vtkCurvatures",
                  [mesh = toVtk(surface)](const Points&) {
                    vtkNew<vtkCurvatures> curvatures;
                    curvatures->SetInputData(mesh);
                    curvatures->SetCurvatureTypeToMean();
                    curvatures->Update();
                    vtkDataArray* mean = curvatures->GetOutput()->GetPointData()->GetArray("Mean_Curvature");
                    VectorXd values(mean->GetNumberOfTuples());
                    for (Index i = 0; i < values.size(); ++i) values[i] = mean->GetTuple1(i);
                    return values;
                  },
                  false});
#ifdef FALCIFORM_BENCH_CGAL
  list.push_back({"CGAL jets of the same neighbours",
                  [&surface](const Points&) { return cgalJetCurvature(surface); }, true});
#endif
  return list;
}

}  // namespace falciform::bench
