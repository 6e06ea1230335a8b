#include "Modules/CommandLine/UpdateTargets.h"

#include "Logic/Atlas/ExpectedError.h"
#include "Logic/Atlas/UpdatedPlaces.h"
#include "Logic/Core/LandmarkPairs.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/UpdateOutputs.h"

namespace falciform::commandline {

namespace {

std::string cell(const std::optional<double>& value) { return "," + (value ? fixed(*value, 3) : ""); }

nlohmann::json orNull(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

std::vector<double> list(const Vector3d& place) { return {place[0], place[1], place[2]}; }

std::vector<TargetRow> rowsBefore(const UpdateInput& input) {
  std::vector<TargetRow> rows;
  for (const Landmark& target : input.targets.points) {
    rows.emplace_back();
    rows.back().name = target.name;
    rows.back().preop = target.position;
  }
  for (const UpdateInput::Structure& structure : input.structures) {
    if (structure.surface.size() == 0) continue;
    rows.emplace_back();
    rows.back().name = structure.name;
    rows.back().structure = true;
    rows.back().preop = structure.surface.points.colwise().mean().transpose();
  }
  return rows;
}

}  // namespace

std::vector<TargetRow> targetRows(const UpdatedLiver& updated) {
  std::vector<TargetRow> rows = rowsBefore(updated.input);
  if (rows.empty()) return rows;
  falciform::Points before(static_cast<Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) before.row(static_cast<Index>(i)) = rows[i].preop.transpose();
  const falciform::Points now = scanFromPreop(updated.liver.mesh, updated.update, before);
  VectorXd expected;
  if (updated.model != nullptr) expected = expectedErrorMm(*updated.model, updated.update, before);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = static_cast<Index>(i);
    rows[i].rigid = updated.rigid.scanFromPreop * rows[i].preop;
    rows[i].now = now.row(row).transpose();
    if (expected.size() > row) rows[i].expectedMm = expected[row];
  }
  if (updated.input.truth.points.empty()) return rows;
  const PairedTargets paired = pairTargets(updated.input.targets, updated.input.truth);
  for (Index i = 0; i < paired.scan.rows(); ++i) {
    TargetRow& row = rows[static_cast<std::size_t>(i)];
    const Vector3d truth = paired.scan.row(i).transpose();
    row.errorMm = (row.now - truth).norm();
    row.rigidErrorMm = (row.rigid - truth).norm();
  }
  return rows;
}

std::string targetsCsv(const std::vector<TargetRow>& rows) {
  std::string csv =
      "name,kind,preop_x_mm,preop_y_mm,preop_z_mm,registered_x_mm,registered_y_mm,registered_z_mm,updated_x_"
      "mm,updated_y_mm,updated_z_mm,expected_error_mm,error_mm,registered_error_mm\n";
  for (const TargetRow& row : rows) {
    std::string name = row.name;
    for (char& c : name)
      if (c == ',' || c == '"' || c == '\n') c = ' ';
    csv += name + (row.structure ? ",structure" : ",target");
    for (const Vector3d& place : {row.preop, row.rigid, row.now})
      for (int axis = 0; axis < 3; ++axis) csv += "," + fixed(place[axis], 3);
    csv += cell(row.expectedMm) + cell(row.errorMm) + cell(row.rigidErrorMm) + "\n";
  }
  return csv;
}

nlohmann::json toJson(const std::vector<TargetRow>& rows) {
  nlohmann::json json = nlohmann::json::array();
  for (const TargetRow& row : rows) {
    json.push_back({{"name", row.name},
                    {"kind", row.structure ? "structure" : "target"},
                    {"preop_mm", list(row.preop)},
                    {"registered_mm", list(row.rigid)},
                    {"updated_mm", list(row.now)},
                    {"expected_error_mm", orNull(row.expectedMm)}});
    if (row.errorMm) {
      json.back()["error_mm"] = *row.errorMm;
      json.back()["registered_error_mm"] = *row.rigidErrorMm;
    }
  }
  return json;
}

}  // namespace falciform::commandline
