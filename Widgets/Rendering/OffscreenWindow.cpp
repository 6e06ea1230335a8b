#include "Widgets/Rendering/OffscreenWindow.h"

#include <GL/osmesa.h>
#include <vtkCallbackCommand.h>
#include <vtkNew.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "Logic/Core/Errors.h"
#include "Widgets/Rendering/Scene.h"

namespace falciform {

struct OffscreenWindow::Context {
  int width, height;
  OSMesaContext mesa = nullptr;
  std::vector<unsigned char> buffer;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkGenericRenderWindowInteractor> interactor;

  void makeCurrent() {
    if (!OSMesaMakeCurrent(mesa, buffer.data(), GL_UNSIGNED_BYTE, width, height))
      throw std::runtime_error("OSMesa refuses a window of " + std::to_string(width) + " x " +
                               std::to_string(height));
  }
};

namespace {

template <class Function>
void observe(vtkRenderWindow* window, unsigned long event, Function* function, void* client) {
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(function);
  command->SetClientData(client);
  window->AddObserver(event, command);
}

}  // namespace

OffscreenWindow::OffscreenWindow(int width, int height) {
  if (width < 64 || width > 8192 || height < 64 || height > 8192)
    throw InputError("picture size " + std::to_string(width) + " x " + std::to_string(height) +
                     " lies outside 64 to 8192 pixels; choose another");
  context_ = std::make_unique<Context>(Context{width, height, nullptr, {}, {}, {}});
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_STENCIL_BITS,
                            8,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            2,
                            0};
  context_->mesa = OSMesaCreateContextAttribs(attributes, nullptr);
  if (!context_->mesa) throw std::runtime_error("OSMesa gives no OpenGL 3.2 context");
  context_->buffer.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  context_->makeCurrent();

  auto* window = context_->window.Get();
  // Several windows may live at once, each with a context of its own: VTK asks for the right one by these
  // events.
  observe(
      window, vtkCommand::WindowMakeCurrentEvent,
      +[](vtkObject*, unsigned long, void* client, void*) { static_cast<Context*>(client)->makeCurrent(); },
      context_.get());
  observe(
      window, vtkCommand::WindowIsCurrentEvent,
      +[](vtkObject*, unsigned long, void* client, void* answer) {
        *static_cast<bool*>(answer) = OSMesaGetCurrentContext() == static_cast<Context*>(client)->mesa;
      },
      context_.get());
  window->SetSize(width, height);
  window->SetOffScreenRendering(1);
  window->SetIsDirect(0);
  window->SetReadyForRendering(true);
  window->SetSupportsOpenGL(1);
  window->SetMultiSamples(0);
  window->SetNumberOfLayers(2);
  window->OpenGLInit();
  context_->interactor->SetRenderWindow(window);
  context_->interactor->SetSize(width, height);
  context_->interactor->Initialize();
}

OffscreenWindow::~OffscreenWindow() {
  hide();
  context_->makeCurrent();
  context_->interactor->SetRenderWindow(nullptr);
  context_->window->Finalize();
  context_->window->RemoveAllObservers();
  OSMesaDestroyContext(context_->mesa);
}

void OffscreenWindow::show(Scene& scene) {
  hide();
  scene_ = &scene;
  scene.attach(context_->window);
}

void OffscreenWindow::hide() {
  if (scene_) scene_->detach();
  scene_ = nullptr;
}

void OffscreenWindow::render() { context_->window->Render(); }

RenderedImage OffscreenWindow::image() {
  render();
  return grab(context_->window);
}

void OffscreenWindow::savePng(const std::filesystem::path& file, Overwrite overwrite) {
  falciform::savePng(image(), file, overwrite);
}

vtkRenderWindow* OffscreenWindow::window() const { return context_->window; }
vtkRenderWindowInteractor* OffscreenWindow::interactor() const { return context_->interactor; }

}  // namespace falciform
