// SPDX-License-Identifier: Apache-2.0
// Inclined networks shared by the tests of films.
#pragma once

#include "run.h"

#include <vug/base/maths.h>

#include <cmath>

namespace vug::cells {

/// A rectangular grid with four links on a plane that falls towards +x: `across` cells in each of
/// `rows` rows, the first at the top.
inline Network slope_grid(uint32_t across, uint32_t rows, double spacing, double angle) {
  Network n;
  n.spacing = spacing, n.full = 4, n.reach = 1.4 * spacing;
  const double sine = maths::sin(angle), cosine = maths::cos(angle);
  for (uint32_t i = 0; i < across * rows; ++i) {
    const double down = spacing * (i / across), side = spacing * (i % across);
    n.position.push_back(Vec3f(Vec3d(down * cosine, -down * sine, side)));
  }
  n.normal.assign(n.size(), Vec3f(Vec3d(sine, cosine, 0)));
  n.right.assign(n.size(), Vec3f(0, 0, 1));
  n.area.assign(n.size(), static_cast<float>(spacing * spacing));
  n.object.assign(n.size(), 0);
  n.links = make_links(n.size(), [&](uint32_t i, const auto& add) {
    if (i >= across) add(i - across);
    if (i % across > 0) add(i - 1);
    if (i % across + 1 < across) add(i + 1);
    if (i + across < n.size()) add(i + across);
  });
  return n;
}

/// A random network on such a plane, `length` metres down and `width` across.
inline NetworkPtr slope_network(double length, double width, double spacing, double angle) {
  const double x = length * maths::cos(angle), y = -length * maths::sin(angle);
  mesh::Mesh mesh;
  mesh.positions = {Vec3f(0), Vec3f(Vec3d(0, 0, width)), Vec3f(Vec3d(x, y, width)),
                    Vec3f(Vec3d(x, y, 0))};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Surface surface({shared(std::move(mesh))});
  return std::make_shared<const Network>(build(surface, options("random", spacing)).network);
}

/// Sets `height` to smooth noise: waves of about this length in random directions, with this
/// standard deviation, both in metres.
inline void roughen(Simulation& simulation, double length, double deviation, uint64_t seed = 3) {
  constexpr int kWaves = 40;
  RandomStream random{RandomKey(seed)};
  auto& height = simulation.attributes().column<float>("height").now;
  for (int wave = 0; wave < kWaves; ++wave) {
    const double turn = 2 * kPi * random.uniform(), phase = 2 * kPi * random.uniform();
    const double k = 2 * kPi / (length * (0.6 + 0.8 * random.uniform()));
    const Vec3d along(k * maths::cos(turn), 0, k * maths::sin(turn));
    for (size_t i = 0; i < height.size(); ++i) {
      const Vec3d p(simulation.network().position[i]);
      height[i] += static_cast<float>(deviation * std::sqrt(2.0 / kWaves) *
                                      maths::cos(along.dot(p) + phase));
    }
  }
}

}  // namespace vug::cells
