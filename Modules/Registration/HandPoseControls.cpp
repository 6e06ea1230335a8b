#include "Modules/Registration/HandPoseControls.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "Widgets/Forms/NumberBox.h"
#include "Widgets/Rendering/PoseHandlesPresenter.h"

namespace falciform {
namespace {

constexpr double kSmallestStep = 0.1, kLargestShiftMm = 100, kLargestTurnDeg = 180;

NumberBox* stepBox(const char* name, const QString& suffix, const QString& tip, double largest,
                   QWidget* parent) {
  auto* box = new NumberBox(parent);
  box->setObjectName(name);
  box->setRange(kSmallestStep, largest);
  box->setValue(5);
  box->setSuffix(suffix);
  box->setToolTip(tip);
  return box;
}

}  // namespace

HandPoseControls::HandPoseControls(QWidget* parent)
    : QWidget(parent),
      move_(new QPushButton(tr("Move by hand"), this)),
      register_(new QPushButton(tr("Register from here"), this)),
      reset_(new QPushButton(tr("Reset"), this)),
      steps_(nullptr),
      stepMm_(stepBox("stepMm", " mm", tr("One step of a shift\nUnit: mm\nRange: 0.1 to 100\nDefault: 5"),
                      kLargestShiftMm, this)),
      stepDeg_(stepBox("stepDeg", QString::fromUtf8("°"),
                       tr("One step of a turn\nUnit: degrees\nRange: 0.1 to 180\nDefault: 5"),
                       kLargestTurnDeg, this)),
      words_(new QLabel(this)) {
  move_->setObjectName("moveByHand");
  move_->setCheckable(true);
  move_->setToolTip(
      tr("Place the scan yourself: drag a ring in the view to turn it, an arrow to shift it, or use the "
         "buttons below.\nArrow keys over the view shift by a step, with Shift they turn; Esc leaves"));
  register_->setObjectName("registerFromHere");
  register_->setToolTip(tr("Register from the pose set by hand, without looking elsewhere"));
  reset_->setObjectName("resetHandPose");
  reset_->setToolTip(tr("Forget the pose set by hand: the start is as before"));
  words_->setObjectName("handMissing");
  words_->setWordWrap(true);
  steps_ = stepGrid();
  auto* top = new QHBoxLayout;
  top->addWidget(move_, 1);
  top->addWidget(register_, 1);
  top->addWidget(reset_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(top);
  column->addWidget(words_);
  column->addWidget(steps_);
  connect(move_, &QPushButton::clicked, this, &HandPoseControls::toggled);
  connect(register_, &QPushButton::clicked, this, &HandPoseControls::registerWanted);
  connect(reset_, &QPushButton::clicked, this, &HandPoseControls::resetWanted);
  for (NumberBox* box : {stepMm_, stepDeg_})
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &HandPoseControls::stepsChanged);
}

QWidget* HandPoseControls::stepGrid() {
  auto* grid = new QWidget(this);
  auto* layout = new QGridLayout(grid);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setHorizontalSpacing(3);
  const QStringList axes{"X", "Y", "Z"}, towards{tr("left"), tr("back"), tr("head")},
      away{tr("right"), tr("front"), tr("feet")};
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d colour = axisColour(axis);
    auto* title = new QLabel(tr("%1: %2").arg(axes[axis], towards[axis]), grid);
    title->setAlignment(Qt::AlignCenter);
    title->setStyleSheet(QString("font-weight: bold; color: %1")
                             .arg(QColor::fromRgbF(colour.x(), colour.y(), colour.z()).name()));
    layout->addWidget(title, 0, 1 + 2 * axis, 1, 2);
    for (const bool turns : {false, true}) {
      for (const int sign : {-1, 1}) {
        auto* button = new QToolButton(grid);
        button->setObjectName((turns ? "turn" : "shift") + axes[axis] + (sign < 0 ? "Minus" : "Plus"));
        button->setText(sign < 0 ? QString::fromUtf8("−") : "+");
        button->setAutoRepeat(true);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        const QString where = sign < 0 ? away[axis] : towards[axis];
        button->setToolTip(turns
                               ? tr("Turn the scan by one step about the %1 axis, %2\nUnit: degrees")
                                     .arg(axes[axis], sign < 0 ? tr("clockwise as seen from its + side")
                                                               : tr("anticlockwise as seen from its + side"))
                               : tr("Shift the scan by one step to the patient's %1\nUnit: mm").arg(where));
        layout->addWidget(button, turns ? 2 : 1, 1 + 2 * axis + (sign > 0));
        connect(button, &QToolButton::clicked, this, [this, axis, sign, turns] {
          if (turns)
            Q_EMIT turnWanted(axis, sign);
          else
            Q_EMIT shiftWanted(axis, sign);
        });
      }
    }
  }
  layout->addWidget(new QLabel(tr("Shift"), grid), 1, 0);
  layout->addWidget(new QLabel(tr("Turn"), grid), 2, 0);
  layout->addWidget(new QLabel(tr("Step"), grid), 0, 7);
  layout->addWidget(stepMm_, 1, 7);
  layout->addWidget(stepDeg_, 2, 7);
  return grid;
}

double HandPoseControls::stepMm() const { return stepMm_->value(); }
double HandPoseControls::stepDeg() const { return stepDeg_->value(); }

void HandPoseControls::show(bool on, bool placed, const QString& missing, bool busy) {
  const bool possible = missing.isEmpty();
  move_->setChecked(on);
  move_->setEnabled(possible && !busy);
  register_->setVisible(placed);
  register_->setEnabled(!busy);
  reset_->setVisible(placed);
  reset_->setEnabled(!busy);
  steps_->setVisible(on);
  words_->setText(possible ? QString() : tr("To move it by hand: %1").arg(missing));
  words_->setVisible(!possible);
}

}  // namespace falciform
