#include "Modules/AtlasUpdate/AtlasUpdatePanel.h"

#include <QLabel>
#include <QVBoxLayout>

namespace falciform {

AtlasUpdatePanel::AtlasUpdatePanel(Workbench& workbench, QWidget* parent)
    : ModulePanel(workbench,
                  tr("Moves tumours and vessels to where the deformed liver has carried them, by a model "
                     "fitted to the scan."),
                  parent) {
  auto* group = addGroup(tr("What this step waits for"));
  needs_ = wrappedLabel("atlasNeeds", this);
  needs_->setTextFormat(Qt::RichText);
  group->addWidget(needs_);
  QLabel* words = wrappedLabel("atlasNotYet", this);
  words->setText(
      tr("The update needs a deformation atlas of this liver: a set of computed deformations under many "
         "supports and postures (thesis ch. V). This version of Falciform cannot build one yet, so there "
         "is nothing to start here. The first four steps do not depend on it."));
  group->addWidget(words);
  start();
}

void AtlasUpdatePanel::enter() {
  bench().view.edit([](ViewOptions& options) {
    options.arrangement = Arrangement::Together;
    options.distanceShown = false;
  });
}

void AtlasUpdatePanel::refresh() {
  const auto line = [](bool have, const QString& text) {
    return QString("%1 %2").arg(have ? QString::fromUtf8("✓") : QString::fromUtf8("–"), text.toHtmlEscaped());
  };
  const bool registered = document().registration() && !document().registrationStale();
  needs_->setText(QStringList{line(document().preop() != nullptr, tr("a pre-operative surface")),
                              line(document().scan() != nullptr, tr("an intra-operative scan")),
                              line(registered, tr("an up-to-date registration of the two")),
                              line(false, tr("a deformation atlas (not in this version)"))}
                      .join("<br>"));
}

}  // namespace falciform
