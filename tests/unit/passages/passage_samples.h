// SPDX-License-Identifier: Apache-2.0
// Networks and their passages for property tests.
#pragma once

#include <vug/base/rng.h>
#include <vug/passages/passages.h>

#include <string>
#include <vector>

namespace vug::passages {

struct PassageCase {
  std::string label;
  field::Field field;
};

/// A network of unnamed stations.
network::Network network_of(const std::vector<Vec3d>& stations,
                            const std::vector<std::pair<int, int>>& legs);

/// The same walls at all stations: circles of this radius.
network::Network with_radius(network::Network network, double radius);

/// A random cave: walks of level and steep legs with walls that vary, branches and loops.
network::Network random_cave(uint64_t seed, int legs);

/// Random caves with each family of sections, and with the default rules.
const std::vector<PassageCase>& passage_cases();

/// Uniform in the cube of half-width `reach` about the origin.
Vec3d random_vector(RandomStream& random, double reach);
/// A point within 2 m of the field's bounds, mostly near a passage.
Vec3d point_near(const field::Field& field, RandomStream& random);

inline Vec3d abs_of(const Vec3d& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }

}  // namespace vug::passages
