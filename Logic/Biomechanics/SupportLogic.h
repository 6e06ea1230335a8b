#pragma once
#include <functional>
#include <memory>

#include "Logic/Biomechanics/SupportResponse.h"
#include "Logic/Core/Case.h"

namespace falciform {

/// The mechanical model of the case's liver and the supports painted on it, without a window. Main thread
/// only; what prepare() and deform() return may run on any.
class SupportLogic {
 public:
  explicit SupportLogic(Case& document);

  LiverModelSettings settings;
  SupportTemplateSettings templateSettings;

  /// What is missing before a model can be prepared, in words, or empty.
  [[nodiscard]] std::string missingInput() const;
  /// Meshing and factorisation of the case as it is now.
  [[nodiscard]] std::function<std::shared_ptr<const SupportModel>(const Progress&)> prepare() const;
  /// Dropped (false) if the liver's shape has changed meanwhile.
  bool accept(std::shared_ptr<const SupportModel> model);
  void run(const Progress& progress = {}) { (void)accept(prepare()(progress)); }

  /// Of the case's liver, or nullptr: none yet, or its shape has changed.
  [[nodiscard]] const std::shared_ptr<const SupportModel>& model() const { return model_; }
  /// Whether settings, or the patches that place the support sites, have changed since it was prepared.
  [[nodiscard]] bool outdated() const;

  /// The case's supports, or the regions to begin with where nothing is painted; nullptr without a surface.
  [[nodiscard]] std::shared_ptr<const SupportPainting> supports() const;
  /// The template of `templateSettings` on the case's liver; needs a model.
  [[nodiscard]] SupportPainting templatePainting() const;

  /// The answer to the case's supports as they are now; reuses `known` where only distances or the turn
  /// differ. Throws InputError for supports that do not hold the liver.
  struct Answer {
    std::string missing;  ///< what must be done first, in words; then there is no liver
    std::vector<std::string> warnings;
    std::vector<int> painted;  ///< the labels that `response` answers to, one a point,
    std::vector<int> labels;   ///< and those of its supports, one each
    std::shared_ptr<const SupportResponse> response;
    DeformedLiver liver;
  };
  [[nodiscard]] std::function<Answer()> deform(std::shared_ptr<const Answer> known) const;

 private:
  Case& case_;
  std::shared_ptr<const SupportModel> model_;
  LiverModelSettings preparedWith_;
  mutable LiverModelSettings preparing_;
  Connection watching_;
};

}  // namespace falciform
