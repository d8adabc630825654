// SPDX-License-Identifier: Apache-2.0
// A network without a surface: cells of a regular grid on a plane whose opposite sides are joined.
#include <vug/base/error.h>
#include <vug/cells/network.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::cells {
namespace {

/// A step to a neighbour, in cells.
struct NeighbourOffset {
  int x, z;
};

/// Alternate rows of the triangle grid are offset by half a cell. The honeycomb is represented as a
/// brick wall, whose cells are linked to both sides and alternately to the row above or below.
std::span<const NeighbourOffset> steps(uint32_t full, uint32_t x, uint32_t z) {
  static constexpr NeighbourOffset kSides[] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
  static constexpr NeighbourOffset kRing[] = {{-1, -1}, {0, -1}, {1, -1}, {-1, 0},
                                              {1, 0},   {-1, 1}, {0, 1},  {1, 1}};
  static constexpr NeighbourOffset kEven[] = {{-1, 0}, {1, 0}, {-1, -1}, {0, -1}, {-1, 1}, {0, 1}};
  static constexpr NeighbourOffset kOdd[] = {{-1, 0}, {1, 0}, {0, -1}, {1, -1}, {0, 1}, {1, 1}};
  static constexpr NeighbourOffset kDown[] = {{-1, 0}, {1, 0}, {0, 1}};
  static constexpr NeighbourOffset kUp[] = {{-1, 0}, {1, 0}, {0, -1}};
  switch (full) {
    case 3:
      return (x + z) % 2 == 0 ? std::span<const NeighbourOffset>(kDown)
                              : std::span<const NeighbourOffset>(kUp);
    case 4:
      return kSides;
    case 6:
      return z % 2 == 0 ? std::span<const NeighbourOffset>(kEven)
                        : std::span<const NeighbourOffset>(kOdd);
    default:
      return kRing;
  }
}

Vec3d place(uint32_t full, uint32_t x, uint32_t z) {
  const double root3 = std::sqrt(3.0);
  const double u = x, v = z;
  if (full == 3) return {u * root3 / 2, 0, v * 1.5 + ((x + z) % 2 == 0 ? 0.25 : -0.25)};
  if (full == 6) return {u + (z % 2 == 0 ? 0 : 0.5), 0, v * root3 / 2};
  return {u, 0, v};
}

}  // namespace

Network flat_torus(uint32_t across, uint32_t along, uint32_t full, double spacing) {
  if (full != 3 && full != 4 && full != 6 && full != 8)
    throw Error(ErrorCode::bad_input, fmt::format("no grid has {} links per cell", full), {},
                "3, 4, 6 or 8");
  if (across < 4 || along < 4 || (full == 3 && across % 2 == 1) ||
      (full % 3 == 0 && along % 2 == 1) || uint64_t{across} * along * full > UINT32_MAX)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("{} by {} cells with {} links do not form a torus", across, along, full));
  const double root3 = std::sqrt(3.0);
  const double reach = full == 4 ? std::sqrt(2.0) : full == 8 ? 2 : root3;
  const double cell = full == 3 ? 0.75 * root3 : full == 6 ? root3 / 2 : 1;
  Network n;
  n.spacing = spacing;
  n.reach = reach * spacing;
  n.full = full;
  const uint32_t count = across * along;
  n.position.resize(count);
  n.normal.assign(count, Vec3f(0, 1, 0));
  n.right.assign(count, Vec3f(1, 0, 0));
  n.area.assign(count, static_cast<float>(cell * spacing * spacing));
  n.object.assign(count, 0);
  parallel_for(along, [&](size_t z) {
    for (uint32_t x = 0; x < across; ++x)
      n.position[z * across + x] = Vec3f(place(full, x, static_cast<uint32_t>(z)) * spacing);
  });
  n.links = make_links(count, [&](uint32_t i, const auto& add) {
    const uint32_t x = i % across, z = i / across;
    uint32_t row[8];
    size_t links = 0;
    for (const NeighbourOffset& s : steps(full, x, z)) {
      const uint32_t to_x = (x + across + static_cast<uint32_t>(s.x)) % across;
      const uint32_t to_z = (z + along + static_cast<uint32_t>(s.z)) % along;
      const uint32_t to = to_z * across + to_x;
      size_t at = links++;
      for (; at > 0 && row[at - 1] > to; --at) row[at] = row[at - 1];
      row[at] = to;
    }
    for (size_t k = 0; k < links; ++k) add(row[k]);
  });
  return n;
}

}  // namespace vug::cells
