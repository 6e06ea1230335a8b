#pragma once
#include <memory>
#include <optional>
#include <string>

#include "Logic/Core/KeptUpdate.h"
#include "Logic/Core/Landmarks.h"
#include "Logic/Core/Results.h"
#include "Logic/Core/Signal.h"
#include "Logic/Core/SupportPainting.h"
#include "Logic/Core/Surface.h"
#include "Logic/Core/Volume.h"

namespace falciform {

/// The one shared document: what is known of a patient's liver before and during the operation. Touched on
/// the main thread only; jobs hold `shared_ptr<const T>` snapshots, so there are no locks. A part that is set
/// announces itself, and drops the results that rested on its old value.
class Case {
 public:
  enum class Part {
    Labels,
    Preop,
    Scan,
    Structures,
    PreopLandmarks,
    ScanLandmarks,
    Registration,
    Distance,
    Supports,
    Ct,
    Targets,
    TruthTargets,
    Update,
    Name
  };

  Signal<Part> changed;

  [[nodiscard]] const std::shared_ptr<const LabelMap>& labels() const { return labels_; }
  [[nodiscard]] const std::shared_ptr<const Surface>& preop() const { return preop_; }
  [[nodiscard]] const std::shared_ptr<const Surface>& scan() const { return scan_; }
  /// Vessels and tumours inside the liver, by name, pre-op LPS mm.
  [[nodiscard]] const std::map<std::string, std::shared_ptr<const Surface>>& structures() const {
    return structures_;
  }
  [[nodiscard]] const Landmarks& preopLandmarks() const { return preopLandmarks_; }
  [[nodiscard]] const Landmarks& scanLandmarks() const { return scanLandmarks_; }
  [[nodiscard]] const std::shared_ptr<const RegistrationResult>& registration() const {
    return registration_;
  }
  [[nodiscard]] const std::shared_ptr<const DistanceMap>& distance() const { return distance_; }
  /// What holds and pushes the liver, painted on the points of preop(); nullptr: nothing yet.
  [[nodiscard]] const std::shared_ptr<const SupportPainting>& supports() const { return supports_; }
  /// The CT that the pre-operative surface was made of, or nullptr: to look at, nothing is computed from it.
  [[nodiscard]] const std::shared_ptr<const Image>& ct() const { return ct_; }
  /// Places inside the liver, pre-op mm, of which one wants to know where they are now,
  [[nodiscard]] const Landmarks& targets() const { return targets_; }
  /// and, in trials, where they truly are, scan mm.
  [[nodiscard]] const Landmarks& truthTargets() const { return truthTargets_; }
  /// What the last model update came to, or nullptr.
  [[nodiscard]] const std::shared_ptr<const KeptUpdate>& update() const { return update_; }
  /// True when surface, patches, scan or registration changed after the update was made.
  [[nodiscard]] bool updateStale() const { return updateStale_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool modified() const { return modified_; }
  /// True when surface or patches changed after the registration was made: it is kept, and marked stale.
  [[nodiscard]] bool registrationStale() const { return registrationStale_; }

  void setLabels(std::shared_ptr<const LabelMap> labels);
  /// Marks registration and update stale, drops the distance map, and supports and update of a surface of
  /// another shape.
  void setPreop(std::shared_ptr<const Surface> surface);
  void setScan(std::shared_ptr<const Surface> scan);                                   ///< the same
  void setStructure(const std::string& name, std::shared_ptr<const Surface> surface);  ///< nullptr removes it
  void setPreopLandmarks(Landmarks landmarks);
  void setScanLandmarks(Landmarks landmarks);
  void setRegistration(std::shared_ptr<const RegistrationResult> result);  ///< drops the distance map
  void setDistance(std::shared_ptr<const DistanceMap> map);
  void setSupports(std::shared_ptr<const SupportPainting> supports);
  void setCt(std::shared_ptr<const Image> ct);
  void setTargets(Landmarks targets);
  void setTruthTargets(Landmarks targets);
  void setUpdate(std::shared_ptr<const KeptUpdate> update, bool stale = false);
  void setName(std::string name);

  /// Everything as in `other`, saved or not as `other` is; all is there when the first part is announced.
  void adopt(const Case& other);

  /// Everything gone, as after construction; connections stay.
  void clear();
  /// Called after saving.
  void setUnmodified() { modified_ = false; }

 private:
  void announce(Part part);
  void announceWithoutDistance(Part part);
  void announceAll();

  std::shared_ptr<const LabelMap> labels_;
  std::shared_ptr<const Surface> preop_, scan_;
  std::map<std::string, std::shared_ptr<const Surface>> structures_;
  Landmarks preopLandmarks_, scanLandmarks_;
  std::shared_ptr<const RegistrationResult> registration_;
  std::shared_ptr<const DistanceMap> distance_;
  std::shared_ptr<const SupportPainting> supports_;
  std::shared_ptr<const Image> ct_;
  Landmarks targets_, truthTargets_;
  std::shared_ptr<const KeptUpdate> update_;
  std::string name_ = "Untitled";
  bool modified_ = false, registrationStale_ = false, updateStale_ = false;
};

}  // namespace falciform
