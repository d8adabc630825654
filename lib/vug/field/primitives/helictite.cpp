// SPDX-License-Identifier: Apache-2.0
// A helictite: a capillary feeds a tube that grows in any direction, so its curvature is random and
// gravity does not bend it.
#include <vug/base/maths.h>
#include <vug/field/kind.h>
#include <vug/field/round_cone.h>
#include <vug/field/speleothems/element_field.h>
#include <vug/field/speleothems/random_curve.h>

#include <algorithm>

namespace vug::field {
namespace {

struct Helictite {
  static constexpr double kStandardCurl = 0.2;  // Curvature times radius: a bend of five radii.
  static constexpr double kCorrelation = 6;     // Radii over which a bend changes.
  static constexpr double kMostSegments = 20000;
  static constexpr double kThinnest = 0.3;  // Radius of an end over that of the root.
  static constexpr int kGenerations = 3;

  double length = 0.1;
  double radius = 0.002;
  double curl = 1;
  double branches = 10;
  double taper = 2;
  Vec3d direction{0, -1, 0};
  double root = 0.01;
  int seed = 1;

  static void describe(Schema<Helictite>& s) {
    s.doc(
         "A helictite, which grows from the origin and twists in any direction, with branches. "
         "Gravity does not bend it.")
        .cite("hill1997")
        .param("length", &Helictite::length, positive_length("length along it, 1 to 30 cm"))
        .param("radius", &Helictite::radius,
               positive_length("radius at the origin: 0.5 to 5 mm for worm-like ones"))
        .param("curl", &Helictite::curl,
               {.doc = "strength of its bends; at 1 the typical radius of a bend is five radii",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 3})
        .param("branches", &Helictite::branches,
               {.doc = "mean number of branches per metre", .min = 0, .max = 100})
        .param(
            "taper", &Helictite::taper,
            {.doc = "loss of radius per metre, as a multiple of the radius", .min = 0, .max = 20})
        .param("direction", &Helictite::direction,
               {.doc = "direction at the origin, of any length but 0"})
        .param("root", &Helictite::root,
               {.doc = "length by which it continues backwards into the rock",
                .dimension = Dimension::length,
                .min = 0})
        .param("seed", &Helictite::seed,
               {.doc = "random seed; each seed gives a different helictite"});
  }
  std::string fault() const {
    if (!(direction.length2() > 0)) return "the direction of a helictite must not be zero";
    if (!(taper * radius < 0.5)) return "the taper of a helictite must be below 0.5 / radius";
    // Branches have at most the length of their parents; three generations.
    const double most = length / radius * (1 + branches * length);
    return most < kMostSegments
               ? ""
               : "a helictite this long needs too many segments; increase its radius, or reduce "
                 "its length or its branches";
  }

  struct Tube {
    Vec3d at;
    Frame frame;
    double length, radius;
    int generation;
  };
  void grow(const Tube& tube, RandomStream& random, std::vector<RoundCone>& out) const {
    const double wide = tube.radius;
    const RandomCurve shape{tube.length, wide, curl * kStandardCurl / wide, kCorrelation * wide};
    const std::vector<CurvePoint> curve = random_curve(shape, tube.at, tube.frame, random);
    const double step = (curve[1].at - curve[0].at).length();
    const auto radius_at = [&](size_t i) {
      return wide * std::max(1 - taper * step * static_cast<double>(i), kThinnest);
    };
    for (size_t i = 0; i + 1 < curve.size(); ++i) {
      out.push_back({curve[i].at, curve[i + 1].at, radius_at(i), radius_at(i + 1)});
      if (tube.generation == kGenerations || !(random.uniform() < branches * step)) continue;
      const double left = tube.length - step * static_cast<double>(i);
      const double turn = 2 * kPi * random.uniform(), angle = random.uniform(0.6, 1.3);
      const Frame aside = curve[i].frame.rotated(curve[i].frame.around(turn), angle);
      const double reach = left * random.uniform(0.25, 0.8);
      grow({curve[i].at, aside, reach, 0.8 * radius_at(i), tube.generation + 1}, random, out);
    }
  }
  Field make() const {
    RandomStream random(RandomKey(static_cast<uint64_t>(seed)).at("helictite"));
    std::vector<RoundCone> tubes;
    const Frame first = level_frame(direction);
    if (root > 0) tubes.push_back({-first.tangent * root, Vec3d(0), radius, radius});
    grow({Vec3d(0), first, length, radius, 1}, random, tubes);
    return element_field("helictite", std::move(tubes), Exactness::exact);
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(helictite) {
  return field_kind<Helictite>("helictite", "primitive",
                               [](const Helictite& h) { return h.make(); });
}
