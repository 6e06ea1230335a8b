#include "Logic/Atlas/ModelUpdateLogic.h"

#include <utility>

#include "Logic/Atlas/LoadFiles.h"
#include "Logic/Atlas/ScanNext.h"
#include "Logic/Atlas/UpdateMethods.h"
#include "Logic/Biomechanics/LiverMesh.h"
#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

bool sameShape(const std::shared_ptr<const Surface>& a, const std::shared_ptr<const Surface>& b) {
  return a && b && (a == b || (a->points.rows() == b->points.rows() && a->points == b->points));
}

bool hasItsArrays(const Surface& updated) {
  for (const char* array : {kDisplacement, kAgainstRigid, kExpectedError, kScanGain})
    if (!updated.arrays.contains(array)) return false;
  return true;
}

}  // namespace

ModelUpdateLogic::ModelUpdateLogic(Case& document) : case_(document) {
  watching_ = case_.changed.connect([this](Case::Part part) {
    if (part == Case::Part::Update) takeKept();
    if (part != Case::Part::Preop) return;
    if (model_ && !(case_.preop() && model_->preop().points.rows() == case_.preop()->points.rows() &&
                    model_->preop().points == case_.preop()->points))
      model_.reset();
    if (result_ && !sameShape(result_->preop, case_.preop())) result_.reset();
  });
}

std::string ModelUpdateLogic::missingForModel() const {
  if (!case_.preop() || case_.preop()->size() == 0) return "Import or open the pre-operative surface first.";
  if (case_.preop()->triangles.rows() == 0)
    return "The pre-operative surface has no triangles: import it from a label map, or open a closed "
           "surface.";
  return {};
}

std::function<ModelUpdateLogic::Model(const Progress&)> ModelUpdateLogic::prepareModel() const {
  if (const std::string missing = missingForModel(); !missing.empty()) throw InputError(missing);
  preparing_ = settingsToJson(mesh).dump();
  return [preop = case_.preop(), with = mesh](const Progress& progress) -> Model {
    const LiverMesh made = meshLiver(*preop, {}, with, progress.part(0, 0.3));
    LoadResponses responses = solveSurfaceLoads(made.mesh, {Material{}}, {}, progress.part(0.3, 0.95));
    progress.report(0.95, "Preparing the surface");
    return std::make_shared<const UpdateModel>(*preop, std::move(responses));
  };
}

std::function<ModelUpdateLogic::Model(const Progress&)> ModelUpdateLogic::prepareModel(
    const std::filesystem::path& atlas) const {
  if (const std::string missing = missingForModel(); !missing.empty()) throw InputError(missing);
  preparing_.clear();  // no settings made it
  return [preop = case_.preop(), atlas](const Progress& progress) -> Model {
    progress.report(0, "Reading the atlas");
    const bool solved = atlasKindOf(atlas) == AtlasKind::SurfaceLoads;
    LoadResponses responses;
    if (solved)
      responses = readLoadAtlas(atlas).atlas.loads;
    else
      responses.mesh = readAtlas(atlas).atlas.mesh;
    checkSameLiver(responses.mesh, *preop);
    if (!solved) responses = solveSurfaceLoads(responses.mesh, {Material{}}, {}, progress.part(0.3, 0.95));
    progress.report(0.95, "Preparing the surface");
    return std::make_shared<const UpdateModel>(*preop, std::move(responses));
  };
}

bool ModelUpdateLogic::acceptModel(Model model) {
  if (!model || !case_.preop() || model->preop().points.rows() != case_.preop()->points.rows() ||
      model->preop().points != case_.preop()->points)
    return false;
  model_ = std::move(model);
  preparedWith_ = preparing_;
  return true;
}

bool ModelUpdateLogic::modelOutdated() const {
  return model_ && !preparedWith_.empty() && preparedWith_ != settingsToJson(mesh).dump();
}

std::string ModelUpdateLogic::missingInput() const {
  if (std::string missing = missingForModel(); !missing.empty()) return missing;
  if (!case_.scan() || case_.scan()->size() == 0) return "Open an intra-operative scan first.";
  if (!case_.registration()) return "Register the scan first (step 3): the update starts from that pose.";
  if (case_.registrationStale())
    return "Surface, scan or patches changed since the registration: register again (step 3).";
  if (!model_) return "Prepare the model first.";
  return {};
}

std::function<ModelUpdateLogic::Result(const Progress&)> ModelUpdateLogic::prepare() const {
  if (const std::string missing = missingInput(); !missing.empty()) throw InputError(missing);
  updating_ = settingsToJson(settings).dump();
  CasePlaces places{case_.preop(),      case_.scan(),    case_.registration(),
                    case_.structures(), case_.targets(), case_.truthTargets()};
  return [places = std::move(places), model = model_, with = settings, draw = seed,
          watch = observer](const Progress& progress) -> Result {
    // Painting changes patches and not the shape: the fit pulls patches as they are painted now.
    auto used = model;
    if (places.preop->patch != model->preop().patch)
      used = std::make_shared<const UpdateModel>(*places.preop, model->responses());
    UpdateResult update = updateModel(*used, *places.scan, places.registration->scanFromPreop, with, draw,
                                      progress.part(0, 0.6), watch);
    return std::make_shared<const UpdatedCase>(
        moveCase(places, std::move(used), std::move(update), progress.part(0.6, 1)));
  };
}

bool ModelUpdateLogic::accept(Result result) {
  if (!result || !sameShape(result->preop, case_.preop())) return false;
  result_ = std::move(result);
  updatedWith_ = updating_;
  kept_ = std::make_shared<const KeptUpdate>(keptOf(*result_));
  case_.setUpdate(kept_);
  return true;
}

// A case was opened, or is gone: its update is the result now.
void ModelUpdateLogic::takeKept() {
  const auto& kept = case_.update();
  if (kept == kept_) return;
  kept_ = kept;
  result_.reset();
  const bool whole = kept && kept->surface && case_.preop() && case_.scan() && case_.registration() &&
                     kept->surface->size() == case_.preop()->size() && hasItsArrays(*kept->surface);
  if (whole) result_ = std::make_shared<const UpdatedCase>(updatedFrom(*kept, case_));
  updatedWith_ = settingsToJson(settings).dump();
}

std::string ModelUpdateLogic::staleReason() const {
  if (!result_) return {};
  if (!result_->model && case_.updateStale())
    return "Surface, scan, patches or registration changed since: update again.";
  if (result_->scan != case_.scan())
    return sameShape(result_->scan, case_.scan()) ? "The scan was painted since: update again."
                                                  : "There is another scan since: update again.";
  if (result_->preop->patch != case_.preop()->patch) return "The liver was painted since: update again.";
  if (result_->registration != case_.registration()) return "The scan was registered since: update again.";
  if (model_ && result_->model && result_->model->responses().mesh.points != model_->responses().mesh.points)
    return "Another model was prepared since: update again.";
  if (updatedWith_ != settingsToJson(settings).dump()) return "Settings have changed since: update again.";
  return {};
}

const UpdatedCase& ModelUpdateLogic::run(const Progress& progress) {
  if (!model_) (void)acceptModel(prepareModel()(progress.part(0, 0.7)));
  (void)accept(prepare()(progress.part(0.7, 1)));
  return *result_;
}

}  // namespace falciform
