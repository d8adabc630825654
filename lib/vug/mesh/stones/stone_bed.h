// SPDX-License-Identifier: Apache-2.0
// Stones that come to rest on the ground and on each other, one after the other.
#pragma once

#include <vug/base/rng.h>
#include <vug/mesh/stones/settle.h>
#include <vug/mesh/stones/stone_ground.h>

#include <unordered_map>

namespace vug::mesh {

struct StoneBedOptions {
  double repose = 36 * kPi / 180;  ///< Steepest slope of contacts that friction holds, radians.
  double cell = 0.1;               ///< Edge of the cells of the search for neighbours, metres.
};

/// A stone of a bed.
struct BedStone {
  size_t shape = 0;
  Rest rest;
};

/// Add large stones before small ones: a stone rests on those before it.
class StoneBed {
 public:
  /// The mesh must outlive the bed.
  StoneBed(const Mesh& ground, std::vector<StoneShape> shapes, const StoneBedOptions& options);

  /// Lets a stone come to rest above a point of the ground. It lies on the side that the key
  /// selects, turns and tilts until three contacts support it, and slides down by up to four steps
  /// where they do not. False, without a stone, if it finds no rest: on ground that is too steep,
  /// at the foot of a wall, below a low roof, or on a stone that is taller than its own radius.
  bool add(size_t shape, double diameter, const Vec3d& at, RandomKey key);

  const std::vector<BedStone>& stones() const { return stones_; }
  const std::vector<StoneShape>& shapes() const { return shapes_; }

 private:
  enum class Outcome { rests, slides, has_no_room };
  Outcome rest_at(const StoneShape& shape, const StonePose& start, const Vec3d& at,
                  const GroundPatch& patch, Rest& rest) const;
  std::vector<uint32_t> neighbours(const Vec3d& centre, double radius) const;
  void enter(uint32_t stone);

  StoneGround ground_;
  std::vector<StoneShape> shapes_;
  std::vector<std::vector<StonePose>> sides_;  ///< For each shape, poses at rest on a plane.
  StoneBedOptions options_;
  std::vector<BedStone> stones_;
  std::unordered_map<uint64_t, std::vector<uint32_t>> cells_;
};

}  // namespace vug::mesh
