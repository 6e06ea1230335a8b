#include <gtest/gtest.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <cstdlib>

namespace {

/// What VTK reports, errors and warnings alike, fails the running test.
class FailingWindow : public vtkOutputWindow {
 public:
  static FailingWindow* New();
  vtkTypeMacro(FailingWindow, vtkOutputWindow);

  void DisplayErrorText(const char* text) override { ADD_FAILURE() << "VTK: " << text; }
  void DisplayWarningText(const char* text) override { ADD_FAILURE() << "VTK: " << text; }
  void DisplayGenericWarningText(const char* text) override { ADD_FAILURE() << "VTK: " << text; }
};
vtkStandardNewMacro(FailingWindow);

class VtkMessages : public testing::Environment {
 public:
  void SetUp() override {
    unsetenv("DISPLAY");  // nobody may lean on one
    vtkOutputWindow::SetInstance(vtkSmartPointer<FailingWindow>::New());
  }
  void TearDown() override { vtkOutputWindow::SetInstance(nullptr); }
};

[[maybe_unused]] const auto* const installed = testing::AddGlobalTestEnvironment(new VtkMessages);

}  // namespace
