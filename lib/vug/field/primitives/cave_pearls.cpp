// SPDX-License-Identifier: Apache-2.0
// Cave pearls: drops keep grains in a shallow basin moving, and calcite coats them on all sides.
#include <vug/base/maths.h>
#include <vug/field/boolean.h>
#include <vug/field/kind.h>
#include <vug/field/lathe.h>
#include <vug/field/speleothems/element_field.h>
#include <vug/field/speleothems/pearls.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

struct CavePearls {
  static constexpr double kGap = 0.01;  // Of a radius, between pearls that touch.

  int count = 40;
  double diameter = 0.015;
  double spread = 0.3;
  double basin = 0.09;
  double depth = 0.03;
  double wall = 0.015;
  int seed = 1;

  static void describe(Schema<CavePearls>& s) {
    s.doc(
         "Cave pearls in a basin, whose lowest point is at the origin. They rest on it and on each "
         "other.")
        .cite("hill1997")
        .param("count", &CavePearls::count,
               {.doc = "number of pearls; those that find no place below the rim are omitted",
                .min = 1,
                .max = 400})
        .param("diameter", &CavePearls::diameter,
               positive_length("median diameter of a pearl, 2 to 50 mm in caves"))
        .param("spread", &CavePearls::spread,
               {.doc = "standard deviation of the logarithm of diameters", .min = 0, .max = 0.6})
        .param("basin", &CavePearls::basin, positive_length("radius of the rim of the basin"))
        .param("depth", &CavePearls::depth, positive_length("depth of the basin"))
        .param(
            "wall", &CavePearls::wall,
            {.doc = "thickness of the basin below its lowest point and at its rim; 0: pearls only",
             .dimension = Dimension::length,
             .min = 0})
        .param("seed", &CavePearls::seed, {.doc = "random seed; each seed gives other pearls"});
  }
  std::string fault() const {
    if (depth > basin) return "the depth of the basin must not exceed the radius of its rim";
    return largest() < 0.5 * basin
               ? ""
               : "the basin is too narrow for pearls of this diameter and spread";
  }
  double largest() const { return 0.5 * diameter * maths::exp(2 * spread); }

  std::vector<Lobe> pearls() const {
    RandomStream random(RandomKey(static_cast<uint64_t>(seed)).at("cave_pearls"));
    std::vector<double> radii;
    for (int i = 0; i < count; ++i)
      radii.push_back(0.5 * diameter * maths::exp(spread * std::clamp(random.normal(), -2.0, 2.0)));
    std::vector<Lobe> out = packed_pearls({basin, depth}, radii, random);
    for (Lobe& pearl : out) pearl.radius *= 1 - kGap;
    return out;
  }
  std::vector<Vec2d> outline() const {
    constexpr int kPoints = 24;
    const double round = PearlBowl{basin, depth}.curvature();
    const double opening = maths::atan2(basin, round - depth);
    std::vector<Vec2d> out;
    for (int i = 0; i <= kPoints; ++i) {
      const double angle = opening * i / kPoints;
      // Corners outside of the circle by as much as the sides cut into it.
      out.emplace_back(round * maths::sin(angle), round * (1 - maths::cos(angle)));
    }
    out.emplace_back(basin + wall, depth);
    out.emplace_back(basin + 1.5 * wall, depth - 0.5 * wall);
    out.emplace_back(basin + 1.5 * wall, -wall);
    out.emplace_back(0, -wall);
    return out;
  }
  Field make() const {
    const Field balls = element_field("cave_pearls", pearls(), Exactness::exact);
    return wall > 0 ? unite({lathe("cave_pearls", outline()), balls}) : balls;
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(cave_pearls) {
  return field_kind<CavePearls>("cave_pearls", "primitive",
                                [](const CavePearls& c) { return c.make(); });
}
