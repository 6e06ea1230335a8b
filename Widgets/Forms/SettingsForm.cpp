#include "Widgets/Forms/SettingsForm.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QRegularExpressionValidator>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "Widgets/Forms/NumberBox.h"

namespace falciform {
namespace {

QString text(std::string_view view) { return QString::fromUtf8(view.data(), static_cast<int>(view.size())); }

QString number(double value) { return QString::number(value, 'g', 6); }

QString joined(const std::vector<int>& values) {
  QStringList parts;
  for (const int value : values) parts << QString::number(value);
  return parts.join(", ");
}

/// The whole numbers of "1, 2 3" within [min, max]; what is not one is left out.
std::vector<int> numbersIn(const QString& list, double min, double max) {
  std::vector<int> values;
  for (const QString& part : list.split(QRegularExpression("[,\\s]+"), Qt::SkipEmptyParts)) {
    bool isNumber = false;
    const int value = part.toInt(&isNumber);
    if (isNumber && value >= min && value <= max) values.push_back(value);
  }
  return values;
}

/// A spin box that lets the panel scroll past it.
class WholeNumberBox : public QSpinBox {
 public:
  explicit WholeNumberBox(QWidget* parent) : QSpinBox(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setKeyboardTracking(false);
    setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  }

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (hasFocus())
      QSpinBox::wheelEvent(event);
    else
      event->ignore();
  }
};

QString toolTipOf(const FieldInfo& info, bool hasRange, const QString& standard) {
  QString tip = text(info.help);
  if (!info.unit.empty()) tip += QObject::tr("\nUnit: %1").arg(text(info.unit));
  if (hasRange) tip += QObject::tr("\nRange: %1 to %2").arg(number(info.min), number(info.max));
  return tip + QObject::tr("\nDefault: %1").arg(standard);
}

}  // namespace

struct SettingsForm::Rows {
  QFormLayout* open = nullptr;
  QFormLayout* folded = nullptr;
  QWidget* foldedBox = nullptr;
  QToolButton* more = nullptr;
  std::vector<std::function<void()>> refreshes, resets;
  bool ranged = false;  // of the row being added
};

SettingsForm::SettingsForm(QWidget* parent) : QWidget(parent), rows_(std::make_unique<Rows>()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  rows_->open = new QFormLayout;
  column->addLayout(rows_->open);
  rows_->more = new QToolButton(this);
  rows_->more->setObjectName("moreSettings");
  rows_->more->setText(tr("More settings"));
  rows_->more->setToolTip(tr("Show or hide the settings that are seldom changed"));
  rows_->more->setCheckable(true);
  rows_->more->setAutoRaise(true);
  rows_->more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  rows_->more->setArrowType(Qt::RightArrow);
  auto* defaults = new QToolButton(this);
  defaults->setObjectName("resetToDefaults");
  defaults->setText(tr("Defaults"));
  defaults->setToolTip(tr("Set every setting of this form back to its default"));
  defaults->setAutoRaise(true);
  connect(defaults, &QToolButton::clicked, this, &SettingsForm::resetToDefaults);
  auto* row = new QHBoxLayout;
  row->addWidget(rows_->more);
  row->addStretch(1);
  row->addWidget(defaults);
  column->addLayout(row);
  rows_->foldedBox = new QWidget(this);
  rows_->folded = new QFormLayout(rows_->foldedBox);
  rows_->folded->setContentsMargins(12, 0, 0, 0);
  column->addWidget(rows_->foldedBox);
  connect(rows_->more, &QToolButton::toggled, this, &SettingsForm::setMoreShown);
  setMoreShown(false);
}

SettingsForm::~SettingsForm() = default;

void SettingsForm::setMoreShown(bool shown) {
  rows_->more->setChecked(shown);
  rows_->more->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
  rows_->foldedBox->setVisible(shown);
}

void SettingsForm::finish() {
  rows_->more->setVisible(rows_->folded->rowCount() > 0);
  refresh();
}

void SettingsForm::refresh() {
  for (const auto& refreshControl : rows_->refreshes) refreshControl();
}

void SettingsForm::resetToDefaults() {
  for (const auto& reset : rows_->resets) reset();
  refresh();
  Q_EMIT edited({});
}

