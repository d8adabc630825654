// SPDX-License-Identifier: Apache-2.0
// Tafoni (honeycomb weathering): salt breaks grains out of a wall, most in the shade of what it has
// hollowed already, so cells deepen side by side until only sharp walls remain between them.
#include <vug/base/maths.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/material_source.h>
#include <vug/field/round_cone.h>
#include <vug/field/speleothems/element_field.h>
#include <vug/field/speleothems/surface_places.h>

#include <algorithm>

namespace vug::field {
namespace {

struct Tafoni : SurfaceScatter {
  static constexpr double kSpread = 0.25;  // Of the logarithm of widths.

  double width = 0.09;
  double depth = 0.6;
  double stretch = 0.4;
  Vec3d normal{0, 1, 0};

  Tafoni() { spacing = 0.085; }

  void add_to(Digester& digester) const {
    digester(static_cast<const SurfaceScatter&>(*this), width, depth, stretch, normal);
  }

  static void describe(Schema<Tafoni>& s) {
    s.doc(
         "Tafoni: round cells that weathering hollows out of a rock face, side by side with sharp "
         "walls between them, longer along the beds. Their size has the factor 1 - hardness of the "
         "rock there.")
        .cite("mustoe1982");
    describe_surface_scatter(s)
        .param("width", &Tafoni::width,
               positive_length("mean width of a cell across the beds, 1 cm to 1 m in nature"))
        .param("depth", &Tafoni::depth,
               {.doc = "depth of a cell over its width; above 0.5 its mouth is narrower than it",
                .dimension = Dimension::ratio,
                .min = 0.05,
                .max = 0.95})
        .param("stretch", &Tafoni::stretch,
               {.doc = "length of a cell along the beds over its width, less 1",
                .dimension = Dimension::ratio,
                .min = 0.01,
                .max = 4})
        .param("normal", &Tafoni::normal,
               {.doc = "perpendicular to the beds, of any length but 0"});
  }
  std::string fault() const {
    if (!(normal.length2() > 0)) return "the normal of the beds must not be zero";
    return SurfaceScatter::fault();
  }
  double reach() const { return width * (1.6 + stretch); }

  RoundCone cell(const SurfacePlace& place, double softness) const {
    RandomStream random(place.key);
    const double radius = softness * 0.5 * width * log_uniform(random, kSpread);
    const Vec3d centre = place.at - place.normal * (radius * (2 * depth - 1));
    const Vec3d level = normal.normalized().cross(place.normal);
    const Vec3d along = level.length() > 1e-3
                            ? level.normalized()
                            : tilted(place.normal, kPi / 2, 2 * kPi * random.uniform());
    const double half = radius * stretch * random.uniform(0.4, 1.6);
    return {centre - along * half, centre + along * half, radius, radius};
  }
  Field cells() const {
    std::vector<RoundCone> out;
    for (const SurfacePlace& place : find_surface_places(*this))
      if (const double softness = 1 - hardness_at(field, place.at); softness > 0)
        out.push_back(cell(place, softness));
    return element_field("tafoni", std::move(out), Exactness::exact);
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(tafoni) {
  return field_kind<Tafoni>("tafoni", "detail", [](const Tafoni& t) {
    return subtract(t.field,
                    {deferred(
                        surface_traits(t, t.reach()), {"weathering tafoni", t.bytes<RoundCone>()},
                        [](const Tafoni& each) { return each.cells(); }, t)});
  });
}
