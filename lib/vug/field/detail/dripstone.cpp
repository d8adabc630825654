#include <vug/field/boolean.h>
#include <vug/field/dripstone.h>

#include <cmath>

namespace vug::field {
namespace {

/// More places than this are a slip of the unit.
constexpr double kMostPlaces = 4e6;

struct Dripstone : DripOptions {
  Field field;

  static void describe(Schema<Dripstone>& s) {
    s.doc(
         "Rock with stalactites under its roofs, stalagmites plumb below them, and columns where "
         "both have met.")
        .cite("short2005")
        .cite("curl1973")
        .param("field", &Dripstone::field, {.doc = "the rock", .required = true})
        .param("from", &DripOptions::from, any_length("a corner of the box to grow them in"))
        .param("to", &DripOptions::to, any_length("the opposite corner"))
        .param("spacing", &DripOptions::spacing,
               positive_length("mean distance between places where a drip may fall"))
        .param("length", &DripOptions::length, positive_length("of the longest stalactites"))
        .param("girth", &DripOptions::girth,
               {.doc = "radius at the root, as a part of the length",
                .dimension = Dimension::ratio,
                .min = 0.01,
                .max = 0.5})
        .param("tip", &DripOptions::tip, positive_length("radius of every tip"))
        .param("stalagmites", &DripOptions::stalagmites,
               {.doc = "share of the drips that built one below",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("root", &DripOptions::root, positive_length("over which roots flow into the rock"))
        .param("where", &DripOptions::where,
               {.doc = "a noise that gathers them: all where 1, none where -1"})
        .param("seed", &DripOptions::seed, {.doc = "another seed, other drips"});
  }
  std::string fault() const {
    const Vec3d size = to - from;
    if (!(size.x > 0 && size.y > 0 && size.z > 0))
      return "'from' must lie below 'to' in x, y and z";
    if (!(size.x / spacing * (size.z / spacing) <= kMostPlaces))
      return "the spacing is too small for a box of that size; it would be millions of drips";
    return "";
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(dripstone) {
  return field_kind<Dripstone>("dripstone", "detail", [](const Dripstone& d) {
    return unite({d.field, dripstone(find_drips(d.field, d), d)}, {Profile::smooth, d.root});
  });
}
