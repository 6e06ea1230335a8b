#include "Widgets/Views/CaseView3D.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <QLabel>
#include <QMouseEvent>
#include <QSurfaceFormat>
#include <QTimer>
#include <QVBoxLayout>
#include <utility>

#include "Widgets/Rendering/CameraViews.h"
#include "Widgets/Rendering/PaintInteractor.h"
#include "Widgets/Rendering/Picking.h"
#include "Widgets/Rendering/PoseInteractor.h"
#include "Widgets/Views/CaseScene.h"
#include "Widgets/Views/DataProbe.h"
#include "Widgets/Views/SceneCanvas.h"
#include "Widgets/Views/StandardViewBar.h"

namespace falciform {
namespace {

/// Whether they differ in nothing but what slices show: a drag there is not to draw the liver anew each time.
bool sameIn3D(ViewOptions a, const ViewOptions& b) {
  a.greyWindow = b.greyWindow;
  a.labelColours = b.labelColours;
  a.labelsShown = b.labelsShown;
  a.sliceTool = b.sliceTool;
  a.sliceBrushMm = b.sliceBrushMm;
  a.liveLabels = b.liveLabels;
  a.forbidden = b.forbidden;
  a.labelEdits = b.labelEdits;
  return a == b;
}

constexpr double kHandleShare = 0.4;  // radius of the handles' rings, of the scan's reach

}  // namespace

struct CaseView3D::Parts {
  Parts(Case& document, ViewState& viewState, PatchPaintingLogic& brush, int textPx)
      : view(viewState), painting(brush), scene(document, viewState, textPx) {}

