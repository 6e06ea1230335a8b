#include "Testing/Benchmarks/BenchCases.h"

#include <algorithm>
#include <stdexcept>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Logic/Acquisition/VirtualScanner.h"
#include "Logic/Geometry/KdTree.h"
#include "Logic/Geometry/Measures.h"
#include "Logic/Registration/PointRegistration.h"
#include "Modules/CommandLine/PhantomExperiment.h"
#include "Testing/Regression/UpdateCase.h"
#include "Testing/Support/RealData.h"

namespace falciform::bench {

namespace {

BenchCase rigidCase(std::string name, Surface preop, Surface scan, const Isometry3d& scanFromPreop) {
  BenchCase c;
  c.name = std::move(name);
  c.preop = std::move(preop);
  c.scan = std::move(scan);
  c.targetsPreop = c.preop.points;
  c.targetsScan = transformed(c.targetsPreop, scanFromPreop);
  c.bestRigid = scanFromPreop;
  c.limitMm = 5;  // the thesis's limit (ch. III)
  addNormals(c);
  return c;
}

}  // namespace

void addNormals(BenchCase& c) {
  const KdTree tree(c.preop.points);
  const Points normals = vertexNormals(c.preop), placed = transformed(c.scan.points, c.bestRigid.inverse());
  c.scan.normals.resize(c.scan.size(), 3);
  for (Index i = 0; i < c.scan.size(); ++i)
    c.scan.normals.row(i) =
        (c.bestRigid.linear() * normals.row(tree.nearest(placed.row(i).transpose()).index).transpose())
            .transpose();
}

double targetErrorMm(const BenchCase& c, const Isometry3d& scanFromPreop) {
  return targetErrors(c.targetsPreop, c.targetsScan, scanFromPreop).mean();
}

double apartFromBestMm(const BenchCase& c, const Isometry3d& scanFromPreop) {
  return targetErrors(c.targetsPreop, transformed(c.targetsPreop, c.bestRigid), scanFromPreop).mean();
}

BenchCase builtInCase() {
  Surface preop = makeSyntheticLiver({}).surface;
  VirtualScan seen = scanSurface(preop, {});
  BenchCase c = rigidCase("built-in liver", std::move(preop), std::move(seen.scan), seen.scanFromPreop);
  c.coverage = seen.coverage;
  return c;
}

BenchCase phantomCase() {
  commandline::PhantomExperiment made = commandline::makePhantomExperiment(thesisPhantom());
  return rigidCase("virtual phantom", std::move(made.preop), std::move(made.made.scan),
                   made.made.scanFromPreop);
}

std::optional<BenchCase> realCase(const std::string& name) {
  if (!std::filesystem::exists(test::realData() / "update" / name / "truth.json")) return {};
  test::UpdateCase read = test::readUpdateCase(name);
  BenchCase c;
  c.name = name;
  c.preop = std::move(read.preop);
  c.scan = std::move(read.scan);
  c.targetsPreop = std::move(read.targetsPreop);
  c.targetsScan = std::move(read.targetsScanner);
  c.bestRigid = fitRigid(c.targetsPreop, c.targetsScan);
  c.optimalMm = read.optimalRigidMm;
  c.limitMm = 1.4 * c.optimalMm + 0.5;
  c.coverage = read.coverage;
  addNormals(c);
  return c;
}

std::vector<OurMethod> ourMethods() {
  OurMethod both{"ours, two patches", {}}, one{"ours, one patch", {}}, none{"ours, auto", {}};
  one.settings.patches = {patch::kFalciform};
  none.settings.method = RegistrationMethod::Auto;
  return {both, one, none};
}

}  // namespace falciform::bench
