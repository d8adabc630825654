// SPDX-License-Identifier: Apache-2.0
// Lavacicles: drips of lava that froze at the roof of a lava tube; wide and short ones are called
// shark's teeth.
#include <vug/base/maths.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/round_cone.h>
#include <vug/field/speleothems/element_field.h>
#include <vug/field/speleothems/surface_places.h>

#include <algorithm>

namespace vug::field {
namespace {

struct Lavacicles : SurfaceScatter {
  static constexpr double kSpread = 0.6;     // Of the logarithm of lengths.
  static constexpr double kSteepest = -0.5;  // Upward part of the normal: roofs up to 60 degrees.

  double length = 0.06;
  double base = 0.35;
  double tip = 0.004;
  Vec3d flow{0, 0, 0};

  Lavacicles() { spacing = 0.07; }

  void add_to(Digester& digester) const {
    digester(static_cast<const SurfaceScatter&>(*this), length, base, tip, flow);
  }

  static void describe(Schema<Lavacicles>& s) {
    s.doc(
        "Lavacicles on the roof of a lava tube: blunt cones that hang plumb. With a `base` above "
        "0.8 they are shark's teeth.");
    describe_surface_scatter(s)
        .param("length", &Lavacicles::length,
               positive_length("mean length, some millimetres to over 1 m"))
        .param("base", &Lavacicles::base,
               {.doc = "width at the roof over the length",
                .dimension = Dimension::ratio,
                .min = 0.05,
                .max = 1.8})
        .param("tip", &Lavacicles::tip, positive_length("radius of the drop at the end"))
        .param("flow", &Lavacicles::flow,
               {.doc = "direction of the hot gas: cones lean that way by its length in radians, at "
                       "most 0.5; zero: they are plumb"});
  }
  double longest() const { return 3 * length; }
  double reach() const { return longest() * (1 + base) + 2 * tip; }

  Field cones() const {
    const double lean = std::min(flow.length(), 0.5);
    Vec3d down(0, -1, 0);
    if (lean > 0) down = (down + flow.normalized() * maths::tan(lean)).normalized();
    std::vector<RoundCone> out;
    for (const SurfacePlace& place : find_surface_places(*this)) {
      if (place.normal.y > kSteepest) continue;
      RandomStream random(place.key);
      const double size = length * log_uniform(random, kSpread);
      const double wide = 0.5 * base * size * random.uniform(0.8, 1.25);
      const double thin = std::min(tip, 0.9 * wide);
      // The wide end lies in the rock.
      const Vec3d top = place.at - down * (0.5 * wide), end = place.at + down * (size - thin);
      if (!round_cone_nests(top, end, wide, thin)) out.push_back({top, end, wide, thin});
    }
    return element_field("lavacicles", std::move(out), Exactness::exact);
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(lavacicles) {
  return field_kind<Lavacicles>("lavacicles", "detail", [](const Lavacicles& l) {
    return unite(
        {l.field, deferred(
                      surface_traits(l, l.reach()), {"hanging lavacicles", l.bytes<RoundCone>()},
                      [](const Lavacicles& each) { return each.cones(); }, l)});
  });
}
