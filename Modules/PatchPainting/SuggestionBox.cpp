#include "Modules/PatchPainting/SuggestionBox.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace falciform {
namespace {

QPushButton* button(const char* name, const QString& text, const QString& tip, QWidget* parent) {
  auto* made = new QPushButton(text, parent);
  made->setObjectName(name);
  made->setToolTip(tip);
  return made;
}

}  // namespace

SuggestionBox::SuggestionBox(Workbench& bench, QWidget* parent)
    : QWidget(parent),
      bench_(bench),
      look_(
          button("suggest", tr("Suggest ridge and &groove"),
                 tr("Looks for the inferior ridge and the falciform groove on the pre-operative liver; takes "
                    "some seconds.\nA suggestion is drawn as a line and painted only when it is accepted"),
                 this)),
      accept_(button("acceptSuggestion", tr("Accep&t"),
                     tr("Paints the suggestion that is drawn, 12 mm wide; change it afterwards with any "
                        "tool, or undo it"),
                     this)),
      drop_(button("dropSuggestion", tr("Drop"), tr("Takes the drawn line away"), this)),
      list_(new QComboBox(this)),
      words_(new QLabel(this)) {
  list_->setObjectName("suggestions");
  list_->setToolTip(tr("What was found, the likeliest first; choosing one draws it"));
  list_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  list_->setMinimumContentsLength(12);
  words_->setObjectName("suggestionWords");
  words_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(look_);
  auto* row = new QHBoxLayout;
  row->addWidget(list_, 1);
  row->addWidget(accept_);
  row->addWidget(drop_);
  column->addLayout(row);
  column->addWidget(words_);
  connect(look_, &QPushButton::clicked, this, &SuggestionBox::look);
  connect(list_, qOverload<int>(&QComboBox::activated), this, &SuggestionBox::show);
  connect(accept_, &QPushButton::clicked, this, &SuggestionBox::accept);
  connect(drop_, &QPushButton::clicked, this, [this] { show(-1); });
}

void SuggestionBox::look() {
  const auto liver = bench_.document.preop();
  if (!liver) return;
  bench_.runner.start(
      tr("Looking for ridge and groove"),
      [liver](const Progress& progress) { return suggestFeatures(*liver, {}, lpsAxes(), progress); },
      [this, liver](FeatureSuggestions found) { take(liver, std::move(found)); });
}

void SuggestionBox::take(const std::shared_ptr<const Surface>& of, FeatureSuggestions found) {
  of_ = of;
  found_ = std::move(found.ridge);
  found_.insert(found_.end(), std::make_move_iterator(found.groove.begin()),
                std::make_move_iterator(found.groove.end()));
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const FeatureSuggestion& one : found_)
      list_->addItem(tr("%1, %2 mm (%3 %)")
                         .arg(QString::fromStdString(one.what))
                         .arg(one.lengthMm, 0, 'f', 0)
                         .arg(100 * one.score, 0, 'f', 0));
  }
  QStringList words;
  for (const std::string& warning : found.warnings) {
    words << QString::fromUtf8("⚠ ") + QString::fromStdString(warning);
    bench_.log.warn(QString::fromStdString(warning));
  }
  if (found_.empty()) words << tr("Nothing was found: paint by hand.");
  words_->setText(words.join("\n"));
  bench_.log.info(tr("Found %1 suggestions for ridge and groove.").arg(found_.size()));
  show(found_.empty() ? -1 : 0);
}

void SuggestionBox::show(int index) {
  list_->setCurrentIndex(std::max(index, found_.empty() ? -1 : 0));
  bench_.view.edit([&](ViewOptions& options) {
    options.suggestedLine.reset();
    if (index < 0 || static_cast<std::size_t>(index) >= found_.size()) return;
    const FeatureSuggestion& one = found_[static_cast<std::size_t>(index)];
    options.suggestedLine = std::make_shared<const Points>(one.line);
    options.suggestedLabel = one.label;
  });
  refresh();
}

void SuggestionBox::accept() {
  const int index = list_->currentIndex();
  if (index < 0 || static_cast<std::size_t>(index) >= found_.size()) return;
  const FeatureSuggestion one = found_[static_cast<std::size_t>(index)];
  PatchChange change;
  change.gained = one.vertices;
  if (bench_.painting.apply(change, one.label).empty())
    bench_.log.info(tr("Nothing to paint: it is painted already, or locked."));
  // On to the first of the other feature, which is what one does next.
  int next = -1;
  for (std::size_t i = 0; i < found_.size() && next < 0; ++i)
    if (found_[i].label != one.label && index < static_cast<int>(i)) next = static_cast<int>(i);
  show(next);
  Q_EMIT accepted(one.label);
}

void SuggestionBox::refresh() {
  const auto& liver = bench_.document.preop();
  const bool same =
      of_ && liver && of_->points.rows() == liver->points.rows() && of_->points == liver->points;
  if (of_ && !same) {  // they were of another liver
    of_.reset();
    found_.clear();
    list_->clear();
    words_->clear();
    bench_.view.edit([](ViewOptions& options) { options.suggestedLine.reset(); });
  }
  const bool onLiver = bench_.painting.target == PaintTarget::Preop;
  look_->setEnabled(liver && liver->triangles.rows() > 0 && onLiver && !bench_.runner.busy());
  for (QWidget* one :
       {static_cast<QWidget*>(list_), static_cast<QWidget*>(accept_), static_cast<QWidget*>(drop_)})
    one->setVisible(!found_.empty() && onLiver);
  accept_->setEnabled(bench_.view.options().suggestedLine != nullptr);
  drop_->setEnabled(bench_.view.options().suggestedLine != nullptr);
  words_->setVisible(onLiver && !words_->text().isEmpty());
}

}  // namespace falciform
