// SPDX-License-Identifier: Apache-2.0
// Where water leaves the roof: on joints and beds, in clusters, and few places give much of it.
#pragma once

#include <vug/drips/planes.h>
#include <vug/field/noise.h>

#include <optional>
#include <vector>

namespace vug::drips {

/// A larger number of columns suggests a wrong unit.
inline constexpr double kMostColumns = 4e6;

struct SeepOptions {
  Vec3d from{-5, -5, -5}, to{5, 5, 5};  ///< The box in which roofs are searched, metres.
  double spacing = 0.8;  ///< Mean distance between the columns in which water may seep, metres.
  double density = 0.5;  ///< The share of the columns in which it does, 0..1.
  std::optional<field::Noise> where{};  ///< A mask of the density: 0 at -1, twice at 1.
  std::optional<Planes> planes{};       ///< Joints and beds; none: water seeps through pores.
  double interval = 60;                 ///< Median time between drops in seconds.
  double spread = 1.2;                  ///< Standard deviation of its logarithm.
  double oldest = 10000;                ///< The age of the oldest drips in years.
  /// That age at the end of a sequence in which the cave grows, to which the ages of added drips
  /// refer; 0: `oldest`.
  double final_age = 0;
  uint64_t seed = 1;

  double last_age() const { return final_age > 0 ? final_age : oldest; }
};

struct Seep {
  int64_t id = 0;  ///< See Node::id.
  Vec3d position{0.0}, normal{0.0};
  double interval = 0;               ///< Seconds between drops.
  double age = 0;                    ///< Years.
  std::optional<NearPlane> plane{};  ///< The joint or bed on which it lies.
};

/// Throws Error(bad_input) for options that are not finite or out of range, and Error(too_large)
/// for too many columns.
void require_valid(const SeepOptions& options);

/// Roofs on the way to a joint or bed may be higher or lower than the box by this number of metres.
double farthest_move(const SeepOptions& options);

/// In the order of their ids. Air is where the rock is positive. Throws as require_valid.
std::vector<Seep> find_seeps(const field::Field& rock, const SeepOptions& options);

}  // namespace vug::drips
