// What a mouse move costs while painting, without the drawing itself: ./run bench painting
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <numbers>
#include <vector>

#include "Logic/Acquisition/SyntheticLiver.h"
#include "Testing/Benchmarks/Stopwatch.h"
#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/OffscreenWindow.h"
#include "Widgets/Rendering/PaintInteractor.h"
#include "Widgets/Rendering/Scene.h"

namespace falciform::bench {
namespace {

constexpr int kWidth = 1000, kHeight = 800;

/// One surface in a view, painted by synthetic mouse events; the window draws nothing between them.
struct Easel {
  Easel(const Surface& surface) : window(kWidth, kHeight) {
    document.setPreop(std::make_shared<const Surface>(surface));
    presenter.show(document.preop());
    window.show(scene);
    window.interactor()->SetInteractorStyle(style);
    style->SetDefaultRenderer(scene.renderer());
    fitView(scene.renderer(), surface.points, directionOf(StandardView::Anterior), double(kWidth) / kHeight);
    window.render();
    window.interactor()->EnableRenderOff();
  }
  ~Easel() { style->stopPainting(); }

  Spent event(unsigned long id, double x, double y) {
    window.interactor()->SetEventInformation(static_cast<int>(x), static_cast<int>(y));
    return measured([&] { window.interactor()->InvokeEvent(id); });
  }

  Case document;
  PatchPaintingLogic logic{document};
  Scene scene;
  SurfacePresenter& presenter = scene.add<SurfacePresenter>();
  OffscreenWindow window;
  vtkNew<PaintInteractor> style;
};

void printRow(const char* what, const std::vector<Spent>& spent) {
  std::vector<double> wall, cpu;
  for (const Spent& one : spent) {
    wall.push_back(one.wallMs);
    cpu.push_back(one.cpuMs);
  }
  std::printf("| %s | %zu | %.2f | %.2f | %.2f | %.2f | %.2f |\n", what, spent.size(), quantile(cpu, 0.5),
              quantile(cpu, 0.95), quantile(cpu, 1), quantile(wall, 0.5), quantile(wall, 0.95));
  std::fflush(stdout);
}

/// Moves of one stroke that circles over the liver, `stepPx` pixels each.
std::vector<Spent> stroke(Easel& easel, double stepPx) {
  std::vector<Spent> moves;
  const double radius = 160;
  const auto at = [&](double way) {
    const double angle = way / radius;
    return std::pair{kWidth / 2 - 60 + 1.4 * radius * std::cos(angle),
                     kHeight / 2 + radius * std::sin(angle)};
  };
  const auto [x0, y0] = at(0);
  (void)easel.event(vtkCommand::LeftButtonPressEvent, x0, y0);
  double way = 0;
  for (int i = 0; i < 200; ++i) {
    way += stepPx;
    const auto [x, y] = at(way);
    moves.push_back(easel.event(vtkCommand::MouseMoveEvent, x, y));
  }
  const auto [x, y] = at(way);
  (void)easel.event(vtkCommand::LeftButtonReleaseEvent, x, y);
  return moves;
}

void paintOn(const char* name, const Surface& surface) {
  Easel easel(surface);
  std::printf("\n%s: %lld points\n\n", name, static_cast<long long>(surface.size()));
  std::printf("| what | times | processor, median, ms | P95 | largest | wall, median, ms | P95 |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  easel.style->startPainting(easel.logic, easel.presenter, easel.scene.renderer());
  printRow("first move over the surface: search tree", {easel.event(vtkCommand::MouseMoveEvent, 440, 400)});
  printRow("first press: the surface made ready", {easel.event(vtkCommand::LeftButtonPressEvent, 440, 400)});
  (void)easel.event(vtkCommand::LeftButtonReleaseEvent, 440, 400);

  easel.logic.replaces = true;
  int label = 0;
  for (const double radius : {3.0, 6.0, 12.0, 30.0})
    for (const double step : {4.0, 40.0}) {
      easel.logic.radiusMm = radius;
      std::vector<Spent> moves;
      for (int repeat = 0; repeat < 3; ++repeat) {
        easel.logic.label = 1 + label++ % 3;  // each stroke changes what it touches
        const std::vector<Spent> one = stroke(easel, step);
        moves.insert(moves.end(), one.begin(), one.end());
      }
      char what[120];
      std::snprintf(what, sizeof what, "brush of %.0f mm, %s: %.0f pixels a move", radius,
                    step < 10 ? "slow" : "fast", step);
      printRow(what, moves);
    }

  std::vector<Spent> ends, undos;
  easel.logic.radiusMm = 6;
  for (int i = 0; i < 20; ++i) {
    easel.logic.label = 1 + label++ % 3;
    (void)easel.event(vtkCommand::LeftButtonPressEvent, 300 + 10 * i, 400);
    (void)easel.event(vtkCommand::MouseMoveEvent, 320 + 10 * i, 440);
    ends.push_back(easel.event(vtkCommand::LeftButtonReleaseEvent, 320 + 10 * i, 440));
    undos.push_back(measured([&] { (void)easel.logic.undo(); }));
  }
  printRow("end of a stroke: one undo step, the case has the new patch", ends);
  printRow("undo", undos);

  easel.logic.tool = PaintTool::Line;
  easel.logic.label = 1;
  (void)easel.event(vtkCommand::LeftButtonPressEvent, 330, 400);
  (void)easel.event(vtkCommand::LeftButtonReleaseEvent, 330, 400);
  std::vector<Spent> ahead;
  for (int i = 0; i < 100; ++i)
    ahead.push_back(easel.event(vtkCommand::MouseMoveEvent, 340 + 3 * i, 400 + 60 * std::sin(0.1 * i)));
  printRow("line: the way to the mouse, anew at each move", ahead);
}

void run() {
  SyntheticLiverSettings settings;
  settings.edgeLengthMm = 1.0;
  settings.voxelMm = 10;  // not used
  Surface liver = makeSyntheticLiver(settings).surface;
  paintOn("Liver with triangles", liver);
  liver.triangles.resize(0, 3);
  paintOn("The same as a cloud of points", liver);
}

}  // namespace
}  // namespace falciform::bench

int main() { falciform::bench::run(); }
