#include "Modules/SegmentationImport/SeriesChooser.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "Logic/Core/Errors.h"
#include "Modules/Workbench.h"
#include "Widgets/Views/SliceImage.h"

namespace falciform {
namespace {

enum Column { kPicture, kKind, kDescription, kVoxels, kSpacing, kFiles, kColumns };
constexpr int kPictureSize = 96;

/// Grey values as a radiologist sees a liver in a CT; of anything else from its least to its largest value.
QImage pictureOf(const DicomThumbnail& slice, const std::string& modality) {
  const auto [least, largest] = std::minmax_element(slice.values.begin(), slice.values.end());
  const GreyWindow window;
  const bool hounsfield = modality == "CT" && *largest - *least > 300;
  const double black = hounsfield ? window.level - window.width / 2 : static_cast<double>(*least);
  const double range = hounsfield ? window.width : std::max(1e-6, static_cast<double>(*largest - *least));
  QImage image(slice.width, slice.height, QImage::Format_Grayscale8);
  for (int y = 0; y < slice.height; ++y)
    for (int x = 0; x < slice.width; ++x) {
      const double value = slice.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(slice.width) +
                                        static_cast<std::size_t>(x)];
      image.scanLine(y)[x] = static_cast<uchar>(std::clamp(255 * (value - black) / range, 0.0, 255.0));
    }
  return image.scaled(kPictureSize, kPictureSize, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

bool isMask(const DicomThumbnail& slice) {
  const auto [least, largest] = std::minmax_element(slice.values.begin(), slice.values.end());
  return std::all_of(slice.values.begin(), slice.values.end(),
                     [&](float value) { return value == *least || value == *largest; });
}

}  // namespace

DicomChoices readDicomChoices(const std::filesystem::path& path, const Progress& progress) {
  DicomChoices choices;
  choices.listing = listDicom(path, progress.part(0, 0.8));
  for (const DicomSeries& series : choices.listing.series) {
    choices.pictures.emplace_back();
    choices.masks.push_back(series.segmentation);
    try {
      const DicomThumbnail slice = readDicomMiddle(series);
      if (slice.values.empty()) continue;
      choices.pictures.back() = pictureOf(slice, series.modality);
      choices.masks.back() = series.segmentation || isMask(slice);
    } catch (const InputError&) {
      // Without a picture; opening it says why.
    }
  }
  progress.report(1);
  return choices;
}

SeriesChooser::SeriesChooser(DicomChoices choices, Chosen chosen, QWidget* parent)
    : QDialog(parent),
      choices_(std::move(choices)),
      chosen_(std::move(chosen)),
      table_(new QTableWidget(this)),
      notes_(new QLabel(this)),
      asCt_(new QPushButton(tr("Open as CT"), this)),
      asLabels_(new QPushButton(tr("Open as label map"), this)) {
  setObjectName("seriesChooser");
  setWindowTitle(tr("DICOM series"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(860, 420);
  auto* column = new QVBoxLayout(this);
  table_->setObjectName("seriesTable");
  table_->setToolTip(
      tr("Series found in the folder, with their middle slices. Several masks may be chosen together."));
  column->addWidget(table_);
  notes_->setObjectName("seriesNotes");
  notes_->setWordWrap(true);
  column->addWidget(notes_);
  auto* row = new QHBoxLayout;
  asCt_->setObjectName("openAsCt");
  asCt_->setToolTip(tr("The one chosen series becomes the CT of the case, in Hounsfield units"));
  asLabels_->setObjectName("openAsLabels");
  asLabels_->setToolTip(
      tr("A segmentation or masks become the label map; several masks must share one grid"));
  row->addStretch(1);
  row->addWidget(asCt_);
  row->addWidget(asLabels_);
  column->addLayout(row);
  fillTable();
  notes_->setText(notes());
  connect(table_, &QTableWidget::itemSelectionChanged, this, &SeriesChooser::followSelection);
  connect(asCt_, &QPushButton::clicked, this, [this] { choose(FileRole::Ct); });
  connect(asLabels_, &QPushButton::clicked, this, [this] { choose(FileRole::Labels); });
  followSelection();
}

void SeriesChooser::fillTable() {
  const auto& all = choices_.listing.series;
  table_->setColumnCount(kColumns);
  table_->setHorizontalHeaderLabels(
      {tr("Middle slice"), tr("Kind"), tr("Description"), tr("Voxels"), tr("Spacing, mm"), tr("Files")});
  table_->setRowCount(static_cast<int>(all.size()));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->verticalHeader()->setDefaultSectionSize(kPictureSize + 4);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(kDescription, QHeaderView::Stretch);
  table_->setIconSize({kPictureSize, kPictureSize});
  for (int r = 0; r < table_->rowCount(); ++r) {
    const DicomSeries& series = all[static_cast<std::size_t>(r)];
    const Vector3d mm = series.spacingMm();
    const auto put = [&](int column, const QString& text) {
      auto* item = new QTableWidgetItem(text);
      if (!series.refusal.empty()) {
        item->setFlags(Qt::NoItemFlags);
        item->setToolTip(QString::fromStdString(series.refusal));
      }
      table_->setItem(r, column, item);
    };
    const bool mask = choices_.masks[static_cast<std::size_t>(r)] && !series.segmentation;
    put(kPicture, {});
    if (const QImage& picture = choices_.pictures[static_cast<std::size_t>(r)]; !picture.isNull())
      table_->item(r, kPicture)->setData(Qt::DecorationRole, picture);
    put(kKind, QString::fromStdString(series.modality) + (mask ? tr(", mask") : QString()));
    put(kDescription, QString::fromStdString(series.description));
    put(kVoxels, QString("%1 × %2 × %3").arg(series.size.x()).arg(series.size.y()).arg(series.size.z()));
    put(kSpacing,
        QString("%1 × %2 × %3").arg(mm.x(), 0, 'f', 2).arg(mm.y(), 0, 'f', 2).arg(mm.z(), 0, 'f', 2));
    put(kFiles, QString::number(series.files));
  }
}

QString SeriesChooser::notes() const {
  QStringList lines;
  const auto& all = choices_.listing.series;
  for (std::size_t s = 0; s < all.size(); ++s) {
    if (!all[s].refusal.empty())
      lines << tr("Series %1 cannot be read: %2.").arg(s + 1).arg(QString::fromStdString(all[s].refusal));
    for (const std::string& warning : all[s].warnings)
      lines << tr("Series %1: %2.").arg(s + 1).arg(QString::fromStdString(warning));
  }
  for (const std::string& reason : choices_.listing.unreadable) lines << QString::fromStdString(reason) + ".";
  if (choices_.listing.otherFiles > 0)
    lines << tr("%L1 files of other kinds were passed over.").arg(choices_.listing.otherFiles);
  return lines.join('\n');
}

std::vector<DicomSeries> SeriesChooser::selected() const {
  std::vector<DicomSeries> series;
  for (int r = 0; r < table_->rowCount(); ++r)
    if (table_->selectionModel()->isRowSelected(r, {}))
      series.push_back(choices_.listing.series[static_cast<std::size_t>(r)]);
  return series;
}

void SeriesChooser::followSelection() {
  const std::vector<DicomSeries> series = selected();
  const bool segmentation =
      std::any_of(series.begin(), series.end(), [](const DicomSeries& one) { return one.segmentation; });
  asCt_->setEnabled(series.size() == 1 && !segmentation);
  asLabels_->setEnabled(series.size() == 1 || (series.size() > 1 && !segmentation));
}

void SeriesChooser::choose(FileRole role) {
  chosen_(selected(), role);
  accept();
}

void openDicom(Workbench& bench, const std::filesystem::path& path, QWidget* parent) {
  const bool started = bench.runner.start(
      QObject::tr("Reading DICOM"),
      [path](const Progress& progress) { return readDicomChoices(path, progress); },
      [&bench, parent](DicomChoices choices) {
        const auto open = [&bench](std::vector<DicomSeries> series, FileRole role) {
          bench.files.openSeries(std::move(series), role);
        };
        if (choices.listing.series.size() == 1 && choices.listing.series[0].refusal.empty()) {
          for (const std::string& reason : choices.listing.unreadable)
            bench.log.warn(QString::fromStdString(reason));
          const FileRole role = choices.masks[0] ? FileRole::Labels : FileRole::Ct;
          // Queued: the job that has read the headers is still being put away.
          QMetaObject::invokeMethod(
              &bench.runner, [open, series = choices.listing.series, role] { open(series, role); },
              Qt::QueuedConnection);
          return;
        }
        auto* chooser = new SeriesChooser(std::move(choices), open, parent);
        chooser->open();
      });
  if (!started)
    bench.log.warn(QObject::tr("DICOM has to wait: \"%1\" is still running.").arg(bench.runner.title()));
}

}  // namespace falciform
