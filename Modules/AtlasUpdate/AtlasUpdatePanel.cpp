#include "Modules/AtlasUpdate/AtlasUpdatePanel.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include "Modules/AtlasUpdate/SupportsPage.h"
#include "Modules/AtlasUpdate/UpdatePage.h"

namespace falciform {

AtlasUpdatePanel::AtlasUpdatePanel(Workbench& workbench, QWidget* parent)
    : ModulePanel(
          workbench,
          tr("Where tumours and vessels are now: the liver bent to fit the scan, or as supports would "
             "bend it."),
          parent),
      update_(new UpdatePage(workbench, this)),
      supports_(new SupportsPage(workbench, this)),
      pages_(new QButtonGroup(this)) {
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  const auto add = [&](Page id, const QString& name, const QString& text, const QString& tip) {
    auto* button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setToolTip(tip);
    button->setCheckable(true);
    pages_->addButton(button, id);
    row->addWidget(button, 1);
  };
  add(kUpdate, "pageUpdate", tr("From the scan"),
      tr("Moves the whole pre-operative liver to where the scan shows it to be now; distances in mm"));
  add(kSupports, "pageSupports", tr("Try supports"),
      tr("Paint what holds and pushes the liver, in mm, and see how it would bend; needs no scan"));
  column()->addLayout(row);
  for (ModulePanel* one : {static_cast<ModulePanel*>(update_), static_cast<ModulePanel*>(supports_)}) {
    one->layout()->setContentsMargins(0, 0, 0, 0);
    column()->addWidget(one);
    connect(one, &ModulePanel::pictureWanted, this, &ModulePanel::pictureWanted);
  }
  connect(pages_, &QButtonGroup::idClicked, this, &AtlasUpdatePanel::showPage);
  pages_->button(kUpdate)->setChecked(true);
  supports_->hide();
  start();
}

ModulePanel& AtlasUpdatePanel::page(int id) const {
  return id == kUpdate ? static_cast<ModulePanel&>(*update_) : static_cast<ModulePanel&>(*supports_);
}

void AtlasUpdatePanel::showPage(int id) {
  if (id == shown_) return;
  if (entered_) page(shown_).leave();
  page(shown_).hide();
  shown_ = id;
  page(shown_).show();
  if (entered_) page(shown_).enter();
}

void AtlasUpdatePanel::enter() {
  entered_ = true;
  page(shown_).enter();
}

void AtlasUpdatePanel::leave() {
  entered_ = false;
  page(shown_).leave();
}

}  // namespace falciform