void SettingsForm::addReset(std::function<void()> reset) { rows_->resets.push_back(std::move(reset)); }

void SettingsForm::addRow(const FieldInfo& info, bool open, QWidget* control, const QString& standard,
                          std::function<void()> refreshControl) {
  control->setObjectName(text(info.key));
  control->setToolTip(toolTipOf(info, rows_->ranged, standard));
  control->setAccessibleName(text(info.label));
  rows_->ranged = false;
  QFormLayout* layout = open ? rows_->open : rows_->folded;
  if (qobject_cast<QCheckBox*>(control))
    layout->addRow(control);
  else
    layout->addRow(text(info.label), control);
  if (QWidget* label = layout->labelForField(control)) label->setToolTip(control->toolTip());
  rows_->refreshes.push_back([control, refreshControl = std::move(refreshControl)] {
    const QSignalBlocker quiet(control);
    refreshControl();
  });
}

void SettingsForm::add(const FieldInfo& info, bool open, bool& value, bool standard) {
  auto* box = new QCheckBox(text(info.label), this);
  connect(box, &QCheckBox::toggled, this, [this, &value, key = text(info.key)](bool on) {
    value = on;
    Q_EMIT edited(key);
  });
  addRow(info, open, box, standard ? tr("on") : tr("off"), [box, &value] { box->setChecked(value); });
}

void SettingsForm::add(const FieldInfo& info, bool open, int& value, int standard) {
  auto* box = new WholeNumberBox(this);
  box->setRange(static_cast<int>(info.min), static_cast<int>(info.max));
  if (!info.unit.empty()) box->setSuffix(" " + text(info.unit));
  connect(box, qOverload<int>(&QSpinBox::valueChanged), this, [this, &value, key = text(info.key)](int now) {
    value = now;
    Q_EMIT edited(key);
  });
  rows_->ranged = true;
  addRow(info, open, box, QString::number(standard), [box, &value] { box->setValue(value); });
}

void SettingsForm::add(const FieldInfo& info, bool open, double& value, double standard) {
  auto* box = new NumberBox(this);
  box->setRange(info.min, info.max);
  if (!info.unit.empty()) box->setSuffix(" " + text(info.unit));
  connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
          [this, &value, key = text(info.key)](double now) {
            value = now;
            Q_EMIT edited(key);
          });
  rows_->ranged = true;
  addRow(info, open, box, number(standard), [box, &value] { box->setValue(value); });
}

void SettingsForm::add(const FieldInfo& info, bool open, std::string& value, const std::string& standard) {
  auto* line = new QLineEdit(this);
  connect(line, &QLineEdit::textChanged, this, [this, &value, key = text(info.key)](const QString& now) {
    value = now.toStdString();
    Q_EMIT edited(key);
  });
  addRow(info, open, line, QString::fromStdString(standard),
         [line, &value] { line->setText(QString::fromStdString(value)); });
}

void SettingsForm::add(const FieldInfo& info, bool open, std::vector<int>& value,
                       const std::vector<int>& standard) {
  auto* line = new QLineEdit(this);
  line->setValidator(new QRegularExpressionValidator(QRegularExpression("[0-9,\\s]*"), line));
  line->setPlaceholderText(tr("all"));
  connect(line, &QLineEdit::textChanged, this,
          [this, &value, key = text(info.key), min = info.min, max = info.max](const QString& now) {
            value = numbersIn(now, min, max);
            Q_EMIT edited(key);
          });
  rows_->ranged = true;
  addRow(info, open, line, standard.empty() ? tr("all") : joined(standard),
         [line, &value] { line->setText(joined(value)); });
}

void SettingsForm::addChoice(const FieldInfo& info, bool open, std::span<const std::string_view> names,
                             int standard, std::function<int()> get, std::function<void(int)> set) {
  auto* box = new QComboBox(this);
  for (const std::string_view name : names) box->addItem(text(name));
  connect(box, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this, set = std::move(set), key = text(info.key)](int index) {
            set(index);
            Q_EMIT edited(key);
          });
  addRow(info, open, box, box->itemText(standard),
         [box, get = std::move(get)] { box->setCurrentIndex(get()); });
}

}  // namespace falciform
