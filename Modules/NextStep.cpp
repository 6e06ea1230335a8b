#include "Modules/NextStep.h"

#include <QCoreApplication>
#include <algorithm>

namespace falciform {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("NextStep", text); }

/// A patch of the two that every liver has is bare on `surface` though it could be painted.
QString barePatch(const Surface& surface) {
  const std::vector<int> painted = patchLabels(surface);
  for (const int label : {patch::kFalciform, patch::kInferiorRidge})
    if (std::find(painted.begin(), painted.end(), label) == painted.end())
      return QString::fromStdString(patchName(surface, label));
  return {};
}

}  // namespace

NextStep nextStep(const Case& document) {
  const char *import = "SegmentationImport", *paint = "PatchPainting", *registration = "Registration",
             *deformation = "DeformationAnalysis", *update = "AtlasUpdate";
  if (!document.preop())
    return document.labels() ? NextStep{tr("tick what is liver, and import its surface"), import, {}}
           : document.ct()   ? NextStep{tr("place seeds in the CT's liver, and segment it"), import, {}}
                             : NextStep{tr("open a label map, CT or liver surface"), import, {}};
  if (!document.scan()) return {tr("open the scan: drop its file on the window"), import, {}};
  const bool registered = document.registration() && !document.registrationStale();
  if (!registered) {
    if (patchLabels(*document.preop()).empty())
      return {tr("paint %1 and ridge on the liver").arg(barePatch(*document.preop())), paint,
              PaintTarget::Preop};
    if (patchLabels(*document.scan()).empty())
      return {tr("paint the same patches on the scan"), paint, PaintTarget::Scan};
    if (const QString bare = barePatch(*document.preop()); !bare.isEmpty() && !document.registration())
      return {tr("paint the %1 too, or register").arg(bare), paint, PaintTarget::Preop};
    return {document.registration() ? tr("register again: something has changed") : tr("register the scan"),
            registration,
            {}};
  }
  if (!document.distance()) return {tr("compute the distance map"), deformation, {}};
  if (!document.update()) return {tr("update the model: tumours and vessels as bent"), update, {}};
  if (document.updateStale()) return {tr("update the model again: something has changed"), update, {}};
  return {
      document.modified() ? tr("look at the results, save the case") : tr("look at the results"), update, {}};
}

}  // namespace falciform
