// SPDX-License-Identifier: Apache-2.0
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/dripstone.h>

#include <cmath>

namespace vug::field {
namespace {

/// A larger number of places suggests a wrong unit.
constexpr double kMostPlaces = 4e6;

struct Dripstone : DripOptions {
  Field field;

  static void describe(Schema<Dripstone>& s) {
    s.doc(
         "Rock with stalactites under its roofs, stalagmites vertically below them, and columns "
         "where they have met.")
        .cite("short2005")
        .cite("curl1973")
        .param("field", &Dripstone::field, {.doc = "the rock", .required = true})
        .param("from", &DripOptions::from, any_length("a corner of the box in which they grow"))
        .param("to", &DripOptions::to, any_length("the opposite corner"))
        .param("spacing", &DripOptions::spacing,
               positive_length("mean distance between possible drips"))
        .param("length", &DripOptions::length, positive_length("length of the longest stalactites"))
        .param("girth", &DripOptions::girth,
               {.doc = "radius at the root as a fraction of the length",
                .dimension = Dimension::ratio,
                .min = 0.01,
                .max = 0.5})
        .param("tip", &DripOptions::tip, positive_length("radius of every tip"))
        .param("stalagmites", &DripOptions::stalagmites,
               {.doc = "fraction of the drips with a stalagmite below",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("root", &DripOptions::root,
               positive_length("distance over which roots blend into the rock"))
        .param("where", &DripOptions::where,
               {.doc = "a noise as density mask: all drips at 1, none at -1"})
        .param("seed", &DripOptions::seed, {.doc = "random seed; each seed gives different drips"});
  }
  std::string fault() const {
    const Vec3d size = to - from;
    if (!(size.x > 0 && size.y > 0 && size.z > 0))
      return "'from' must be less than 'to' in x, y and z";
    if (!(size.x / spacing * (size.z / spacing) <= kMostPlaces))
      return "the spacing is too small for a box of this size: there would be millions of drips";
    return "";
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(dripstone) {
  return field_kind<Dripstone>("dripstone", "detail", [](const Dripstone& d) {
    const Traits traits{1, Exactness::eikonal, dripstone_bounds(d.field.bounds(), d), 1};
    const auto make = [d] { return dripstone(find_drips(d.field, d), d); };
    return unite({d.field, deferred(traits, "finding drips", make)}, {Profile::smooth, d.root});
  });
}
