// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::facade {
namespace {

struct Stairs {
  double going = 0.32;
  double riser = 0.16;

  static void describe(Schema<Stairs>& s) {
    s.doc("Steps in front of the wall that rise to it, of the size of their rectangle.")
        .param("going", &Stairs::going, positive_length("depth of a step"))
        .param("riser", &Stairs::riser, positive_length("approximate height of a step"));
  }

  Solids solids(double width, double height) const {
    const double steps = std::max(1.0, std::round(height / riser));
    if (steps > 2000)
      throw Error(ErrorCode::too_large, fmt::format("too many steps of stairs: {:.3g}", steps));
    Solids out;
    for (int i = 0; i < static_cast<int>(steps); ++i) {
      const double front = (steps - i) * going, top = (i + 1) * height / steps;
      out.add.push_back(block({0, 0, width, top}, -0.1, front, 0.015));
    }
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(stairs) { return element_kind<Stairs>("stairs"); }
