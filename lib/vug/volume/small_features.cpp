// SPDX-License-Identifier: Apache-2.0
// A sample whose change of sides alters the topology is rare. Samples whose 26 neighbours are
// connected on either side are simple points (bertrand1994simple), which cannot; the others are
// compared with the mesh itself, because the mesher joins diagonal neighbours on one side or the
// other.
#include <vug/base/parallel.h>
#include <vug/volume/around_centre.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/neighbourhood.h>
#include <vug/volume/openvdb_values.h>
#include <vug/volume/sign_cube.h>
#include <vug/volume/small_features.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <tuple>

namespace vug::volume {
namespace {

using Tree = openvdb::FloatTree;
using openvdb::Coord;
using Kind = SmallFeature::Kind;

/// The side that polygons_of assigns to a value.
bool is_inside(float value) { return value < std::numeric_limits<float>::min(); }

Vec3d position_of(const openvdb::math::Transform& transform, const openvdb::Vec3d& at) {
  const openvdb::Vec3d p = transform.indexToWorld(at);
  return {p.x(), p.y(), p.z()};
}

/// How far across a gap the exact field is examined, in voxels.
constexpr int kLargestGap = 3;

/// The sides of samples, some of which have been flipped.
class Sides {
 public:
  /// The exact field is examined only around samples of the cube of `size` samples from `origin`.
  Sides(const openvdb::FloatGrid& grid, const field::Field* exact, const std::set<Coord>& flipped,
        const Coord& origin, int size)
      : values_(grid.tree()),
        transform_(grid.transform()),
        exact_(exact),
        flipped_(flipped),
        middle_(origin.asVec3d() + openvdb::Vec3d(0.5 * (size - 1))),
        reach_(0.5 * (size - 1) + kLargestGap) {}

  bool inside(const Coord& at) const { return inside(value(at), at); }
  bool inside(float value, const Coord& at) const {
    return is_inside(value) != (!flipped_.empty() && flipped_.count(at) > 0);
  }
  float value(const Coord& at) const { return values_.getValue(at); }
  /// The sides around a sample, by offsets.
  auto around(const Coord& centre) const {
    return
        [this, centre](const Offset& by) { return inside(centre.offsetBy(by[0], by[1], by[2])); };
  }
  /// Whether the exact field has the side of `from` all the way to `to`. False without a field.
  bool exactly_connected(const Coord& from, const Coord& to) const {
    if (!exact_) return false;
    constexpr int kSteps = 16;
    const field::Field& near = exact_nearby();
    for (int i = 0; i <= kSteps; ++i) {
      const openvdb::Vec3d at = from.asVec3d() + (to - from).asVec3d() * (1.0 * i / kSteps);
      if ((near.value(position_of(transform_, at)) <= 0) != inside(from)) return false;
    }
    return true;
  }

 private:
  /// The exact field without what does not matter in the cube; made when it is first needed.
  const field::Field& exact_nearby() const {
    if (!nearby_) {
      const double voxel = transform_.voxelSize().x();
      // A little larger, because positions are rounded.
      const field::Ball ball{position_of(transform_, middle_),
                             voxel * (std::sqrt(3.0) * reach_ + 0.1)};
      const field::NodePtr smaller = exact_->node()->restrict_to(ball).node;
      nearby_ = smaller ? field::Field(smaller) : *exact_;
    }
    return *nearby_;
  }

  openvdb::tree::ValueAccessor<const Tree, false> values_;
  const openvdb::math::Transform& transform_;
  const field::Field* exact_;
  const std::set<Coord>& flipped_;
  openvdb::Vec3d middle_;
  double reach_;
  mutable std::optional<field::Field> nearby_;
};

struct Feature {
  Kind kind;
  float magnitude;  ///< Largest distance of a sample to flip from the surface.
  std::vector<Coord> samples;

