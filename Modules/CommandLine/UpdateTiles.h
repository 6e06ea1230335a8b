#pragma once
#include <memory>
#include <string>

#include "Logic/Core/Results.h"
#include "Logic/Core/Surface.h"
#include "Modules/CommandLine/PictureTiles.h"
#include "Widgets/Rendering/PictureSources.h"
#include "Widgets/Rendering/ScalarMap.h"

namespace falciform::commandline {

/// A liver before and after its update, all in the scan's frame and seen as the scanner saw it, so that tiles
/// can be compared.
class UpdateTiles {
 public:
  /// `updated` has the array kDisplacement, and expected_error_mm where the method expects an error.
  UpdateTiles(const Surface& preop, const Surface& updated, const Surface& scan,
              const Isometry3d& scanFromPreopRigid);

  /// The liver under the scan's points as the rigid registration leaves it,
  [[nodiscard]] RenderedImage registered() const;
  /// and as the update moves it, coloured by displacement beside the rigid motion.
  [[nodiscard]] RenderedImage moved() const;
  [[nodiscard]] bool expectsError() const;
  [[nodiscard]] RenderedImage expectedError() const;
  /// The scan coloured by its signed distance to the liver; `colours` is shared by tiles to be compared.
  [[nodiscard]] RenderedImage residual(const std::string& title, const Surface& scanWithDistance,
                                       const ScalarMap& colours) const;
  /// Vessels and tumours in the see-through updated liver: grey as registered, in colour as updated.
  [[nodiscard]] RenderedImage structures(const Structures& preop, const Structures& updated) const;

 private:
  [[nodiscard]] std::unique_ptr<Scene> scene(const std::string& title) const;
  [[nodiscard]] RenderedImage draw(Scene& scene) const;
  [[nodiscard]] RenderedImage mapped(const std::string& title, const ScalarMap& colours, bool scan) const;
  void addScan(Scene& scene) const;

  Isometry3d rigidPose_;
  std::shared_ptr<const Surface> rigid_, moved_, cloud_;
  ViewDirection view_;
  Points within_;
};

}  // namespace falciform::commandline
