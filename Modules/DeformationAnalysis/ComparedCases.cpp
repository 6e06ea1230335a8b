#include "Modules/DeformationAnalysis/ComparedCases.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include "Modules/DeformationAnalysis/CaseMaps.h"

namespace falciform {
namespace {

constexpr std::size_t kNamesShown = 4;

QPushButton* button(const char* name, const QString& text, const QString& tip, QWidget* parent) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setToolTip(tip);
  return made;
}

}  // namespace

ComparedCases::ComparedCases(Workbench& bench, std::function<DistanceSettings()> settings, QWidget* parent)
    : QWidget(parent),
      bench_(bench),
      settings_(std::move(settings)),
      compare_(button("compareWith", tr("Compare with…"),
                      tr("Open another case's folder and show its map beside this one's: same colours, same "
                         "camera. A map that it does not hold is computed."),
                      this)),
      cohort_(button("openCohort", tr("Cohort…"),
                     tr("Show all cases of a folder as tiles: case folders, results of `falciform distance` "
                        "or `falciform cohort`, "
                        "or maps (.vtp)"),
                     this)),
      clear_(button("clearCompared", tr("Clear"), tr("Put the other cases away; their files stay"), this)),
      sideBySide_(new QCheckBox(tr("side by side"), this)),
      names_(new QLabel(this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  for (QPushButton* one : {compare_, cohort_, clear_}) row->addWidget(one);
  column->addLayout(row);
  sideBySide_->setObjectName("sideBySide");
  sideBySide_->setToolTip(
      tr("Show the cases beside each other in place of the one; a click on a tile shows it "
         "large"));
  column->addWidget(sideBySide_);
  names_->setObjectName("comparedNames");
  names_->setWordWrap(true);
  column->addWidget(names_);
  connect(compare_, &QPushButton::clicked, this, [this] { choose(tr("Compare with the case in")); });
  connect(cohort_, &QPushButton::clicked, this, [this] { choose(tr("Show the cases in")); });
  connect(clear_, &QPushButton::clicked, this, [this] {
    cases_.clear();
    sideBySide_->setChecked(false);
    refresh();
    Q_EMIT changed();
  });
  connect(sideBySide_, &QCheckBox::toggled, this, [this] { Q_EMIT changed(); });
  refresh();
}

bool ComparedCases::sideBySide() const { return sideBySide_->isChecked() && !cases_.empty(); }

void ComparedCases::refresh() {
  const bool idle = !bench_.runner.busy();
  compare_->setEnabled(idle);
  cohort_->setEnabled(idle);
  clear_->setEnabled(!cases_.empty());
  sideBySide_->setEnabled(!cases_.empty());
  QStringList names;
  for (std::size_t i = 0; i < std::min(kNamesShown, cases_.size()); ++i)
    names << QString::fromStdString(cases_[i].name);
  if (cases_.size() > kNamesShown) names << tr("and %1 more").arg(cases_.size() - kNamesShown);
  names_->setText(names.join(", "));
  names_->setVisible(!names.isEmpty());
}

void ComparedCases::choose(const QString& title) {
  QSettings settings;
  const QString folder =
      QFileDialog::getExistingDirectory(this, title, settings.value("lastFolder").toString());
  if (folder.isEmpty()) return;
  settings.setValue("lastFolder", QFileInfo(folder).absolutePath());
  open(folder);
}

void ComparedCases::open(const QString& place) {
  bench_.runner.start(
      tr("Opening cases to compare"),
      [path = std::filesystem::path(place.toStdString()), settings = settings_()](const Progress& progress) {
        return loadCaseMaps(mapSourcesIn(path), settings, progress);
      },
      [this](CaseMaps maps) {
        for (const std::string& warning : maps.warnings) bench_.log.warn(QString::fromStdString(warning));
        bench_.log.info(tr("Cases opened to compare: %1.").arg(maps.cases.size()));
        cases_.insert(cases_.end(), maps.cases.begin(), maps.cases.end());
        {
          const QSignalBlocker quiet(sideBySide_);
          sideBySide_->setChecked(true);
        }
        refresh();
        Q_EMIT changed();
      });
}

}  // namespace falciform