  bool operator<(const Feature& other) const {
    return std::tuple(kind == Kind::handle, samples.size(), magnitude, samples) <
           std::tuple(other.kind == Kind::handle, other.samples.size(), other.magnitude,
                      other.samples);
  }
};

/// The samples connected to `seed` by steps along the axes if they are at most two wide.
std::vector<Coord> small_set(const Sides& sides, const Coord& seed) {
  const bool inside = sides.inside(seed);
  std::vector<Coord> set = {seed};
  openvdb::CoordBBox box(seed, seed);
  for (size_t i = 0; i < set.size(); ++i)
    for (int side = 0; side < 6; ++side) {
      Coord next = set[i];
      next[static_cast<size_t>(side / 2)] += side % 2 ? 1 : -1;
      if (sides.inside(next) != inside || std::count(set.begin(), set.end(), next)) continue;
      box.expand(next);
      if (box.extents()[box.maxExtent()] > 2) return {};
      set.push_back(next);
    }
  std::sort(set.begin(), set.end());
  return set;
}

/// A closed set of samples around its first one.
std::optional<Feature> closed_set_at(const Sides& sides, const Coord& seed) {
  Feature found{sides.inside(seed) ? Kind::crumb : Kind::bubble, 0, small_set(sides, seed)};
  if (found.samples.empty() || found.samples.front() != seed) return std::nullopt;
  std::vector<Offset> offsets;
  for (const Coord& at : found.samples) {
    const Coord by = at - seed;
    offsets.push_back({by[0], by[1], by[2]});
    found.magnitude = std::max(found.magnitude, std::abs(sides.value(at)));
  }
  // A sphere less. Other changes mean that the mesher joins the set to others diagonally.
  if (euler_change(SignCube(5, sides.around(seed)), offsets, 2) != -2) return std::nullopt;
  return found;
}

/// How far the ends of a handle may be apart, in voxels: of a small handle, and of one that the
/// exact field does not have.
constexpr int kSmall = 6, kFar = 24;

/// The largest distance of the ends of a handle at a sample with these ones across a gap; 0 if the
/// gap is too wide.
int handle_reach(const Sides& sides, const Coord& at, const std::vector<Offset>& opposite) {
  constexpr int kSmallGap = 2;
  int reach = 0;
  for (const Offset& by : opposite) {
    if (sides.exactly_connected(at, at.offsetBy(by[0], by[1], by[2]))) return kFar;
    if (std::max({std::abs(by[0]), std::abs(by[1]), std::abs(by[2])}) <= kSmallGap) reach = kSmall;
  }
  return reach;
}

/// Whether a neighbour of the sample along an axis is on the other side.
bool is_at_surface(const SignCube& cube, const Offset& at) {
  for (size_t side = 0; side < 6; ++side) {
    Offset next = at;
    next[static_cast<size_t>(side / 2)] += side % 2 ? 1 : -1;
    if (cube.inside(next) != cube.inside(at)) return true;
  }
  return false;
}

/// The sets of one or two samples at the centre that may be the cross-section of a handle.
std::vector<std::vector<Offset>> cross_sections(const SignCube& cube) {
  std::vector<std::vector<Offset>> sets = {{{0, 0, 0}}};
  for (int n = 0; n < 27; ++n) {
    const Offset by{n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1};
    const int steps = std::abs(by[0]) + std::abs(by[1]) + std::abs(by[2]);
    if ((steps == 1 || steps == 2) && cube.inside(by) == cube.inside({0, 0, 0}) &&
        is_at_surface(cube, by))
      sets.push_back({{0, 0, 0}, by});
  }
  return sets;
}

/// The sets of one or two samples whose flip removes a handle, if both sides stay connected: then
/// the Euler characteristic grows by 2 only if a handle disappears.
std::vector<std::vector<Offset>> closing_sets(const SignCube& cube) {
  std::vector<std::vector<Offset>> sets = cross_sections(cube);
  std::erase_if(sets, [&](const auto& set) { return euler_change(cube, set, 1) != 2; });
  return sets;
}

/// A handle that this sample, or a pair with it, closes or cuts.
std::optional<Feature> handle_at(const Sides& sides, const Coord& at) {
  const std::vector<Offset> opposite =
      opposite_samples(SignCube(kLargestGap, sides.around(at)), kLargestGap);
  if (opposite.empty()) return std::nullopt;
  const std::vector<std::vector<Offset>> sets = closing_sets(SignCube(4, sides.around(at)));
  if (sets.empty()) return std::nullopt;
  const int reach = handle_reach(sides, at, opposite);  // Last, because fields are slow.
  if (reach == 0) return std::nullopt;
  std::optional<Feature> best;
  for (const std::vector<Offset>& set : sets) {
    Feature next{Kind::handle, 0, {}};
    for (const Offset& by : set) {
      next.samples.push_back(at.offsetBy(by[0], by[1], by[2]));
      next.magnitude = std::max(next.magnitude, std::abs(sides.value(next.samples.back())));
    }
    if (best && !(next < *best)) continue;
    if (AroundCentre(set, reach).connected(sides.around(at), true) &&
        AroundCentre(set, reach).connected(sides.around(at), false))
      best = std::move(next);
  }
  return best;
}

std::optional<Feature> feature_at(const Sides& sides, const Coord& at) {
  if (std::optional<Feature> set = closed_set_at(sides, at)) return set;
  return handle_at(sides, at);
}

/// A leaf and its neighbours, because an accessor is slow across leaves.
class Leaves {
 public:
  Leaves(const Tree& tree, const Coord& origin) {
    constexpr int kSize = Tree::LeafNodeType::DIM;
    for (int n = 0; n < 27; ++n) {
      const Coord at =
          origin.offsetBy(kSize * (n / 9 - 1), kSize * (n / 3 % 3 - 1), kSize * (n % 3 - 1));
      const auto i = static_cast<size_t>(n);
      leaves_[i] = tree.probeConstLeaf(at);
      tiles_[i] = leaves_[i] ? 0 : tree.getValue(at);
    }
  }
  float value(const Offset& by) const {
    const auto n = static_cast<size_t>((by[0] + 8) / 8 * 9 + (by[1] + 8) / 8 * 3 + (by[2] + 8) / 8);
    return leaves_[n] ? leaves_[n]->getValue(Coord(by[0], by[1], by[2])) : tiles_[n];
  }

