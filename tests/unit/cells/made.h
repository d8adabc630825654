// SPDX-License-Identifier: Apache-2.0
// Networks and surfaces shared by several tests.
#pragma once

#include <vug/cells/build.h>
#include <vug/cells/kind.h>
#include <vug/mesh/shapes.h>

namespace vug::cells {

inline mesh::MeshPtr shared(mesh::Mesh mesh) {
  return std::make_shared<const mesh::Mesh>(std::move(mesh));
}

inline BuildOptions options(const std::string& grid, double spacing,
                            const NamedValues& parameters = {}) {
  BuildOptions o;
  o.grid = make_product(grids(), grid, parameters);
  o.spacing = spacing;
  return o;
}

/// A horizontal square of two triangles with a side of 1 m.
inline mesh::Mesh floor_mesh() {
  mesh::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

}  // namespace vug::cells