  ViewState& view;
  PatchPaintingLogic& painting;
  CaseScene scene;
  DataProbe probe;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<PaintInteractor> style;
  vtkNew<PoseInteractor> mover;
  std::shared_ptr<const Surface> moved;  // what the mover's handles stand around
  SurfacePresenter* painted = nullptr;
  QVTKOpenGLNativeWidget* canvas = nullptr;
  QWidget* toolBar = nullptr;
  QLabel* probeText = nullptr;
  QTimer* followTimer = nullptr;
  QTimer* probeTimer = nullptr;
  QTimer* renderTimer = nullptr;  // only where the camera is shared
  vtkSmartPointer<vtkCamera> camera;
  unsigned long cameraWatch = 0;
  vtkMTimeType drawnCamera = 0;
  QPoint mouse;
  bool fitWanted = true;
  std::vector<double> cameraWanted;  // in place of the next fit
  ViewOptions followed;
  Connection caseChanged, viewChanged;
};

void CaseView3D::prepareApplication() {
  // Several samples a pixel would switch depth peeling off, and with it see-through livers.
  vtkOpenGLRenderWindow::SetGlobalMaximumNumberOfMultiSamples(0);
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
}

CaseView3D::CaseView3D(Case& document, ViewState& view, PatchPaintingLogic& painting, QWidget* parent)
    : QWidget(parent),
      parts_(std::make_unique<Parts>(document, view, painting, static_cast<int>(14 * devicePixelRatioF()))) {
  setObjectName("caseView3D");
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  addToolBar();

  parts_->canvas = sceneCanvas(this, "canvas", parts_->window);
  parts_->scene.scene().attach(parts_->window);
  parts_->window->GetInteractor()->SetInteractorStyle(parts_->style);
  column->addWidget(parts_->canvas, 1);

  parts_->probeText = probeLine(
      this, "probe", tr("What lies under the mouse: part, value with its unit, patch, place in mm, vertex"));
  column->addWidget(parts_->probeText);

  parts_->style->onChange = [this] { parts_->view.brushChanged.emit(); };
  parts_->style->onWarn = [this](const std::string& why) { parts_->view.warned.emit(why); };
  parts_->style->onLeave = [this] {
    parts_->view.edit([](ViewOptions& options) { options.painting = false; });
  };

  parts_->mover->onMove = [this](const Isometry3d& pose) {
    parts_->view.edit([&](ViewOptions& options) { options.livePreopFromScan = pose.matrix(); });
  };
  parts_->mover->onLeave = [this] {
    parts_->view.edit([](ViewOptions& options) { options.moving = false; });
  };

  parts_->followTimer = onceTimer(this, 0, [this] { follow(); });
  parts_->probeTimer = onceTimer(this, kProbeAfterMs, [this] { probe(); });
  parts_->caseChanged = document.changed.connect([this](Case::Part) { followSoon(); });
  parts_->viewChanged = view.changed.connect([this] {
    const ViewOptions& now = parts_->view.options();
    const ViewOptions before = std::exchange(parts_->followed, now);
    if (!sameIn3D(before, now)) followSoon();
  });
  followSoon();
}

CaseView3D::~CaseView3D() {
  parts_->style->onLeave = nullptr;
  parts_->style->stopPainting();
  parts_->mover->stopMoving();
  if (parts_->camera) parts_->camera->RemoveObserver(parts_->cameraWatch);
  parts_->scene.scene().detach();
}

void CaseView3D::addToolBar() {
  parts_->toolBar = new StandardViewBar(
      [this](std::optional<StandardView> view) {
        if (view) setStandardView(parts_->scene.scene().renderer(), *view, parts_->scene.sceneFromLps());
        fit();
      },
      this);
  layout()->addWidget(parts_->toolBar);
}

QWidget* CaseView3D::canvas() const { return parts_->canvas; }

QWidget* CaseView3D::toolBar() const { return parts_->toolBar; }

// Several changes in a row, as when a case is opened, are drawn once.
void CaseView3D::followSoon() { parts_->followTimer->start(); }

void CaseView3D::follow() {
  if (parts_->scene.follow()) parts_->fitWanted = true;
  parts_->scene.scene().setDark(parts_->view.options().darkScene);
  parts_->style->sceneFromLps = parts_->mover->sceneFromLps = parts_->scene.sceneFromLps();
  followPainting();
  followMoving();
  parts_->scene.scene().renderer()->ResetCameraClippingRange();  // the scan may lie elsewhere now
  if (parts_->fitWanted && parts_->canvas->isVisible()) {
    parts_->fitWanted = false;
    fit();  // renders
    takeCamera();
  } else {
    render();
  }
  // What lies under a resting mouse may have changed as well.
  if (parts_->canvas->underMouse()) parts_->probeTimer->start();
}

void CaseView3D::followPainting() {
  const bool onScan = parts_->painting.target == PaintTarget::Scan;
  SurfacePresenter* wanted = !parts_->view.options().painting ? nullptr
                             : onScan                         ? &parts_->scene.scan()
                                                              : &parts_->scene.preop();
  if (wanted && !parts_->painting.missingInput().empty()) wanted = nullptr;
  if (wanted == parts_->painted && (wanted != nullptr) == parts_->style->painting()) return;
  parts_->painted = wanted;
  parts_->style->stopPainting();
  if (wanted) parts_->style->startPainting(parts_->painting, *wanted, parts_->scene.scene().renderer());
  parts_->canvas->setCursor(wanted ? Qt::CrossCursor : Qt::ArrowCursor);
}

void CaseView3D::followMoving() {
  const ViewOptions& options = parts_->view.options();
  const std::shared_ptr<const Surface> scan = parts_->scene.scan().surface();
  const bool wanted = options.moving && options.livePreopFromScan && scan && scan->size() > 0 &&
                      options.arrangement == Arrangement::Together;
  PoseInteractor& mover = *parts_->mover;
  mover.stepMm = options.moveStepMm;
  mover.stepDeg = options.moveStepDeg;
  if (wanted && (!mover.moving() || parts_->moved != scan)) {
    const Vector3d centre = scan->points.colwise().mean();
    const double reach = (scan->points.rowwise() - centre.transpose()).rowwise().norm().maxCoeff();
    mover.pixelRatio = parts_->canvas->devicePixelRatioF();
    mover.startMoving(parts_->scene.scene().renderer(), centre, kHandleShare * reach);
    parts_->moved = scan;
  }
  if (wanted) mover.setPose(parts_->scene.scan().sceneFromSurface());
  if (!wanted) mover.stopMoving();
  vtkInteractorObserver* style = wanted ? static_cast<vtkInteractorObserver*>(&mover) : parts_->style.Get();
  if (parts_->window->GetInteractor()->GetInteractorStyle() != style)
    parts_->window->GetInteractor()->SetInteractorStyle(style);
}

void CaseView3D::fit() {
  const Eigen::Vector2d size = pixelSize(*parts_->canvas);
  parts_->scene.fit(size.x(), size.y());
  render();
}

std::vector<double> CaseView3D::camera() const {
  vtkCamera* from = parts_->scene.scene().renderer()->GetActiveCamera();
  std::vector<double> numbers;
  for (const double* three : {from->GetPosition(), from->GetFocalPoint(), from->GetViewUp()})
    numbers.insert(numbers.end(), three, three + 3);
  numbers.push_back(from->GetViewAngle());
  return numbers;
}

void CaseView3D::setCamera(const std::vector<double>& camera) {
  if (camera.size() != 10) return;
  parts_->cameraWanted = camera;
  parts_->fitWanted = true;
  followSoon();
}

void CaseView3D::takeCamera() {
  const std::vector<double> wanted = std::exchange(parts_->cameraWanted, {});
  if (wanted.empty()) return;
  const Vector3d position(wanted[0], wanted[1], wanted[2]), focus(wanted[3], wanted[4], wanted[5]),
      up(wanted[6], wanted[7], wanted[8]);
  // A camera that looks nowhere would show nothing.
  const bool looks = (focus - position).norm() > 1e-6 && (focus - position).cross(up).norm() > 1e-6 &&
                     wanted[9] > 0.1 && wanted[9] < 170;
  if (!looks) return;
  vtkCamera* camera = parts_->scene.scene().renderer()->GetActiveCamera();
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focus.data());
  camera->SetViewUp(up.data());
  camera->SetViewAngle(wanted[9]);
  parts_->scene.scene().renderer()->ResetCameraClippingRange();
  render();
}

