// SPDX-License-Identifier: Apache-2.0
#include <vug/shot/cells_plan.h>

#include <algorithm>

namespace vug::shot {

const std::vector<std::string>& cell_files() {
  static const std::vector<std::string> all = {"points", "grids", "csv"};
  return all;
}

int CellsPlan::length() const {
  if (steps) return *steps;
  constexpr int kOpenEnd = 100;  // for rules without an end
  int last = 0;
  for (const CellStagePtr& stage : run)
    last = std::max(last, stage->begin + (stage->span() < 0 ? kOpenEnd : stage->span()));
  return last;
}

bool CellsPlan::writes(const std::string& what) const {
  return std::find(files.begin(), files.end(), what) != files.end();
}

std::string CellsPlan::fault() const {
  const std::vector<std::string>& known = cell_files();
  for (const std::string& each : files)
    if (std::find(known.begin(), known.end(), each) == known.end())
      return "unknown file of cells '" + each + "'";
  return {};
}

MeshPtr mesh_without_cells(const MeshPlan& mesh) {
  return mesh.cells ? mesh.cells->on.at(mesh.support) : nullptr;
}

std::vector<MeshPtr> parts_of(const MeshPtr& mesh) {
  return mesh->parts.empty() ? std::vector<MeshPtr>{mesh} : mesh->parts;
}

MeshPtr part_with_support(const MeshPtr& mesh, const MeshPtr& support) {
  for (const MeshPtr& part : parts_of(mesh))
    for (MeshPtr each = part; each; each = mesh_without_cells(*each))
      if (*each == *support) return part;
  return nullptr;
}

}  // namespace vug::shot
