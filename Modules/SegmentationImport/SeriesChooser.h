#pragma once
#include <QDialog>
#include <QImage>
#include <filesystem>
#include <functional>
#include <vector>

#include "Logic/IO/DicomSeries.h"
#include "Widgets/Jobs/FileGuess.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace falciform {

struct Workbench;

/// What a DICOM folder holds, to choose from.
struct DicomChoices {
  DicomListing listing;
  std::vector<QImage> pictures;  ///< the middle slice of each series; null where it cannot be read
  std::vector<bool> masks;       ///< whether that slice has two values at most
};

/// Headers and middle slices of a folder, or of the series of a file. Throws InputError as listDicom does.
[[nodiscard]] DicomChoices readDicomChoices(const std::filesystem::path& folderOrFile,
                                            const Progress& progress);

/// The series of a DICOM folder with a picture of each; one is opened as CT, one or several masks as label
/// map.
class SeriesChooser : public QDialog {
  Q_OBJECT

 public:
  using Chosen = std::function<void(std::vector<DicomSeries> series, FileRole role)>;

  SeriesChooser(DicomChoices choices, Chosen chosen, QWidget* parent = nullptr);

 private:
  void fillTable();
  [[nodiscard]] QString notes() const;
  [[nodiscard]] std::vector<DicomSeries> selected() const;
  void followSelection();
  void choose(FileRole role);

  DicomChoices choices_;
  Chosen chosen_;
  QTableWidget* table_;
  QLabel* notes_;
  QPushButton *asCt_, *asLabels_;
};

/// Reads a DICOM folder or file as a job; a single series is opened as what it is, of several the user
/// chooses.
void openDicom(Workbench& bench, const std::filesystem::path& folderOrFile, QWidget* parent);

}  // namespace falciform
