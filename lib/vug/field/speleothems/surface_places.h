// SPDX-License-Identifier: Apache-2.0
// Places on the surface of rock for many small forms, and the parameters that these kinds share.
#pragma once

#include <vug/base/rng.h>
#include <vug/field/kind.h>
#include <vug/field/noise.h>

#include <array>
#include <optional>
#include <vector>

namespace vug::field {

/// A point of the surface, the unit normal into the air, and the key of its random numbers.
struct SurfacePlace {
  Vec3d at, normal;
  RandomKey key;
};

struct SurfaceScatter {
  Field field;
  Vec3d from{-1, -1, -1}, to{1, 1, 1};  ///< Box in which the surface is covered, in metres.
  double spacing = 0.03;                ///< Mean distance between neighbours, in metres.
  std::optional<Noise> where;           ///< Mask: nothing at -1, everything at 1.
  int seed = 1;

  std::string fault() const;
  /// The number of places if the surface is as large as that of the box.
  double most_places() const;
  /// Memory in bytes for that number of places with `each` elements of the type E.
  template <class E>
  double bytes(int each = 1) const {
    constexpr double kTree = 1.5;  // Elements, and the tree above them.
    return most_places() * (sizeof(SurfacePlace) + kTree * sizeof(E) * each);
  }
};

template <class P>
Schema<P>& describe_surface_scatter(Schema<P>& s) {
  return s.param("field", &SurfaceScatter::field, {.doc = "the rock", .required = true})
      .param("from", &SurfaceScatter::from,
             any_length("a corner of the box in which the surface is covered"))
      .param("to", &SurfaceScatter::to, any_length("the opposite corner"))
      .param("spacing", &SurfaceScatter::spacing,
             positive_length("mean distance between neighbours"))
      .param("where", &SurfaceScatter::where,
             {.doc = "a noise as density mask: all places at 1, none at -1"})
      .param("seed", &SurfaceScatter::seed,
             {.doc = "random seed; each seed gives different places"});
}

/// Places with one per spacing^2 of the surface on average and no two closer than 0.7 spacings,
/// in the order of a lattice of space. Air is where the rock is positive.
std::vector<SurfacePlace> find_surface_places(const SurfaceScatter& scatter);

/// Bounds of forms that reach at most `reach` metres from their places.
inline Traits surface_traits(const SurfaceScatter& scatter, double reach) {
  return {1, Exactness::bound, grown(Box3d(scatter.from, scatter.to), reach), 1};
}

/// A random factor whose logarithm is uniform about 0 with this standard deviation.
double log_uniform(RandomStream& random, double deviation);

/// Two unit vectors along the surface, perpendicular to the unit normal and to each other.
std::array<Vec3d, 2> tangents(const Vec3d& normal);
/// The unit vector at `angle` radians from the normal, turned about it by `turn` radians.
Vec3d tilted(const Vec3d& normal, double angle, double turn);
/// How far the surface around a place recedes: about 1 on a needle's tip, 0 on a plane and -1 in a
/// narrow hollow. `size` is the distance in metres over which it is measured.
double exposure(const Field& rock, const SurfacePlace& place, double size);

}  // namespace vug::field
