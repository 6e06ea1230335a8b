#pragma once
#include <QWidget>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

class QTableWidget;

namespace falciform {

/// The labels of a map, each with colour, name and volume: which are liver, which also come in as a vessel or
/// a tumour of their own, and which one the brush paints.
class LabelTable : public QWidget {
  Q_OBJECT

 public:
  explicit LabelTable(QWidget* parent = nullptr);

  using Counts = std::vector<std::pair<int, std::size_t>>;
  /// Labels with their voxels. Ticks, roles and names of labels that were there before stay; new ones are
  /// ticked, and named and understood by `names`.
  void setCounts(const Counts& counts, double voxelMl, const std::map<int, std::string>& names);
  /// Forgets ticks, roles and names: for another map.
  void forget();
  void setColours(const std::map<int, std::array<double, 3>>& colours);

  /// Ticked labels; empty if all are.
  [[nodiscard]] std::vector<int> liverLabels() const;
  /// Labels that also come in by themselves, by name.
  [[nodiscard]] std::map<int, std::string> structures() const;
  /// The label of the chosen row, else 1.
  [[nodiscard]] int paintLabel() const;

 Q_SIGNALS:
  void edited();
  void paintLabelChanged(int label);
  void colourWanted(int label);

 private:
  enum class Role { None, Vessel, Tumour };
  struct Known {
    bool liver = true;
    Role role = Role::None;
    QString name;
  };

  void addRow(int row, int label, std::size_t voxels, double ml);
  void read();
  void paintSwatches();

  QTableWidget* table_;
  std::map<int, Known> known_;
  std::map<int, std::array<double, 3>> colours_;
};

}  // namespace falciform
