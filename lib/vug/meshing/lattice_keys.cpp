// SPDX-License-Identifier: Apache-2.0
#include <vug/base/cell.h>
#include <vug/meshing/lattice_keys.h>

namespace vug::meshing {

LatticeKeys lattice_keys(const FaceMesh& polygons, double voxel) {
  LatticeKeys out;
  std::vector<uint32_t> index(polygons.points.size());  // Among the vertices that are used.
  LatticeKey key;
  for (size_t v = 0; v < index.size(); ++v) {
    const Cell cell = cell_at(polygons.points[v], voxel);
    const std::array<int32_t, 3> here{static_cast<int32_t>(cell[0]), static_cast<int32_t>(cell[1]),
                                      static_cast<int32_t>(cell[2])};
    key = v > 0 && here == key.cell ? LatticeKey{here, key.number + 1} : LatticeKey{here, 0};
    index[v] = static_cast<uint32_t>(out.vertices.size());
    if (polygons.first[v] < polygons.first[v + 1]) out.vertices.push_back(key);
  }
  for (const Face& face : polygons.faces)
    out.begins.insert(out.begins.end(), face.size - 2, index[face.corners[0]]);
  return out;
}

}  // namespace vug::meshing
