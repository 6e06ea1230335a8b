#pragma once
#include <QString>
#include <QVector>

namespace falciform {

/// One axis of a plot: takes in values, then says where they lie and where its labelled ticks stand.
class PlotAxis {
 public:
  explicit PlotAxis(bool logarithmic = false) : logarithmic_(logarithmic) {}

  /// Values that are not finite, or not positive on a logarithmic axis, are passed over.
  void include(double value);
  void include(const QVector<double>& values);
  [[nodiscard]] bool empty() const { return low_ > high_; }

  /// Widens to round numbers: call once, after the last include().
  void finish();
  /// 0 at the low end, 1 at the high end.
  [[nodiscard]] double share(double value) const;
  [[nodiscard]] QVector<double> ticks() const;
  [[nodiscard]] static QString label(double tick) { return QString::number(tick, 'g', 4); }

 private:
  bool logarithmic_;
  double low_ = 1e300, high_ = -1e300, step_ = 1;
};

}  // namespace falciform
