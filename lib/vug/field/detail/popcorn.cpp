// SPDX-License-Identifier: Apache-2.0
// Popcorn (coralloids): seepage evaporates most where the wall is exposed to the air, so knobs on
// its projections outgrow those in hollows (jettestuen2006).
#include <vug/base/maths.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/grown_material.h>
#include <vug/field/speleothems/element_field.h>
#include <vug/field/speleothems/nodule.h>
#include <vug/field/speleothems/surface_places.h>

#include <algorithm>

namespace vug::field {
namespace {

struct Popcorn : SurfaceScatter {
  static constexpr double kSpread = 0.28;  // Of the logarithm of diameters.
  static constexpr double kLargest = 1.7;  // Times the mean diameter ...
  static constexpr double kLeast = 0.4;    // ... between which knobs grow at all.
  static constexpr double kExposed = 0.6;  // Growth at a point over that on a plane, less 1.
  static constexpr double kStalk = 0.45;   // Diameter of a stalk over that of its knob.

  double diameter = 0.012;
  double stalk = 0.006;
  int cluster = 4;
  Vec3d wind{0, 0, 0};
  RockMaterialPtr material{};

  Popcorn() { spacing = 0.018; }

  void add_to(Digester& digester) const {
    digester(static_cast<const SurfaceScatter&>(*this), diameter, stalk, cluster, wind, material);
  }

  static void describe(Schema<Popcorn>& s) {
    s.doc(
         "Popcorn: knobs of calcite on short stalks, in clusters on a wall. They are larger on its "
         "projections and where air blows at it. Its lower or upper line, a face of the box, is "
         "sharp.")
        .cite("jettestuen2006");
    describe_surface_scatter(s)
        .param("diameter", &Popcorn::diameter,
               positive_length("mean diameter of a knob on a plane, 5 to 20 mm in caves"))
        .param("stalk", &Popcorn::stalk,
               {.doc = "mean length of a stalk between the rock and its knob",
                .dimension = Dimension::length,
                .min = 0})
        .param("cluster", &Popcorn::cluster,
               {.doc = "largest number of knobs on one stalk", .min = 1, .max = 12})
        .param("wind", &Popcorn::wind,
               {.doc = "direction of a draught: knobs grow on the side that it meets; zero: in "
                       "still air, on all sides"});
    describe_growth_material(s);
  }
  std::string fault() const {
    const std::string own = growth_fault(field, material);
    return own.empty() ? SurfaceScatter::fault() : own;
  }
  double reach() const { return kLargest * diameter * 1.7 + 2 * stalk; }

  void grow(const SurfacePlace& place, std::vector<Nodule>& out) const {
    RandomStream random(place.key);
    double growth = 1 + kExposed * exposure(field, place, 2 * diameter);
    if (wind.length2() > 0) growth *= 0.7 - 0.6 * place.normal.dot(wind.normalized());
    growth *= log_uniform(random, kSpread);
    if (growth < kLeast) return;
    growth = std::min(growth, kLargest);
    const double lean = 0.35 * random.uniform(), turn = 2 * kPi * random.uniform();
    const Vec3d way = tilted(place.normal, lean, turn);
    const int knobs = 1 + static_cast<int>(std::floor(cluster * random.uniform()));
    // All knobs of a stalk leave it where its middle knob has its centre.
    const double middle = 0.5 * growth * diameter;
    const double rise = growth * stalk * (0.5 + random.uniform()) + middle;
    out.push_back(knob(place.at, place.at + way * rise, middle));
    for (int i = 1; i < knobs; ++i) {
      const double radius = middle * random.uniform(0.5, 0.8);
      const double around = turn + 2 * kPi * (i + 0.6 * random.uniform()) / (knobs - 1);
      const Vec3d side = tilted(way, random.uniform(0.7, 1.3), around);
      out.push_back(knob(place.at, place.at + way * rise + side * middle, radius));
    }
  }
  static Nodule knob(const Vec3d& foot, const Vec3d& centre, double radius) {
    const double stalk = kStalk * radius;
    return {{foot, centre, stalk, stalk}, radius, {Profile::smooth, 0.8 * stalk}};
  }
  Field crust() const {
    std::vector<Nodule> knobs;
    for (const SurfacePlace& place : find_surface_places(*this)) grow(place, knobs);
    return element_field("popcorn", std::move(knobs), Exactness::bound);
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(popcorn) {
  return field_kind<Popcorn>("popcorn", "detail", [](const Popcorn& p) {
    const Field knobs = deferred(
        surface_traits(p, p.reach()), {"growing popcorn", p.bytes<Nodule>(p.cluster)},
        [](const Popcorn& each) { return each.crust(); }, p);
    return unite({p.field, of_material(knobs, p.material)});
  });
}
