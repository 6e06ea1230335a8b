#pragma once
#include <QWidget>

#include "Widgets/Views/CaseView3D.h"

class QSplitter;

namespace falciform {

class CaseSlices;
class MapGalleryView;

/// The middle of the window: the 3D view; where the ViewState asks for it a second one beside it that looks
/// from the same place, and cuts through the CT below; or several cases' maps in its place. The extra views
/// are made when they are first wanted.
class CaseViews : public QWidget {
  Q_OBJECT

 public:
  CaseViews(Case& document, ViewState& view, PatchPaintingLogic& painting, QWidget* parent = nullptr);

  ~CaseViews() override;

  [[nodiscard]] CaseView3D* main() const { return main_; }
  [[nodiscard]] CaseView3D* compared() const { return compared_; }    ///< nullptr until it is first wanted
  [[nodiscard]] CaseSlices* slices() const { return slices_; }        ///< the same
  [[nodiscard]] MapGalleryView* gallery() const { return gallery_; }  ///< the same
  /// Of what is shown now, as CaseView3D::picture().
  [[nodiscard]] std::function<void(const std::filesystem::path&)> picture();

 private:
  void follow();

  Case& case_;
  ViewState& view_;
  PatchPaintingLogic& painting_;
  ViewState comparedView_;  // before the view that follows it
  QSplitter *rows_, *columns_;
  CaseView3D *main_, *compared_ = nullptr;
  CaseSlices* slices_ = nullptr;
  MapGalleryView* gallery_ = nullptr;
  bool largeSlices_ = false;
  Connection viewChanged_;
};

}  // namespace falciform
