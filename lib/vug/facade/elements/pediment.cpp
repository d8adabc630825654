// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>
#include <vug/facade/outline.h>
#include <vug/field/boolean.h>

#include <algorithm>
#include <cmath>

namespace vug::facade {
namespace {

struct Pediment {
  double projection = 0.3;
  double border = 0.2;

  static void describe(Schema<Pediment>& s) {
    s.doc("A gable of the size of its rectangle: a flat field within a moulding.")
        .param("projection", &Pediment::projection, positive_length("projection of the moulding"))
        .param("border", &Pediment::border, positive_length("width of the moulding"));
  }

  Solids solids(double width, double height) const {
    const double edge = std::min({border, width / 5, height / 3});
    const auto gable = [&](double inset, double back, double front) {
      // Inset on all three sides.
      const double slope = height / (width / 2), along = std::sqrt(1 + slope * slope);
      const double up = inset * along, side = inset * (1 + along) / slope;
      return extruded({{side, inset}, {width - side, inset}, {width / 2, height - up}}, back,
                      front);
    };
    Solids out;
    out.add.push_back(
        field::subtract(gable(0, -0.1, projection), {gable(edge, -1, projection + 1)}));
    out.add.push_back(field::subtract(gable(0.4 * edge, -0.1, 0.6 * projection),
                                      {gable(1.5 * edge, -1, projection + 1)}));
    out.add.push_back(gable(0.5 * edge, -0.1, 0.15 * projection));
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(pediment) { return element_kind<Pediment>("pediment"); }
