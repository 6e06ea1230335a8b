#include "Logic/Core/Case.h"

#include <utility>

namespace falciform {

void Case::announce(Part part) {
  modified_ = true;
  changed.emit(part);
}

void Case::announceWithoutDistance(Part part) {
  const bool dropped = distance_ != nullptr;
  distance_.reset();  // first: whoever hears of the new part must not find a map of the old one
  announce(part);
  if (dropped && !distance_) announce(Part::Distance);
}

void Case::setLabels(std::shared_ptr<const LabelMap> labels) {
  labels_ = std::move(labels);
  announce(Part::Labels);
}

void Case::setPreop(std::shared_ptr<const Surface> surface) {
  // Painting a patch makes a new surface of the same shape; supports lie on points and stay with them.
  const bool otherShape = !surface || !preop_ || surface->points.rows() != preop_->points.rows() ||
                          surface->points != preop_->points;
  const bool dropped = otherShape && supports_ != nullptr, withoutUpdate = otherShape && update_ != nullptr;
  if (dropped) supports_.reset();
  if (withoutUpdate) update_.reset();
  preop_ = std::move(surface);
  registrationStale_ = registration_ != nullptr;
  updateStale_ = update_ != nullptr;
  announceWithoutDistance(Part::Preop);
  if (dropped && !supports_) announce(Part::Supports);
  if (withoutUpdate && !update_) announce(Part::Update);
}

void Case::setScan(std::shared_ptr<const Surface> scan) {
  scan_ = std::move(scan);
  registrationStale_ = registration_ != nullptr;
  updateStale_ = update_ != nullptr;
  announceWithoutDistance(Part::Scan);
}

void Case::setStructure(const std::string& name, std::shared_ptr<const Surface> surface) {
  if (surface)
    structures_[name] = std::move(surface);
  else
    structures_.erase(name);
  announce(Part::Structures);
}

void Case::setPreopLandmarks(Landmarks landmarks) {
  preopLandmarks_ = std::move(landmarks);
  announce(Part::PreopLandmarks);
}

void Case::setScanLandmarks(Landmarks landmarks) {
  scanLandmarks_ = std::move(landmarks);
  announce(Part::ScanLandmarks);
}

void Case::setRegistration(std::shared_ptr<const RegistrationResult> result) {
  registration_ = std::move(result);
  registrationStale_ = false;
  updateStale_ = update_ != nullptr;
  announceWithoutDistance(Part::Registration);
}

void Case::setDistance(std::shared_ptr<const DistanceMap> map) {
  distance_ = std::move(map);
  announce(Part::Distance);
}

void Case::setSupports(std::shared_ptr<const SupportPainting> supports) {
  supports_ = std::move(supports);
  announce(Part::Supports);
}

void Case::setCt(std::shared_ptr<const Image> ct) {
  ct_ = std::move(ct);
  announce(Part::Ct);
}

void Case::setTargets(Landmarks targets) {
  targets_ = std::move(targets);
  announce(Part::Targets);
}

void Case::setTruthTargets(Landmarks targets) {
  truthTargets_ = std::move(targets);
  announce(Part::TruthTargets);
}

void Case::setUpdate(std::shared_ptr<const KeptUpdate> update, bool stale) {
  update_ = std::move(update);
  updateStale_ = stale && update_ != nullptr;
  announce(Part::Update);
}

void Case::setName(std::string name) {
  name_ = std::move(name);
  announce(Part::Name);
}

void Case::announceAll() {
  for (const Part part : {Part::Labels, Part::Preop, Part::Scan, Part::Structures, Part::PreopLandmarks,
                          Part::ScanLandmarks, Part::Registration, Part::Distance, Part::Supports, Part::Ct,
                          Part::Targets, Part::TruthTargets, Part::Update, Part::Name})
    changed.emit(part);
}

void Case::adopt(const Case& other) {
  labels_ = other.labels_;
  preop_ = other.preop_;
  scan_ = other.scan_;
  structures_ = other.structures_;
  preopLandmarks_ = other.preopLandmarks_;
  scanLandmarks_ = other.scanLandmarks_;
  registration_ = other.registration_;
  registrationStale_ = other.registrationStale_;
  distance_ = other.distance_;
  supports_ = other.supports_;
  ct_ = other.ct_;
  targets_ = other.targets_;
  truthTargets_ = other.truthTargets_;
  update_ = other.update_;
  updateStale_ = other.updateStale_;
  name_ = other.name_;
  announceAll();
  modified_ = other.modified_;
}

void Case::clear() { adopt(Case()); }

}  // namespace falciform
