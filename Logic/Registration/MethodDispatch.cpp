#include "Logic/Registration/MethodDispatch.h"

#include <stdexcept>

#include "Logic/Registration/ClosestPointTransform.h"
#include "Logic/Registration/ColourIcp.h"
#include "Logic/Registration/Dirr.h"
#include "Logic/Registration/NonRigidRegistration.h"

namespace falciform {

namespace {

OtherMethodResult withWarp(NonRigidResult found) {
  return {std::move(found.rigid),
          RegistrationWarp{std::move(found.scanFromPreopWarp), std::move(found.warpedPreop)}};
}

}  // namespace

OtherMethodResult runOtherMethod(const PreparedPreop& preop, const Surface& scan,
                                 const RegistrationSettings& settings, const Isometry3d& start,
                                 const Progress& progress, const IterationObserver& observer) {
  switch (settings.method) {
    case RegistrationMethod::Dirr:
      return {registerDirr(preop, scan, settings, start, progress, observer), {}};
    case RegistrationMethod::Cpt:
      return {registerClosestPointTransform(preop, scan, settings, start, progress, observer), {}};
    case RegistrationMethod::Colour:
      return {registerColourIcp(preop, scan, settings, start, progress, observer), {}};
    case RegistrationMethod::Tps:
      return withWarp(registerTpsIcp(preop, scan, settings, start, progress, observer));
    case RegistrationMethod::Rpm:
      return withWarp(registerRobustPoints(preop, scan, settings, start, progress, observer));
    default:
      throw std::logic_error("not a method of MethodDispatch.h");
  }
}

}  // namespace falciform
