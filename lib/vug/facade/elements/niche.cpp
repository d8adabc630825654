// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>
#include <vug/facade/outline.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/registry.h>

#include <algorithm>

namespace vug::facade {
namespace {

struct Niche : Opening {
  double depth = 0;
  double plinth = 0;

  static void describe(Schema<Niche>& s) {
    s.doc(
         "A niche: half of a cylinder under a quarter of a sphere, optionally with a plinth in it.")
        .param("depth", &Niche::depth,
               {.doc = "maximum depth; 0: half of the width",
                .dimension = Dimension::length,
                .min = 0})
        .param("plinth", &Niche::plinth,
               {.doc = "height of the plinth in it; 0: none",
                .dimension = Dimension::length,
                .min = 0});
    describe_opening(s);
  }
  std::string fault() const { return opening_fault(); }

  Solids solids(double width, double height) const {
    Opening edge = *this;
    edge.head = Head::round;
    edge.rise = 0;
    Solids out = edge.around(width, height, std::max(0.02, std::min(reveal, 0.04)));
    const double radius = width / 2, shaft = std::max(0.01, height - radius);
    const double deep = depth > 0 ? depth : radius;
    // A cylinder with a spherical end, scaled to the depth.
    const field::Field round = field::unite(
        {field::transformed(field::make("cylinder", {{"radius", radius}, {"height", shaft}}),
                            Transform::translation({radius, shaft / 2, 0})),
         field::transformed(field::make("sphere", {{"radius", radius}}),
                            Transform::translation({radius, shaft, 0}))});
    const field::Field pressed =
        field::transformed(round, Transform::scaling({1, 1, deep / radius}));
    out.cut.push_back(
        field::intersect({pressed, block({0, 0, width, height}, -deep - 0.1, kCutMargin)}));
    if (plinth > 0) {
      const double r = 0.55 * radius;
      out.add.push_back(field::transformed(revolved({{0, -0.1},
                                                     {r, -0.1},
                                                     {r, 0.6 * plinth},
                                                     {1.15 * r, 0.75 * plinth},
                                                     {1.15 * r, plinth},
                                                     {0, plinth}}),
                                           Transform::translation({radius, 0, -0.5 * deep})));
    }
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(niche) { return element_kind<Niche>("niche"); }
