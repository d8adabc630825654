// SPDX-License-Identifier: Apache-2.0
// Runs of rules shared by several tests.
#pragma once

#include "made.h"

#include <vug/cells/rule.h>
#include <vug/cells/simulation.h>

#include <numeric>

namespace vug::cells {

inline NetworkPtr torus(uint32_t across, uint32_t along, uint32_t full) {
  return std::make_shared<const Network>(flat_torus(across, along, full));
}

/// A network with links of many degrees: scattered cells without relaxation.
inline NetworkPtr uneven(double spacing = 0.06) {
  BuildOptions o = options("random", spacing);
  o.relax = 0;
  const Surface surface({shared(mesh::torus_mesh(1, 0.4, 60, 30))});
  return std::make_shared<const Network>(build(surface, o).network);
}

inline Stage stage(const std::string& rule, const NamedValues& parameters = {}, int steps = -1,
                   int begin = 0) {
  return {make_product(rules(), rule, parameters), rule, begin, steps, {}};
}

/// The sum of an attribute over all cells.
inline double total(const Simulation& s, const std::string& name) {
  const auto& values = s.attributes().values<float>(name);
  return std::accumulate(values.begin(), values.end(), 0.0);
}

inline Simulation ran(NetworkPtr network, const std::vector<Stage>& stages, int steps,
                      uint64_t seed = 1) {
  Simulation simulation(std::move(network), RandomKey(seed));
  simulation.run(stages, steps);
  return simulation;
}

/// Sum of (links + 1) * value, which a mean over a cell and its neighbours conserves because links
/// are mutual.
template <class T>
auto weighted_sum(const Network& n, const std::vector<T>& values) {
  if constexpr (std::is_same_v<T, Vec3f>) {
    Vec3d sum(0);
    for (uint32_t i = 0; i < n.size(); ++i) sum += Vec3d(values[i]) * (n.links.degree(i) + 1.0);
    return sum;
  } else {
    double sum = 0;
    for (uint32_t i = 0; i < n.size(); ++i)
      sum += static_cast<double>(values[i]) * (n.links.degree(i) + 1.0);
    return sum;
  }
}

}  // namespace vug::cells
