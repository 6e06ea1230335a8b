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
  const bool dropped = otherShape && supports_ != nullptr;
  if (dropped) supports_.reset();
  preop_ = std::move(surface);
  registrationStale_ = registration_ != nullptr;
  announceWithoutDistance(Part::Preop);
  if (dropped && !supports_) announce(Part::Supports);
}

void Case::setScan(std::shared_ptr<const Surface> scan) {
  scan_ = std::move(scan);
  registrationStale_ = registration_ != nullptr;
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

void Case::setName(std::string name) {
  name_ = std::move(name);
  announce(Part::Name);
}

void Case::clear() {
  labels_.reset();
  preop_.reset();
  scan_.reset();
  structures_.clear();
  preopLandmarks_ = {};
  scanLandmarks_ = {};
  registration_.reset();
  distance_.reset();
  supports_.reset();
  ct_.reset();
  targets_ = {};
  truthTargets_ = {};
  name_ = "Untitled";
  registrationStale_ = false;
  for (const Part part : {Part::Labels, Part::Preop, Part::Scan, Part::Structures, Part::PreopLandmarks,
                          Part::ScanLandmarks, Part::Registration, Part::Distance, Part::Supports, Part::Ct,
                          Part::Targets, Part::TruthTargets, Part::Name})
    changed.emit(part);
  modified_ = false;
}

}  // namespace falciform
