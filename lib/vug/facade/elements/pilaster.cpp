// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>
#include <vug/facade/outline.h>

#include <algorithm>

namespace vug::facade {
namespace {

struct Pilaster {
  double relief = 0.12;
  double base = 0.3;
  double capital = 0.3;

  static void describe(Schema<Pilaster>& s) {
    const auto length = [](std::string doc) {
      return ParamSpec{.doc = std::move(doc), .dimension = Dimension::length, .min = 0};
    };
    s.doc("A flat pier in front of the wall, of the width of its rectangle.")
        .param("relief", &Pilaster::relief, positive_length("projection of the pier"))
        .param("base", &Pilaster::base, length("height of the base; 0: none"))
        .param("capital", &Pilaster::capital, length("height of the capital; 0: none"));
  }

  Solids solids(double width, double height) const {
    if (!(base + capital < height))
      throw Error(ErrorCode::bad_input, "the base and the capital leave no space for the pilaster");
    Solids out;
    const double past = std::min(0.06, 0.15 * width), back = -0.1;
    out.add.push_back(block({past, 0, width - 2 * past, height}, back, relief));
    if (base > 0) out.add.push_back(block({0, 0, width, base}, back, relief + past, 0.3 * past));
    if (capital > 0) {
      const double low = height - capital;
      out.add.push_back(
          block({0.5 * past, low, width - past, 0.4 * capital}, back, relief + 0.5 * past));
      out.add.push_back(
          block({0, low + 0.4 * capital, width, 0.6 * capital}, back, relief + past, 0.2 * past));
    }
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(pilaster) { return element_kind<Pilaster>("pilaster"); }
