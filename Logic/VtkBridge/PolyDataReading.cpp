#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolygon.h>
#include <vtkStringArray.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "Logic/Core/Errors.h"
#include "Logic/VtkBridge/PolyDataBridge.h"

namespace falciform {

namespace {

/// A damaged file may hold offsets that run backwards or past the ids: VTK itself would then read outside its
/// memory.
void checkCells(vtkCellArray* cells, vtkIdType points) {
  vtkDataArray* offsets = cells->GetOffsetsArray();
  vtkDataArray* ids = cells->GetConnectivityArray();
  const auto refuse = [](const std::string& found) {
    throw InputError("the cells of the surface are damaged (" + found + "); export it again");
  };
  double last = 0;
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i) {
    const double offset = offsets->GetTuple1(i);
    if (!(offset >= last) || offset > static_cast<double>(ids->GetNumberOfValues()) ||
        (i == 0 && offset != 0))
      refuse("cell " + std::to_string(i) + " ends where it should not");
    last = offset;
  }
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
    if (const double id = ids->GetTuple1(i); !(id >= 0 && id < static_cast<double>(points)))
      refuse("a cell names point " + std::to_string(static_cast<long long>(id)) + " of " +
             std::to_string(points));
}

class TriangleList {
 public:
  /// Degenerate triangles, which strips hold by design, have no area and are left out.
  void add(vtkIdType a, vtkIdType b, vtkIdType c) {
    if (a != b && b != c && c != a)
      ids_.insert(ids_.end(), {static_cast<int>(a), static_cast<int>(b), static_cast<int>(c)});
  }
  [[nodiscard]] Triangles rows() const {
    return Eigen::Map<const Triangles>(ids_.data(), static_cast<Index>(ids_.size() / 3), 3);
  }

 private:
  std::vector<int> ids_;
};

void addPolygon(TriangleList& triangles, vtkPoints* points, vtkIdType count, const vtkIdType* ids) {
  if (count == 3) return triangles.add(ids[0], ids[1], ids[2]);
  vtkNew<vtkPolygon> polygon;  // cuts concave polygons rightly
  polygon->GetPointIds()->SetNumberOfIds(count);
  polygon->GetPoints()->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i) {
    polygon->GetPointIds()->SetId(i, ids[i]);
    polygon->GetPoints()->SetPoint(i, points->GetPoint(ids[i]));
  }
  vtkNew<vtkIdList> cut;
  if (polygon->Triangulate(cut) && cut->GetNumberOfIds() == 3 * (count - 2))
    for (vtkIdType i = 0; i < cut->GetNumberOfIds(); i += 3)
      triangles.add(ids[cut->GetId(i)], ids[cut->GetId(i + 1)], ids[cut->GetId(i + 2)]);
  else
    for (vtkIdType i = 2; i < count; ++i) triangles.add(ids[0], ids[i - 1], ids[i]);
}

Triangles trianglesOf(vtkPolyData* data) {
  TriangleList triangles;
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  checkCells(data->GetPolys(), data->GetNumberOfPoints());
  checkCells(data->GetStrips(), data->GetNumberOfPoints());
  vtkCellArray* polygons = data->GetPolys();
  for (polygons->InitTraversal(); polygons->GetNextCell(count, ids);)
    if (count >= 3) addPolygon(triangles, data->GetPoints(), count, ids);
  vtkCellArray* strips = data->GetStrips();
  for (strips->InitTraversal(); strips->GetNextCell(count, ids);)
    for (vtkIdType i = 2; i < count; ++i)
      if (i % 2 == 0)
        triangles.add(ids[i - 2], ids[i - 1], ids[i]);
      else
        triangles.add(ids[i - 1], ids[i - 2], ids[i]);
  return triangles.rows();
}

template <class Rows>
Rows rowsOf(vtkDataArray* array) {
  Rows rows(array->GetNumberOfTuples(), Rows::ColsAtCompileTime);
  for (Index i = 0; i < rows.rows(); ++i)
    for (Index k = 0; k < rows.cols(); ++k)
      rows(i, k) = static_cast<typename Rows::Scalar>(array->GetComponent(i, static_cast<int>(k)));
  return rows;
}

