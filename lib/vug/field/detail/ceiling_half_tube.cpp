// SPDX-License-Identifier: Apache-2.0
// A half-tube in a ceiling: water under a roof above sediment dissolved a winding channel upwards.
#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/field/boolean.h>
#include <vug/field/deferred.h>
#include <vug/field/path.h>
#include <vug/field/round_cone.h>
#include <vug/field/speleogens/roofs.h>
#include <vug/field/speleothems/element_field.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

struct CeilingHalfTube {
  static constexpr double kMostSteps = 1e5;

  Field field;
  std::vector<Vec3d> path{{-2, 0, 0}, {2, 0, 0}};
  double search = 5;
  double width = 0.4;
  double height = 0.3;
  double wavelength = 0;
  double swing = 0.3;
  int seed = 1;

  static void describe(Schema<CeilingHalfTube>& s) {
    s.doc(
         "A half-tube in the ceiling above a path: a channel with a round roof, which water cut "
         "upwards. It follows the ceiling and swings from side to side.")
        .cite("pasini2009")
        .param("field", &CeilingHalfTube::field, {.doc = "the rock", .required = true})
        .param("path", &CeilingHalfTube::path,
               any_length("points of the way of the water, in the air below the ceiling"))
        .param("search", &CeilingHalfTube::search,
               positive_length("largest height of the ceiling above the path"))
        .param("width", &CeilingHalfTube::width,
               positive_length("width of the channel, 10 cm to 1 m in caves"))
        .param("height", &CeilingHalfTube::height,
               positive_length("height of the channel's roof above the ceiling"))
        .param("wavelength", &CeilingHalfTube::wavelength,
               {.doc = "length of a meander; 0: none", .dimension = Dimension::length, .min = 0})
        .param("swing", &CeilingHalfTube::swing,
               {.doc = "sideways reach of the meanders", .dimension = Dimension::length, .min = 0})
        .param("seed", &CeilingHalfTube::seed,
               {.doc = "random seed; each seed gives other meanders"});
  }
  std::string fault() const {
    if (const std::string fault = path_fault(path); !fault.empty()) return fault;
    double length = 0;
    for (size_t i = 1; i < path.size(); ++i) {
      const Vec3d leg = path[i] - path[i - 1];
      if (!(leg.x * leg.x + leg.z * leg.z > 0))
        return "each leg of the path must have a length in plan";
      length += leg.length();
    }
    return length / width < kMostSteps ? "" : "the channel is too narrow for a path of this length";
  }
  Box3d box() const {
    Box3d out;
    for (const Vec3d& p : path) out.extendBy(p);
    out.max.y += search;
    return grown(out, swing + width + height);
  }

  /// Points of the ceiling above the meandering path, about a quarter of the width apart; where the
  /// path has no ceiling, a new run of points starts.
  std::vector<std::vector<Vec3d>> ceiling() const {
    RandomStream random(RandomKey(static_cast<uint64_t>(seed)).at("ceiling_half_tube"));
    const double phase = 2 * kPi * random.uniform(), other = 2 * kPi * random.uniform();
    std::vector<std::vector<Vec3d>> runs(1);
    double before = 0;
    for (size_t i = 1; i < path.size(); ++i) {
      const Vec3d leg = path[i] - path[i - 1];
      const Vec3d side = Vec3d(leg.z, 0, -leg.x).normalized();
      const int steps = std::max(1, static_cast<int>(std::ceil(leg.length() / (0.25 * width))));
      for (int k = i == 1 ? 0 : 1; k <= steps; ++k) {
        const double part = static_cast<double>(k) / steps;
        Vec3d p =
            path[i - 1] + leg * part + side * offset(before + leg.length() * part, phase, other);
        const std::vector<double> heights = surface_heights(field, p.x, p.z, p.y, p.y + search);
        if (heights.empty() || !(field.value(p) > 0)) {
          if (!runs.back().empty()) runs.emplace_back();
          continue;
        }
        p.y = heights.back();
        runs.back().push_back(p);
      }
      before += leg.length();
    }
    return runs;
  }
  double offset(double along, double phase, double other) const {
    if (wavelength == 0) return 0;
    const double turn = 2 * kPi * along / wavelength;
    return swing * (0.75 * maths::sin(turn + phase) + 0.25 * maths::sin(0.618 * turn + other));
  }
  Field channel() const {
    std::vector<RoundCone> tubes;
    const double radius = 0.5 * width, top = height - radius;
    // Tubes above each other, close enough for an even wall, from the mouth to the roof.
    const int storeys = top > 0 ? 1 + static_cast<int>(std::ceil(top / (0.4 * radius))) : 1;
    for (const std::vector<Vec3d>& run : ceiling())
      for (size_t i = 0; i + 1 < run.size(); ++i)
        for (int k = 0; k < storeys; ++k) {
          const Vec3d up(0, storeys == 1 ? top : top * k / (storeys - 1), 0);
          tubes.push_back({run[i] + up, run[i + 1] + up, radius, radius});
        }
    return element_field("ceiling_half_tube", std::move(tubes), Exactness::exact);
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(ceiling_half_tube) {
  return field_kind<CeilingHalfTube>("ceiling_half_tube", "detail", [](const CeilingHalfTube& c) {
    return subtract(c.field, {deferred(
                                 {1, Exactness::bound, c.box(), 1}, {"cutting half-tubes"},
                                 [](const CeilingHalfTube& each) { return each.channel(); }, c)});
  });
}
