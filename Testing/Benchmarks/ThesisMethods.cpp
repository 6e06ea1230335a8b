#include "Testing/Benchmarks/ThesisMethods.h"

#include "Logic/Geometry/Sampling.h"

namespace falciform::bench {
namespace {

Isometry3d thesisStart(RegistrationMethod method, const ReadyLiver& liver, const UpdateTrial& trial) {
  RegistrationSettings settings = registrationPreset("thesis-phantom");
  settings.method = method;
  settings.patches = {patch::kFalciform};
  return registerSurfaces(liver.rigid(), trial.scan, settings, trial.scanFromPreop).scanFromPreop;
}

}  // namespace

/// The fit looks at a liver near the scan by its load centres, and lets loads under the scan weigh less: so
/// centres without loads lie all over the surface, and the modes', which press nowhere, in the middle.
LoadResponses modesAsLoads(const Atlas& atlas, const Surface& preop) {
  const std::vector<int> spread = spreadSample(preop.points, 120);
  const Index rank = atlas.rank(), own = (rank + 2) / 3,  // three rows a centre
      centres = own + static_cast<Index>(spread.size());
  LoadResponses loads;
  loads.mesh = atlas.mesh;
  loads.centres.resize(centres, 3);
  loads.centres.topRows(own).rowwise() = atlas.mesh.points.colwise().mean();
  loads.centres.bottomRows(centres - own) = rowsOf(preop.points, spread);
  loads.responses = Eigen::MatrixXf::Zero(3 * centres, 3 * atlas.mesh.nodes());
  loads.rmsMm = VectorXd::Zero(3 * centres);
  for (Index k = 0; k < rank; ++k) {
    const Points& mode = atlas.modes[static_cast<std::size_t>(k)];
    loads.responses.row(k) = Eigen::Map<const Eigen::RowVectorXd>(mode.data(), mode.size()).cast<float>();
    loads.rmsMm[k] = 1;
  }
  return loads;
}

Points placesNow(const TetrahedralMesh& mesh, const UpdateResult& update, const Points& preopMm) {
  return transformed(preopMm + Points(MeshPlaces(mesh, preopMm).interpolate(update.displacements)),
                     update.scanFromPreop);
}

ThesisMethods::ThesisMethods(const Surface& preop, std::shared_ptr<const Atlas> atlas)
    : atlas_(std::move(atlas)),
      icat_(UpdateMethod::Icat, preop, atlas_),
      icatStar_(UpdateMethod::IcatStar, preop, atlas_),
      own_(preop, modesAsLoads(*atlas_, preop)) {}

MethodOutcome ThesisMethods::update(UpdateMethod method, const UpdateTrial& trial,
                                    const Isometry3d& scanFromPreop, const UpdateSettings& own) const {
  MethodOutcome done;
  done.rigid = figuresOf(transformed(trial.before, scanFromPreop), trial.after);
  done.update =
      method == UpdateMethod::Loads
          ? updateModel(own_, trial.scan, scanFromPreop, own)
          : updateByMethod(method == UpdateMethod::Icat ? icat_ : icatStar_, trial.scan, scanFromPreop);
  done.places = placesNow(atlas_->mesh, done.update, trial.before);
  done.updatedMm = (done.places - trial.after).rowwise().norm();
  done.updated = figuresOf(done.updatedMm);
  return done;
}

Isometry3d ThesisMethods::icp(const ReadyLiver& liver, const UpdateTrial& trial) const {
  return thesisStart(RegistrationMethod::Icp, liver, trial);
}

Isometry3d ThesisMethods::picp(const ReadyLiver& liver, const UpdateTrial& trial) const {
  return thesisStart(RegistrationMethod::Picp, liver, trial);
}

}  // namespace falciform::bench
