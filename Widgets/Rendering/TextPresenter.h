#pragma once
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <string>

#include "Logic/Core/Types.h"

namespace falciform {

enum class TextPlace { TopCentre, TopLeft, BottomLeft, BottomCentre };

/// A line or two of text at a fixed place of the view: a title, a note, the research notice.
class TextPresenter {
 public:
  TextPresenter(vtkRenderer* renderer, TextPlace place, int px, const Vector3d& colour, int linesUp = 0);
  ~TextPresenter();
  TextPresenter(const TextPresenter&) = delete;
  TextPresenter& operator=(const TextPresenter&) = delete;

  void setText(const std::string& text);
  void setBold(bool bold);

 private:
  vtkSmartPointer<vtkRenderer> renderer_;
  vtkSmartPointer<vtkTextActor> actor_;
};

}  // namespace falciform
