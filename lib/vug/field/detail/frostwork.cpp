// SPDX-License-Identifier: Apache-2.0
// Frostwork: bushes of needles of aragonite. Each needle carries side needles, and these carry
// more.
#include <vug/base/maths.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/round_cone.h>
#include <vug/field/speleothems/element_field.h>
#include <vug/field/speleothems/surface_places.h>

#include <algorithm>

namespace vug::field {
namespace {

struct Frostwork : SurfaceScatter {
  static constexpr double kThin = 0.4;  // Radius of an end over that of the foot.
  static constexpr double kOpen = 0.9;  // Radians from the normal to the outermost needles.
  static constexpr double kLow = 20 * kPi / 180, kHigh = 40 * kPi / 180;  // Between needles.

  double length = 0.015;
  double diameter = 0.0006;
  int needles = 6;
  int branches = 4;

  Frostwork() { spacing = 0.025; }

  void add_to(Digester& digester) const {
    digester(static_cast<const SurfaceScatter&>(*this), length, diameter, needles, branches);
  }

  static void describe(Schema<Frostwork>& s) {
    s.doc("Frostwork: bushes of thin needles on a rock, with side needles at 20 to 40 degrees.")
        .cite("hill1997");
    describe_surface_scatter(s)
        .param("length", &Frostwork::length,
               positive_length("mean length of a needle, 5 to 30 mm in caves"))
        .param("diameter", &Frostwork::diameter,
               positive_length("diameter of a needle at its foot, 0.1 to 1 mm in caves; at least "
                               "two voxels in a level set"))
        .param("needles", &Frostwork::needles,
               {.doc = "number of needles of a bush", .min = 1, .max = 40})
        .param("branches", &Frostwork::branches,
               {.doc = "number of side needles of a needle", .min = 0, .max = 20});
  }
  std::string fault() const {
    if (!(diameter < 0.3 * length)) return "a needle must be thinner than a third of its length";
    return SurfaceScatter::fault();
  }
  double reach() const { return 3 * length; }

  void grow(const Vec3d& foot, const Vec3d& way, double size, int generation, RandomStream& random,
            std::vector<RoundCone>& out) const {
    const double radius = 0.5 * diameter * (generation == 0 ? 1 : 0.7);
    out.push_back({foot, foot + way * size, radius, kThin * radius});
    if (generation == 1) return;
    for (int i = 0; i < branches; ++i) {
      const double part = random.uniform(0.3, 0.9), angle = random.uniform(kLow, kHigh);
      const Vec3d side = tilted(way, angle, 2 * kPi * random.uniform());
      grow(foot + way * (size * part), side, size * (1 - part) * random.uniform(0.7, 1.1),
           generation + 1, random, out);
    }
  }
  Field bushes() const {
    std::vector<RoundCone> out;
    for (const SurfacePlace& place : find_surface_places(*this)) {
      RandomStream random(place.key);
      const double size = length * log_uniform(random, 0.3);
      for (int i = 0; i < needles; ++i) {
        const double angle = kOpen * std::sqrt(random.uniform());
        const Vec3d way = tilted(place.normal, angle, 2 * kPi * random.uniform());
        grow(place.at, way, size * random.uniform(0.6, 1.0), 0, random, out);
      }
    }
    return element_field("frostwork", std::move(out), Exactness::exact);
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(frostwork) {
  return field_kind<Frostwork>("frostwork", "detail", [](const Frostwork& f) {
    return unite(
        {f.field, deferred(
                      surface_traits(f, f.reach()),
                      {"growing frostwork", f.bytes<RoundCone>(f.needles * (1 + f.branches))},
                      [](const Frostwork& each) { return each.bushes(); }, f)});
  });
}
