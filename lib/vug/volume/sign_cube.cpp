// SPDX-License-Identifier: Apache-2.0
#include <vug/volume/openvdb_values.h>
#include <vug/volume/sign_cube.h>

#include <openvdb/tools/VolumeToMesh.h>

#include <algorithm>
#include <cstdlib>

namespace vug::volume {
namespace {

namespace mesher = openvdb::tools::volume_to_mesh_internal;

/// The corners of a cell in the order of OpenVDB's tables.
constexpr Offset kCorners[8] = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1},
                                {0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}};
/// The cells across the faces of a cell, and the numbers of the shared faces there.
constexpr Offset kAcross[7] = {{0, 0, 0},  {0, 0, -1}, {1, 0, 0}, {0, 0, 1},
                               {-1, 0, 0}, {0, -1, 0}, {0, 1, 0}};
constexpr int kOpposite[7] = {0, 3, 4, 1, 2, 6, 5};

Offset sum(const Offset& a, const Offset& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

unsigned signs_of(const SignCube& cube, const Offset& cell) {
  unsigned signs = 0;
  for (unsigned i = 0; i < 8; ++i)
    signs |= static_cast<unsigned>(cube.inside(sum(cell, kCorners[i]))) << i;
  return signs;
}

/// Vertices of the mesh in the cell, whose signs the mesher inverts if the cell across its
/// ambiguous face has an ambiguous face there, too.
int vertices_in(const SignCube& cube, const Offset& cell, unsigned signs) {
  const unsigned face = mesher::sAmbiguousFace[signs];
  if (face && mesher::sAmbiguousFace[signs_of(cube, sum(cell, kAcross[face]))] == kOpposite[face])
    signs = ~signs & 255U;
  return mesher::sEdgeGroupTable[signs][0];
}

template <class Visit>
void each_in(const Offset& low, const Offset& high, const Visit& visit) {
  for (int x = low[0]; x <= high[0]; ++x)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int z = low[2]; z <= high[2]; ++z) visit(Offset{x, y, z});
}

/// Whether steps along the axes on the centre's side lead to the sample within their bounding box.
bool connected_in_box(const SignCube& cube, const Offset& other) {
  const bool inside = cube.inside({0, 0, 0});
  std::vector<Offset> reached = {{0, 0, 0}};
  for (size_t i = 0; i < reached.size(); ++i)
    for (size_t side = 0; side < 6; ++side) {
      Offset next = reached[i];
      const size_t axis = side / 2;
      next[axis] += side % 2 ? 1 : -1;
      if (next[axis] < std::min(0, other[axis]) || next[axis] > std::max(0, other[axis])) continue;
      if (next == other) return true;
      if (cube.inside(next) == inside && !std::count(reached.begin(), reached.end(), next))
        reached.push_back(next);
    }
  return false;
}

}  // namespace

int euler_characteristic(const SignCube& cube, int reach) {
  int total = 0;
  each_in({-reach - 2, -reach - 2, -reach - 2}, {reach + 1, reach + 1, reach + 1},
          [&](const Offset& cell) {
            const unsigned signs = signs_of(cube, cell);
            if (signs == 0 || signs == 255) return;
            total += vertices_in(cube, cell, signs);
            // Quads around the three lattice edges at the cell's first corner.
            for (const unsigned corner : {1U, 3U, 4U})
              total -= static_cast<int>((signs ^ signs >> corner) & 1U);
          });
  return total;
}

int euler_change(const SignCube& cube, const std::vector<Offset>& samples, int reach) {
  SignCube changed = cube;
  for (const Offset& at : samples) changed.flip(at);
  return euler_characteristic(changed, reach) - euler_characteristic(cube, reach);
}

std::vector<Offset> opposite_samples(const SignCube& cube, int steps) {
  const bool inside = cube.inside({0, 0, 0});
  std::vector<Offset> found;
  each_in({-steps, -steps, -steps}, {steps, steps, steps}, [&](const Offset& other) {
    const int length = std::max({std::abs(other[0]), std::abs(other[1]), std::abs(other[2])});
    if (length < 2 || cube.inside(other) != inside) return;
    bool gap = true;
    for (int step = 1; step < length; ++step) {
      Offset low, high;
      for (size_t axis = 0; axis < 3; ++axis) {
        const int down = other[axis] * step - (other[axis] < 0 ? length - 1 : 0);
        const int up = other[axis] * step + (other[axis] > 0 ? length - 1 : 0);
        low[axis] = down / length, high[axis] = up / length;
      }
      each_in(low, high, [&](const Offset& at) { gap = gap && cube.inside(at) != inside; });
    }
    if (gap && !connected_in_box(cube, other)) found.push_back(other);
  });
  return found;
}

}  // namespace vug::volume