std::function<void(const std::filesystem::path&)> CaseView3D::picture() {
  follow();
  return pictureOf(parts_->window);
}

void CaseView3D::shareCamera(CaseView3D& other) {
  parts_->scene.scene().renderer()->SetActiveCamera(
      other.parts_->scene.scene().renderer()->GetActiveCamera());
  watchCamera();
  other.watchCamera();
}

/// Draws anew when somebody else has moved the camera; several moves in a row once.
void CaseView3D::watchCamera() {
  if (parts_->renderTimer) return;
  parts_->renderTimer = onceTimer(this, 0, [this] {
    vtkRenderer* renderer = parts_->scene.scene().renderer();
    if (parts_->canvas->isVisible() && renderer->GetActiveCamera()->GetMTime() != parts_->drawnCamera)
      render();
  });
  vtkNew<vtkCallbackCommand> moved;
  moved->SetClientData(parts_->renderTimer);
  moved->SetCallback([](vtkObject*, unsigned long, void* timer, void*) {
    if (!static_cast<QTimer*>(timer)->isActive()) static_cast<QTimer*>(timer)->start(0);
  });
  parts_->camera = parts_->scene.scene().renderer()->GetActiveCamera();
  parts_->cameraWatch = parts_->camera->AddObserver(vtkCommand::ModifiedEvent, moved);
}

void CaseView3D::render() {
  parts_->window->Render();
  parts_->drawnCamera = parts_->scene.scene().renderer()->GetActiveCamera()->GetMTime();
}

QPoint CaseView3D::canvasPosition(const Vector3d& pointInScene) const {
  return canvasPlace(*parts_->canvas, screenPosition(parts_->scene.scene().renderer(), pointInScene));
}

bool CaseView3D::eventFilter(QObject* watched, QEvent* event) {
  if (watched != parts_->canvas) return QWidget::eventFilter(watched, event);
  switch (event->type()) {
    case QEvent::MouseMove: {
      const auto* move = static_cast<QMouseEvent*>(event);
      parts_->mouse = move->pos();
      if (move->buttons() == Qt::NoButton) parts_->probeTimer->start();
      break;
    }
    case QEvent::Leave:
      parts_->probeTimer->stop();
      parts_->probeText->clear();
      break;
    case QEvent::Show:
    case QEvent::Resize:
      if (parts_->fitWanted) followSoon();
      break;
    default:
      break;
  }
  return QWidget::eventFilter(watched, event);
}

void CaseView3D::probe() {
  const Eigen::Vector2d pixel = windowPixel(*parts_->canvas, parts_->mouse);
  parts_->probeText->setText(QString::fromStdString(
      parts_->probe.at(parts_->scene.scene().renderer(), parts_->scene.shown(), pixel.x(), pixel.y())));
}

}  // namespace falciform
