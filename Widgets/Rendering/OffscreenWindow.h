#pragma once
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>

#include <filesystem>
#include <memory>

#include "Logic/IO/OutputFile.h"
#include "Widgets/Rendering/RenderedImage.h"

namespace falciform {

class Scene;

/// A render window in memory, without a display: OSMesa. Only in executables declared with
/// falciform_offscreen_executable(). Not for use from several threads.
class OffscreenWindow {
 public:
  /// Width and height in pixels, each in [64, 8192]; throws InputError outside it and std::runtime_error
  /// without OSMesa.
  OffscreenWindow(int width, int height);
  ~OffscreenWindow();
  OffscreenWindow(const OffscreenWindow&) = delete;
  OffscreenWindow& operator=(const OffscreenWindow&) = delete;

  /// Shows this scene in place of the last one; it must outlive the window, the next show() or hide().
  void show(Scene& scene);
  /// Lets go of the scene.
  void hide();
  void render();
  /// Renders and returns the picture.
  [[nodiscard]] RenderedImage image();
  /// Renders and writes a PNG under a temporary name first.
  void savePng(const std::filesystem::path& file, Overwrite overwrite);

  [[nodiscard]] vtkRenderWindow* window() const;
  /// Takes synthetic mouse and key events.
  [[nodiscard]] vtkRenderWindowInteractor* interactor() const;

 private:
  struct Context;
  std::unique_ptr<Context> context_;
  Scene* scene_ = nullptr;
};

}  // namespace falciform
