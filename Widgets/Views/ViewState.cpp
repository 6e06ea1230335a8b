#include "Widgets/Views/ViewState.h"

#include "Widgets/Rendering/PatchColours.h"

namespace falciform {

namespace {

std::array<double, 3> rgb(const Vector3d& colour) { return {colour.x(), colour.y(), colour.z()}; }

}  // namespace

PartLook defaultLook(const std::string& part) {
  const auto names = [&](const char* word) { return part.find(word) != std::string::npos; };
  if (part == part::kPreop) return {true, rgb(kLiverColour), 1};
  if (part == part::kScan) return {true, rgb(kScanColour), 1};
  if (part == part::kPreopLandmarks) return {true, {0.90, 0.60, 0.00}, 1};
  if (part == part::kTargets) return {true, {0.80, 0.47, 0.65}, 1};
  if (part == part::kScanLandmarks) return {true, {0.00, 0.45, 0.70}, 1};
  // Colours of Okabe and Ito (2008), told apart by every kind of colour vision.
  if (names("portal")) return {true, {0.34, 0.71, 0.91}, 1};
  if (names("hepatic") || names("venous") || names("vein")) return {true, {0.00, 0.45, 0.70}, 1};
  if (names("arter")) return {true, {0.84, 0.37, 0.00}, 1};
  if (names("tumour") || names("tumor") || names("cyst")) return {true, {0.94, 0.89, 0.26}, 1};
  return {true, {0.00, 0.62, 0.45}, 1};
}

PartLook ViewState::look(const std::string& part) const {
  const auto found = options_.looks.find(part);
  return found == options_.looks.end() ? defaultLook(part) : found->second;
}

void ViewState::setLook(const std::string& part, const PartLook& look) {
  edit([&](ViewOptions& options) { options.looks[part] = look; });
}

PatchLook ViewState::patchLook(int label) const {
  const auto found = options_.patchLooks.find(label);
  return found == options_.patchLooks.end() ? PatchLook{true, rgb(patchColour(label))} : found->second;
}

void ViewState::setPatchLook(int label, const PatchLook& look) {
  edit([&](ViewOptions& options) { options.patchLooks[label] = look; });
}

}  // namespace falciform
