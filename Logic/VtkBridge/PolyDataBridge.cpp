#include "Logic/VtkBridge/PolyDataBridge.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace falciform {

namespace {

template <class Array, class Rows>
vtkSmartPointer<Array> arrayOf(const char* name, const Rows& rows) {
  const auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(rows.cols()));
  array->SetNumberOfTuples(rows.rows());
  std::copy(rows.data(), rows.data() + rows.size(), array->GetPointer(0));
  return array;
}

/// All cells of one width, e.g. triangles; `ids` are the point ids, cell by cell.
vtkSmartPointer<vtkCellArray> cellsOf(vtkIdType count, vtkIdType width, vtkIdTypeArray* ids) {
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType i = 0; i <= count; ++i) offsets->SetValue(i, i * width);
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, ids);
  return cells;
}

void addCells(vtkPolyData* data, const Surface& surface) {
  vtkNew<vtkIdTypeArray> ids;
  if (surface.triangles.rows() > 0) {
    ids->SetNumberOfValues(surface.triangles.size());
    std::copy(surface.triangles.data(), surface.triangles.data() + surface.triangles.size(),
              ids->GetPointer(0));
    data->SetPolys(cellsOf(surface.triangles.rows(), 3, ids));
  } else {
    ids->SetNumberOfValues(surface.size());
    for (vtkIdType i = 0; i < surface.size(); ++i) ids->SetValue(i, i);
    data->SetVerts(cellsOf(surface.size(), 1, ids));
  }
}

void addTexts(vtkPolyData* data, const char* name, const std::vector<std::string>& texts) {
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& text : texts) array->InsertNextValue(text);
  data->GetFieldData()->AddArray(array);
}

}  // namespace

vtkSmartPointer<vtkPolyData> toVtk(const Surface& surface) {
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(arrayOf<vtkDoubleArray>("Points", surface.points));
  data->SetPoints(points);
  addCells(data, surface);

  vtkPointData* values = data->GetPointData();
  for (const auto& [name, array] : surface.arrays)
    values->AddArray(arrayOf<vtkDoubleArray>(name.c_str(), array));
  if (!surface.patch.empty()) {
    vtkNew<vtkUnsignedCharArray> labels;
    labels->SetName("Patch");
    labels->SetNumberOfValues(static_cast<vtkIdType>(surface.patch.size()));
    std::transform(surface.patch.begin(), surface.patch.end(), labels->GetPointer(0),
                   [](int label) { return static_cast<unsigned char>(label); });
    values->AddArray(labels);
  }
  if (surface.colours.rows() > 0) values->AddArray(arrayOf<vtkUnsignedCharArray>("RGB", surface.colours));
  if (surface.texture && surface.textureAt.rows() > 0)
    values->SetTCoords(arrayOf<vtkFloatArray>("TCoords", surface.textureAt));
  if (surface.normals.rows() > 0) values->SetNormals(arrayOf<vtkDoubleArray>("Normals", surface.normals));

  addTexts(data, "SPACE", {surface.frame});
  if (!surface.patchNames.empty()) {
    std::vector<std::string> names;
    for (const auto& [label, name] : surface.patchNames) names.push_back(std::to_string(label) + "=" + name);
    addTexts(data, "PatchNames", names);
  }
  return data;
}

}  // namespace falciform
