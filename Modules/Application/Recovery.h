#pragma once
#include <QLockFile>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <memory>

#include "Modules/Workbench.h"
#include "Widgets/Jobs/LatestRunner.h"

namespace falciform {

/// Keeps what a crash would lose: a while after a change, the case without CT and label map is written into a
/// folder of this session, with a small recovery.json that names where the rest lies. A session that ends
/// well takes its folder away; what stands there of one that did not is offered at the next start.
class Recovery : public QObject {
  Q_OBJECT

 public:
  /// `folder` holds the sessions' folders; the user's data folder if empty.
  Recovery(Workbench& bench, QObject* parent, const QString& folder = {});
  ~Recovery() override;

  static constexpr int kAfterMs = 15000;

  /// Where the case was opened from or saved to; asked when something is kept.
  std::function<QString()> caseFolder;

  /// Writes now if there is something to lose, in the background.
  void keep();
  /// Nothing is to be lost any more: saved, discarded, or closed.
  void forget();

  struct Found {
    QString folder;      ///< of the session that ended badly
    QString name, time;  ///< of its case, and when it was kept
    QString caseFolder, ct, labels;
  };
  /// What sessions that are no longer running have left, newest first.
  [[nodiscard]] QList<Found> left() const;
  /// Takes it away, wanted or not.
  static void remove(const Found& found);
  [[nodiscard]] const QString& session() const { return session_; }

 private:
  Workbench& bench_;
  QString root_, session_;
  std::unique_ptr<QLockFile> lock_;
  QTimer timer_;
  std::unique_ptr<LatestRunner> writer_;
  Connection caseChanged_;
};

}  // namespace falciform