 private:
  static_assert(Tree::LeafNodeType::DIM == 8);
  std::array<const Tree::LeafNodeType*, 27> leaves_;
  std::array<float, 27> tiles_;
};

/// Features of the leaf, each as if it were the only one.
std::vector<Feature> features_in(const Sides& sides, const Leaves& leaves, const Coord& origin,
                                 const Progress& progress) {
  std::vector<Feature> found;
  for_each_special_point(
      [&](const Offset& by) {
        return sides.inside(leaves.value(by), origin.offsetBy(by[0], by[1], by[2]));
      },
      [&](const Offset& by) {
        progress.check();  // A leaf of thin sheets can take a second.
        const Coord at = origin.offsetBy(by[0], by[1], by[2]);
        if (std::optional<Feature> feature = feature_at(sides, at))
          found.push_back(std::move(*feature));
      });
  return found;
}

class Search {
 public:
  Search(const LevelSet& level_set, const field::Field* exact, const Progress& progress)
      : grid_(static_cast<const openvdb::FloatGrid&>(*level_set.data().grid)),
        exact_(exact),
        progress_(progress) {}

  std::vector<SmallFeature> run() {
    std::vector<Coord> origins;
    for (auto leaf = grid_.tree().cbeginLeaf(); leaf; ++leaf) origins.push_back(leaf->origin());
    constexpr int kMostRounds = 8;  // Normally two: the second one finds nothing.
    for (int round = 0; round < kMostRounds && !origins.empty(); ++round)
      origins = remove(candidates(origins));
    std::stable_partition(found_.begin(), found_.end(),
                          [](const SmallFeature& each) { return each.kind != Kind::handle; });
    return std::move(found_);
  }

 private:
  Sides sides(const Coord& origin, int size) const {
    return Sides(grid_, exact_, flipped_, origin, size);
  }

  std::vector<Feature> candidates(const std::vector<Coord>& origins) const {
    std::vector<std::vector<Feature>> by_leaf(origins.size());
    parallel_for(
        origins.size(),
        [&](size_t i) {
          const Sides here = sides(origins[i], static_cast<int>(Tree::LeafNodeType::DIM));
          by_leaf[i] = features_in(here, Leaves(grid_.tree(), origins[i]), origins[i], progress_);
        },
        16);
    std::vector<Feature> all;
    for (std::vector<Feature>& some : by_leaf)
      std::move(some.begin(), some.end(), std::back_inserter(all));
    std::sort(all.begin(), all.end());
    return all;
  }

  /// Removes those that still exist when it is their turn, and returns the leaves in reach.
  std::vector<Coord> remove(const std::vector<Feature>& features) {
    std::set<Coord> near;
    for (const Feature& each : features) {
      progress_.check();
      const Coord& first = each.samples.front();
      const std::optional<Feature> now = feature_at(sides(first, 1), first);
      if (!now) continue;
      add(*now);
      flipped_.insert(now->samples.begin(), now->samples.end());
      for (int n = 0; n < 27; ++n) {
        constexpr int kStep = 6;
        const Coord at = now->samples.front().offsetBy((n / 9 - 1) * kStep, (n / 3 % 3 - 1) * kStep,
                                                       (n % 3 - 1) * kStep);
        if (grid_.tree().probeConstLeaf(at))
          near.insert(at & ~static_cast<int>(Tree::LeafNodeType::DIM - 1));
      }
    }
    return {near.begin(), near.end()};
  }

  void add(const Feature& feature) {
    SmallFeature out{feature.kind, Vec3d(0), {}};
    for (const Coord& at : feature.samples) {
      out.at += position_of(grid_.transform(), at.asVec3d()) *
                (1.0 / static_cast<double>(feature.samples.size()));
      out.samples.emplace_back(at.x(), at.y(), at.z());
    }
    found_.push_back(std::move(out));
  }

  const openvdb::FloatGrid& grid_;
  const field::Field* exact_;
  const Progress& progress_;
  std::set<Coord> flipped_;
  std::vector<SmallFeature> found_;
};

}  // namespace

std::vector<SmallFeature> find_small_features(const LevelSet& level_set, const field::Field* exact,
                                              const Progress& progress) {
  return Search(level_set, exact, progress).run();
}

LevelSet without_features(const LevelSet& level_set, const std::vector<SmallFeature>& features) {
  if (features.empty()) return level_set;
  auto grid = static_cast<const openvdb::FloatGrid&>(*level_set.data().grid).deepCopy();
  openvdb::FloatTree& tree = grid->tree();
  for (const SmallFeature& each : features)
    for (const Vec3i& sample : each.samples) {
      const Coord at(sample.x, sample.y, sample.z);
      const float value = tree.getValue(at);
      tree.setValueOnly(
          at, is_inside(value) ? std::max(-value, std::numeric_limits<float>::min()) : -value);
    }
  return LevelSet(wrap(grid));
}

}  // namespace vug::volume
