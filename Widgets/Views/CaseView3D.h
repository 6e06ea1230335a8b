#pragma once
#include <QWidget>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "Logic/Core/Case.h"
#include "Logic/Patches/PatchPaintingLogic.h"
#include "Widgets/Views/ViewState.h"

namespace falciform {

/// The 3D view of the case: follows Case and ViewState, paints and moves the scan with the
/// mouse, tells what lies under it.
/// Needs OpenGL.
class CaseView3D : public QWidget {
  Q_OBJECT

 public:
  CaseView3D(Case& document, ViewState& view, PatchPaintingLogic& painting, QWidget* parent = nullptr);
  ~CaseView3D() override;

  /// Must be called before the QApplication is made: the surface format that VTK needs.
  static void prepareApplication();

  /// Shows all, from the present direction.
  void fit();
  /// Takes the picture now; the function returned writes it as PNG, on any thread, replacing an old file.
  [[nodiscard]] std::function<void(const std::filesystem::path&)> picture();

  /// Where the camera stands, looks, and which way is up (mm in the scene), and its view angle: 10 numbers.
  [[nodiscard]] std::vector<double> camera() const;
  /// The same, once what is to be drawn next has been fitted; ignored unless it is such a list.
  void setCamera(const std::vector<double>& camera);

  /// Looks from where `other` looks, from now on and both ways.
  void shareCamera(CaseView3D& other);

  /// Where a point of the scene (mm) is drawn, in this widget's canvas, origin top left.
  [[nodiscard]] QPoint canvasPosition(const Vector3d& pointInScene) const;
  [[nodiscard]] QWidget* canvas() const;
  /// Standard views and fit; may be placed elsewhere.
  [[nodiscard]] QWidget* toolBar() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addToolBar();
  void followSoon();
  void watchCamera();
  void render();
  void follow();
  void takeCamera();
  void followPainting();
  void followMoving();
  void probe();

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace falciform
