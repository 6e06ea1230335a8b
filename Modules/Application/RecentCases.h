#pragma once
#include <QMenu>
#include <QObject>
#include <QStringList>

namespace falciform {

/// The case folders opened or saved last, newest first, kept in the user's settings.
class RecentCases : public QObject {
  Q_OBJECT

 public:
  static constexpr int kMost = 8;

  using QObject::QObject;

  [[nodiscard]] QStringList folders() const;
  void add(const QString& folder);
  /// Fills `menu` whenever it is about to show; folders that are gone are left out.
  void fill(QMenu* menu);

 Q_SIGNALS:
  void chosen(const QString& folder);
};

}  // namespace falciform