std::vector<int> labelsOf(vtkDataArray* array) {
  std::vector<int> labels(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double value = array->GetTuple1(static_cast<vtkIdType>(i));
    if (!(value >= 0 && value <= patch::kMax && value == std::floor(value)))
      throw InputError("array 'Patch' holds " + std::to_string(value) +
                       "; labels are whole numbers from 0 to 255");
    labels[i] = static_cast<int>(value);
  }
  return labels;
}

Points unitNormals(vtkDataArray* array) {
  Points normals = rowsOf<Points>(array);
  if (!normals.allFinite()) return Points(0, 3);
  for (Index i = 0; i < normals.rows(); ++i)
    if (const double length = normals.row(i).norm(); length > 0) normals.row(i) /= length;
  return normals;
}

bool isColour(const std::string& name, vtkDataArray* array) {
  return (name == "RGB" || name == "RGBA" || name == "Colors") && array->GetDataType() == VTK_UNSIGNED_CHAR &&
         (array->GetNumberOfComponents() == 3 || array->GetNumberOfComponents() == 4);
}

void readPointArrays(vtkPointData* values, Surface& surface) {
  for (int k = 0; k < values->GetNumberOfArrays(); ++k) {
    vtkDataArray* array = values->GetArray(k);  // null for texts
    if (!array) continue;
    const std::string name = array->GetName() ? array->GetName() : "array " + std::to_string(k);
    if (array->GetNumberOfTuples() != surface.size())
      throw InputError("array '" + name + "' has " + std::to_string(array->GetNumberOfTuples()) +
                       " values for " + std::to_string(surface.size()) +
                       " points; write it again with one value a point");
    const int width = array->GetNumberOfComponents();
    if (name == "Patch" && width == 1)
      surface.patch = labelsOf(array);
    else if (isColour(name, array))
      surface.colours = rowsOf<Colours>(array);
    else if (width == 3 && (array == values->GetNormals() || name == "Normals"))
      surface.normals = unitNormals(array);
    else if (width == 2 && (array == values->GetTCoords() || name == "TCoords"))
      surface.textureAt = rowsOf<TexturePlaces>(array);
    else if (width == 1)
      surface.arrays[name] = rowsOf<VectorXd>(array);
  }
}

void readTexts(vtkFieldData* field, Surface& surface) {
  if (auto* space = vtkStringArray::SafeDownCast(field->GetAbstractArray("SPACE"));
      space && space->GetNumberOfValues() > 0)
    surface.frame = space->GetValue(0);
  auto* names = vtkStringArray::SafeDownCast(field->GetAbstractArray("PatchNames"));
  for (vtkIdType i = 0; names && i < names->GetNumberOfValues(); ++i) {
    const std::string entry = names->GetValue(i);
    int label = 0;
    const auto [end, error] = std::from_chars(entry.data(), entry.data() + entry.size(), label);
    if (error == std::errc() && end != entry.data() + entry.size() && *end == '=' && label > 0 &&
        label <= patch::kMax)
      surface.patchNames[label] = std::string(end + 1, entry.data() + entry.size());
  }
}

}  // namespace

Surface fromVtk(vtkPolyData* data) {
  Surface surface;
  if (!data || !data->GetPoints() || data->GetNumberOfPoints() == 0) return surface;
  if (data->GetNumberOfPoints() > std::numeric_limits<int>::max())
    throw InputError("the surface has " + std::to_string(data->GetNumberOfPoints()) +
                     " points; decimate it below 2^31");
  surface.points = rowsOf<Points>(data->GetPoints()->GetData());
  surface.triangles = trianglesOf(data);
  readPointArrays(data->GetPointData(), surface);
  readTexts(data->GetFieldData(), surface);
  return surface;
}

}  // namespace falciform
