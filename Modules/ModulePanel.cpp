#include "Modules/ModulePanel.h"

#include <QFileDialog>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>

#include "Widgets/Forms/PanelControls.h"

namespace falciform {

ModulePanel::ModulePanel(Workbench& workbench, const QString& purpose, QWidget* parent)
    : QWidget(parent), bench_(workbench), column_(new QVBoxLayout(this)) {
  column_->setContentsMargins(8, 8, 8, 8);
  column_->setSpacing(8);
  QLabel* words = wrappedLabel("purpose", this);
  words->setText(purpose);
  column_->addWidget(words);
}

ModulePanel::~ModulePanel() = default;

void ModulePanel::start() {
  column_->addStretch(1);
  caseConnection_ = document().changed.connect([this](Case::Part part) {
    caseChanged(part);
    refresh();
  });
  connect(&bench_.runner, &JobRunner::started, this, [this] { refresh(); });
  connect(&bench_.runner, &JobRunner::finished, this, [this] { refresh(); });
  refresh();
}

QVBoxLayout* ModulePanel::addGroup(const QString& title) {
  auto* group = new QGroupBox(title, this);
  auto* layout = new QVBoxLayout(group);
  column_->addWidget(group);
  return layout;
}

QLabel* ModulePanel::wrappedLabel(const QString& name, QWidget* parent) {
  return falciform::wrappedLabel(name, parent);
}

void ModulePanel::showReadiness(QPushButton* button, QLabel* words, const std::string& missing) {
  const bool busy = bench_.runner.busy();
  button->setEnabled(missing.empty() && !busy);
  words->setText(!missing.empty() ? QString::fromStdString(missing)
                 : busy           ? tr("\"%1\" is running.").arg(bench_.runner.title())
                                  : QString());
  words->setVisible(!words->text().isEmpty());
}

QString ModulePanel::askForFile(const QString& title, const QString& filter) {
  QSettings settings;
  const QString file =
      QFileDialog::getOpenFileName(this, title, settings.value("lastFolder").toString(), filter);
  if (!file.isEmpty()) settings.setValue("lastFolder", QFileInfo(file).absolutePath());
  return file;
}

void ModulePanel::showWarnings(QLabel* label, const std::vector<std::string>& warnings) {
  QStringList lines;
  for (const std::string& warning : warnings)
    lines << QString::fromUtf8("⚠ ") + QString::fromStdString(warning);
  label->setText(lines.join("\n"));
  label->setVisible(!lines.isEmpty());
}

}  // namespace falciform
