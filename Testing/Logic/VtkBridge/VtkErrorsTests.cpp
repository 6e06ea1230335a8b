#include <gmock/gmock.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkOutputWindow.h>
#include <vtkPolyData.h>
#include <vtkSetGet.h>
#include <vtkSmartPointer.h>

#include <thread>

#include "Logic/VtkBridge/VtkErrors.h"

namespace falciform {
namespace {

void complain(const char* text) {
  vtkNew<vtkPolyData> object;
  vtkErrorWithObjectMacro(object, << text);
}

TEST(VtkErrors, GivesTheFirstErrorInOneLineAndPrintsNothing) {
  testing::internal::CaptureStderr();
  const std::string error = vtkErrorsOf([] {
    vtkGenericWarningMacro("a warning is no error");
    complain("first\n  thing");
    complain("second");
  });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(error, "first thing");
}

TEST(VtkErrors, IsEmptyWhereNothingWentWrong) {
  EXPECT_EQ(vtkErrorsOf([] {}), "");
  EXPECT_EQ(vtkErrorsOf([] { vtkGenericWarningMacro("only a warning"); }), "");
}

TEST(VtkErrors, PutsTheStateBackAlsoWhenTheWorkThrows) {
  vtkOutputWindow* before = vtkOutputWindow::GetInstance();
  const auto verbosity = vtkLogger::GetCurrentVerbosityCutoff();
  vtkObject::SetGlobalWarningDisplay(0);
  EXPECT_EQ(vtkErrorsOf([] { complain("told even where VTK is silenced"); }),
            "told even where VTK is silenced");
  EXPECT_EQ(vtkObject::GetGlobalWarningDisplay(), 0);
  vtkObject::SetGlobalWarningDisplay(1);
  EXPECT_THROW((void)vtkErrorsOf([] { throw std::runtime_error("x"); }), std::runtime_error);
  EXPECT_EQ(vtkOutputWindow::GetInstance(), before);
  EXPECT_EQ(vtkObject::GetGlobalWarningDisplay(), 1);
  EXPECT_EQ(vtkLogger::GetCurrentVerbosityCutoff(), verbosity);
}

TEST(VtkErrors, NestsOnOneThread) {
  std::string inner;
  const std::string outer = vtkErrorsOf([&] {
    inner = vtkErrorsOf([] { complain("inner"); });
    complain("outer");
  });
  EXPECT_EQ(inner, "inner");
  EXPECT_EQ(outer, "outer");
}

TEST(VtkErrors, ManyThreadsEachGetTheirOwn) {
  std::vector<std::string> found(8);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < found.size(); ++i)
      threads.emplace_back([&found, i] {
        for (int round = 0; round < 50; ++round)
          found[i] = vtkErrorsOf([i] { complain(std::to_string(i).c_str()); });
      });
  }
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], std::to_string(i));
}

}  // namespace
}  // namespace falciform
