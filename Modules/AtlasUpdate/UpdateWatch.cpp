#include "Modules/AtlasUpdate/UpdateWatch.h"
#include "Logic/Atlas/ExpectedError.h"

#include <algorithm>
#include <limits>

namespace falciform {
namespace {

constexpr Index kSampled = 60;     // places that the running update's expected error is reckoned at
constexpr int kReckonedEvery = 4;  // iterations; it takes as long as an iteration

Points sampleOf(const Points& points) {
  const Index step = std::max<Index>(1, points.rows() / kSampled);
  Points sample((points.rows() + step - 1) / step, 3);
  for (Index i = 0; i < sample.rows(); ++i) sample.row(i) = points.row(i * step);
  return sample;
}

}  // namespace

UpdateWatch::UpdateWatch(const Case& document, std::shared_ptr<const UpdateModel> model)
    : shared_(std::make_shared<Shared>()) {
  shared_->sample = sampleOf(model->preop().points);
  shared_->model = std::move(model);
  shared_->preopFromScan = document.registration()->scanFromPreop.inverse();
  Index all = document.preop()->size();
  for (const auto& [name, structure] : document.structures()) {
    shared_->structures[name] = structure->size();
    all += structure->size();
  }
  shared_->before.resize(all, 3);
  shared_->before.topRows(document.preop()->size()) = document.preop()->points;
  Index row = document.preop()->size();
  for (const auto& [name, structure] : document.structures()) {
    shared_->before.middleRows(row, structure->size()) = structure->points;
    row += structure->size();
  }
}

UpdateObserver UpdateWatch::observer() const {
  // Where the places lie in the mesh is found at the first iteration, away from the window.
  return [shared = shared_, places = std::make_shared<MeshPlaces>()](const UpdateStep& step) {
    const UpdateResult now = step.result();
    if (places->size() == 0) *places = MeshPlaces(shared->model->responses().mesh, shared->before);
    const Points moved = transformed(Points(shared->before + Points(places->interpolate(now.displacements))),
                                     shared->preopFromScan * now.scanFromPreop);
    auto shape = std::make_shared<UpdateShape>();
    Index row = moved.rows();
    for (auto structure = shared->structures.rbegin(); structure != shared->structures.rend(); ++structure) {
      row -= structure->second;
      shape->structures[structure->first] = moved.middleRows(row, structure->second);
    }
    shape->liver = moved.topRows(row);
    UpdateRecord record{step.iteration, step.rmsMm, step.bendMm, std::numeric_limits<double>::quiet_NaN(),
                        std::move(shape)};
    if (step.iteration % kReckonedEvery == 1)
      record.expectedMm = expectedErrorMm(*shared->model, now, shared->sample).mean();
    shared->records.add(record);
    return !shared->stop;
  };
}

}  // namespace falciform
