// SPDX-License-Identifier: Apache-2.0
// Cave clouds (mammillaries): a coating that grew under water, of parts of balls that merge. It
// ends at the level of the water.
#include <vug/base/maths.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/grown_material.h>
#include <vug/field/registry.h>
#include <vug/field/speleothems/element_field.h>
#include <vug/field/speleothems/lobe.h>
#include <vug/field/speleothems/surface_places.h>

#include <algorithm>

namespace vug::field {
namespace {

struct CaveClouds : SurfaceScatter {
  static constexpr double kSpread = 0.3;  // Of the logarithm of diameters.

  double level = 0;
  double diameter = 0.15;
  double rise = 0.6;
  double merge = 0.3;
  RockMaterialPtr material{};

  CaveClouds() { spacing = 0.1; }

  void add_to(Digester& digester) const {
    digester(static_cast<const SurfaceScatter&>(*this), level, diameter, rise, merge, material);
  }

  static void describe(Schema<CaveClouds>& s) {
    s.doc(
        "Cave clouds: a coating of rounded lobes that calcite forms on the walls of a pool, and "
        "which ends at the level of the water.");
    describe_surface_scatter(s)
        .param("level", &CaveClouds::level, any_length("height of the surface of the water"))
        .param("diameter", &CaveClouds::diameter,
               positive_length("mean diameter of a lobe, 5 to 30 cm in caves"))
        .param("rise", &CaveClouds::rise,
               {.doc = "height of a lobe over half of its diameter; 1 for half-spheres",
                .dimension = Dimension::ratio,
                .min = 0.1,
                .max = 1.5})
        .param("merge", &CaveClouds::merge,
               {.doc = "radius of the fillet between lobes over half of their diameter",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 0.6});
    describe_growth_material(s);
  }
  std::string fault() const {
    const std::string own = growth_fault(field, material);
    return own.empty() ? SurfaceScatter::fault() : own;
  }
  double reach() const { return 2 * diameter; }
  Blend fillet() const { return {Profile::smooth, 0.5 * merge * diameter}; }

  Field coating() const {
    SurfaceScatter below = *this;
    below.to.y = std::min(to.y, level);
    std::vector<Lobe> lobes;
    if (below.to.y > below.from.y)
      for (const SurfacePlace& place : find_surface_places(below)) {
        RandomStream random(place.key);
        const double radius = 0.5 * diameter * log_uniform(random, kSpread);
        lobes.push_back({place.at + place.normal * (radius * (rise - 1)), radius});
      }
    const Field coating =
        element_field("cave_clouds", std::move(lobes), Exactness::exact, fillet());
    return intersect({coating, make("half_space", {{"offset", level}})});
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(cave_clouds) {
  return field_kind<CaveClouds>("cave_clouds", "detail", [](const CaveClouds& c) {
    const Field clouds = deferred(
        surface_traits(c, c.reach()), {"growing cave clouds", c.bytes<Lobe>()},
        [](const CaveClouds& each) { return each.coating(); }, c);
    return unite({c.field, of_material(clouds, c.material)});
  });
}
