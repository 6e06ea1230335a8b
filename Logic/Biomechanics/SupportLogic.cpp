#include "Logic/Biomechanics/SupportLogic.h"

#include <algorithm>

#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

bool sameShape(const std::shared_ptr<const Surface>& a, const std::shared_ptr<const Surface>& b) {
  return a && b && (a == b || (a->points.rows() == b->points.rows() && a->points == b->points));
}

bool isTumour(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name.starts_with("tumour") || name.starts_with("tumor");
}

bool sameKinds(const std::vector<Support>& supports, const std::vector<int>& labels,
               const SupportPainting& painting) {
  for (std::size_t s = 0; s < supports.size(); ++s) {
    const auto region = painting.regions.find(labels[s]);
    if (region == painting.regions.end() || supportKindOf(region->second.kind) != supports[s].kind)
      return false;
  }
  return true;
}

SupportLogic::Answer answer(const std::shared_ptr<const SupportModel>& model, const SupportPainting& painting,
                            const std::shared_ptr<const SupportLogic::Answer>& known) {
  SupportLogic::Answer result;
  result.painted = painting.labels;
  if (known && known->response && known->response->model() == model && known->painted == painting.labels &&
      sameKinds(known->response->supports(), known->labels, painting)) {
    result.response = known->response;
    result.labels = known->labels;
    result.warnings = known->warnings;
  } else {
    PaintedSupports painted = supportsOf(*model, painting);
    result.warnings = std::move(painted.warnings);
    result.missing = missingSupport(*model, painted);
    if (!result.missing.empty()) return result;
    result.labels = std::move(painted.labels);
    result.response = std::make_shared<const SupportResponse>(model, std::move(painted.supports));
  }
  std::vector<double> pushMm;
  for (const int label : result.labels) pushMm.push_back(painting.regions.at(label).pushMm);
  result.liver = result.response->at(pushMm, painting.turnDeg);
  return result;
}

}  // namespace

SupportLogic::SupportLogic(Case& document) : case_(document) {
  watching_ = case_.changed.connect([this](Case::Part part) {
    if (part == Case::Part::Preop && model_ && !sameShape(model_->preop, case_.preop())) model_.reset();
  });
}

std::string SupportLogic::missingInput() const {
  if (!case_.preop() || case_.preop()->size() == 0) return "Import or open a surface first.";
  if (case_.preop()->triangles.rows() == 0)
    return "The pre-operative surface has no triangles: import it from a label map, or open a closed "
           "surface.";
  return {};
}

std::function<std::shared_ptr<const SupportModel>(const Progress&)> SupportLogic::prepare() const {
  if (const std::string missing = missingInput(); !missing.empty()) throw InputError(missing);
  std::vector<std::shared_ptr<const Surface>> tumours;
  for (const auto& [name, surface] : case_.structures())
    if (isTumour(name)) tumours.push_back(surface);
  preparing_ = settings;
  return [preop = case_.preop(), tumours, painted = case_.supports(),
          with = settings](const Progress& progress) {
    std::vector<Surface> regions;
    for (const auto& tumour : tumours) regions.push_back(*tumour);
    return prepareSupportModel(preop, regions, painted, with, progress);
  };
}

bool SupportLogic::accept(std::shared_ptr<const SupportModel> model) {
  if (!model || !sameShape(model->preop, case_.preop())) return false;
  model_ = std::move(model);
  preparedWith_ = preparing_;
  return true;
}

bool SupportLogic::outdated() const {
  return model_ && (settingsToJson(settings) != settingsToJson(preparedWith_) ||
                    (case_.preop() && case_.preop()->patch != model_->preop->patch));
}

std::shared_ptr<const SupportPainting> SupportLogic::supports() const {
  if (case_.supports() || !case_.preop()) return case_.supports();
  return std::make_shared<const SupportPainting>(emptySupportPainting(case_.preop()->size()));
}

SupportPainting SupportLogic::templatePainting() const {
  if (!model_) throw InputError("there is no model of the liver yet; prepare the model first");
  return paintedTemplate(*model_, *supports(), templateSettings);
}

std::function<SupportLogic::Answer()> SupportLogic::deform(std::shared_ptr<const Answer> known) const {
  if (!model_) throw InputError("there is no model of the liver yet; prepare the model first");
  return [model = model_, painting = supports(), known = std::move(known)] {
    return answer(model, *painting, known);
  };
}

}  // namespace falciform
