#include "Widgets/Rendering/RenderedImage.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>

#include "Logic/IO/ImageFiles.h"
#include "Version.h"

namespace falciform {

namespace {

/// VTK's images have row 0 at the bottom.
RenderedImage fromVtkImage(vtkImageData* data) {
  const int* size = data->GetDimensions();
  RenderedImage image{size[0], size[1], {}};
  image.rgb.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 3);
  const int components = data->GetNumberOfScalarComponents();
  auto to = image.rgb.begin();
  for (int y = image.height - 1; y >= 0; --y)
    for (int x = 0; x < image.width; ++x) {
      const auto* from = static_cast<const std::uint8_t*>(data->GetScalarPointer(x, y, 0));
      for (int c = 0; c < 3; ++c) *to++ = from[components >= 3 ? c : 0];
    }
  return image;
}

}  // namespace

RenderedImage grab(vtkRenderWindow* window) {
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->ReadFrontBufferOff();
  filter->ShouldRerenderOff();
  filter->Update();
  return fromVtkImage(filter->GetOutput());
}

RenderedImage halved(const RenderedImage& image) {
  RenderedImage half{image.width / 2, image.height / 2, {}};
  half.rgb.reserve(image.rgb.size() / 4);
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        const int sum = image.at(2 * x, 2 * y)[c] + image.at(2 * x + 1, 2 * y)[c] +
                        image.at(2 * x, 2 * y + 1)[c] + image.at(2 * x + 1, 2 * y + 1)[c];
        half.rgb.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
      }
  return half;
}

void savePng(const RenderedImage& image, const std::filesystem::path& file, Overwrite overwrite) {
  writePng(file, image, overwrite, {{"Disclaimer", kResearchUse}});
}

RenderedImage readPng(const std::filesystem::path& file) { return readColourImage(file); }

}  // namespace falciform
