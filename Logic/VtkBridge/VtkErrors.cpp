#include "Logic/VtkBridge/VtkErrors.h"

#include <vtkLogger.h>
#include <vtkObject.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <mutex>
#include <thread>

namespace falciform {

namespace {

/// "ERROR: In vtkX.cxx, line 12\nvtkX (0x55..): the message\n\n" -> "the message".
std::string plainText(const char* text) {
  std::string message = text ? text : "";
  if (const auto brief = message.find("): "); brief != std::string::npos) message.erase(0, brief + 3);
  std::string line;
  for (const char c : message) {
    const bool blank = static_cast<unsigned char>(c) <= ' ';
    if (!blank)
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line.empty() ? "unknown error in VTK" : line;
}

/// Keeps what this thread reports, and passes on what other threads report.
class CapturingWindow : public vtkOutputWindow {
 public:
  static CapturingWindow* New();
  vtkTypeMacro(CapturingWindow, vtkOutputWindow);

  void DisplayErrorText(const char* text) override {
    if (std::this_thread::get_id() != owner_)
      previous->DisplayErrorText(text);
    else if (firstError.empty())
      firstError = plainText(text);
  }
  void DisplayWarningText(const char* text) override {
    if (std::this_thread::get_id() != owner_) previous->DisplayWarningText(text);
  }
  void DisplayGenericWarningText(const char* text) override {
    if (std::this_thread::get_id() != owner_) previous->DisplayGenericWarningText(text);
  }
  void DisplayDebugText(const char* text) override {
    if (std::this_thread::get_id() != owner_) previous->DisplayDebugText(text);
  }
  void DisplayText(const char* text) override {
    if (std::this_thread::get_id() != owner_) previous->DisplayText(text);
  }

  std::string firstError;
  vtkSmartPointer<vtkOutputWindow> previous;

 private:
  const std::thread::id owner_ = std::this_thread::get_id();
};
vtkStandardNewMacro(CapturingWindow);

/// Puts the capturing window in place, and the state of before back, also when `work` throws.
class Capture {
 public:
  Capture()
      : displayed_(vtkObject::GetGlobalWarningDisplay()), logged_(vtkLogger::GetCurrentVerbosityCutoff()) {
    window->previous = vtkOutputWindow::GetInstance();
    vtkObject::SetGlobalWarningDisplay(1);  // otherwise VTK would swallow the error itself
    vtkOutputWindow::SetInstance(window);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);  // the log prints errors beside the window
  }
  ~Capture() {
    vtkLogger::SetStderrVerbosity(logged_);
    vtkOutputWindow::SetInstance(window->previous);
    vtkObject::SetGlobalWarningDisplay(displayed_);
  }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  vtkSmartPointer<CapturingWindow> window = vtkSmartPointer<CapturingWindow>::New();

 private:
  const int displayed_;
  const vtkLogger::Verbosity logged_;
};

}  // namespace

std::string vtkErrorsOf(const std::function<void()>& work) {
  // VTK has one output window for the whole process, so one reader at a time; recursive, since a reader may
  // call another.
  static std::recursive_mutex oneAtATime;
  const std::lock_guard lock(oneAtATime);
  const Capture capture;
  work();
  return capture.window->firstError;
}

}  // namespace falciform
