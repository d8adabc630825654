// SPDX-License-Identifier: Apache-2.0
// Hollows in the roofs of caves: the search for their places, and the parameters that all share.
#pragma once

#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/kind.h>
#include <vug/field/noise.h>

#include <optional>
#include <vector>

namespace vug::field {

struct RoofHollows {
  Field field;
  Vec3d from{-5, -5, -5}, to{5, 5, 5};  ///< Box in which roofs are searched, in metres.
  double spacing = 1.5;                 ///< Mean distance between possible places, in metres.
  std::optional<Noise> where;           ///< Mask: no hollows at -1, all at 1.
  int seed = 1;

  std::string fault() const;
};

template <class P>
void describe_roof_hollows(Schema<P>& s) {
  s.param("field", &RoofHollows::field, {.doc = "the rock", .required = true})
      .param("from", &RoofHollows::from,
             any_length("a corner of the box in which roofs are hollowed"))
      .param("to", &RoofHollows::to, any_length("the opposite corner"))
      .param("spacing", &RoofHollows::spacing,
             positive_length("mean distance between possible places"))
      .param("where", &RoofHollows::where,
             {.doc = "a noise as density mask: all places at 1, none at -1"})
      .param("seed", &RoofHollows::seed, {.doc = "random seed; each seed gives different places"});
}

/// A place of a roof, its height above the floor, and random numbers in [0, 1).
struct Roof {
  Vec3d at;
  double clearance;
  double random[3];
};

/// The heights between `low` and `high` at which the value along the vertical line through (x, z)
/// changes its sign, from top to bottom. Steps over distances within which it cannot change.
std::vector<double> surface_heights(const Field& rock, double x, double z, double low, double high);

/// One place in each cell of a square lattice in plan where a mask lets it, at each of the roofs
/// that a vertical line there crosses; in lattice order. Air is where the rock is positive.
std::vector<Roof> find_roofs(const RoofHollows& hollows);

/// The rock less a hollow at each roof. P is derived from RoofHollows and has
///   Field hollow(const Roof&) const   (the air of a hollow, no wider than `reach` from the roof)
/// Hollows that meet leave sharp cusps. They are computed when first needed.
template <class P>
Field hollowed(const P& hollows, double reach) {
  const Traits traits{1, Exactness::bound, grown(Box3d(hollows.from, hollows.to), reach), 0.5};
  const auto cut = [](const P& each) {
    std::vector<Field> air;
    for (const Roof& roof : find_roofs(each)) air.push_back(each.hollow(roof));
    return unite(std::move(air));
  };
  return subtract(hollows.field, {deferred(traits, {"hollowing roofs"}, cut, hollows)});
}

}  // namespace vug::field
