// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>
#include <vug/facade/outline.h>
#include <vug/field/affine.h>
#include <vug/field/registry.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::facade {
namespace {

struct Balcony {
  double projection = 0.7;
  double slab = 0.15;
  double rail = 0.95;
  double spacing = 0.13;
  double bar = 0.025;

  static void describe(Schema<Balcony>& s) {
    s.doc("A slab in front of the foot of its rectangle, with brackets and a railing of bars.")
        .param("projection", &Balcony::projection, positive_length("projection of the slab"))
        .param("slab", &Balcony::slab, positive_length("thickness of the slab"))
        .param("rail", &Balcony::rail, positive_length("height of the railing above the slab"))
        .param("spacing", &Balcony::spacing, positive_length("distance between bars"))
        .param("bar", &Balcony::bar, positive_length("thickness of the bars"));
  }

  Solids solids(double width, double) const {
    Solids out;
    const double front = projection - 0.05, count = std::floor(width / spacing);
    if (count > 2000)
      throw Error(ErrorCode::too_large, fmt::format("too many bars of a railing: {:.3g}", count));
    out.add.push_back(moulding({{-0.1, -slab},
                                {0.9 * projection, -slab},
                                {projection, -0.6 * slab},
                                {projection, 0},
                                {-0.1, 0}},
                               0, width));
    for (const double x : {0.08 * width, 0.92 * width})
      out.add.push_back(moulding({{-0.1, -slab - 0.5 * projection},
                                  {0.06, -slab - 0.5 * projection},
                                  {0.6 * projection, -slab + 0.02},
                                  {-0.1, -slab + 0.02}},
                                 x - 0.06, x + 0.06));
    const auto bar_at = [&](double x, double z) {
      return field::transformed(field::make("cylinder", {{"radius", bar / 2}, {"height", rail}}),
                                Transform::translation({x, rail / 2, z}));
    };
    const double half = bar / 2;
    for (int i = 0; i <= static_cast<int>(count); ++i)
      out.fill.push_back(bar_at(half + (width - bar) * i / std::max(1.0, count), front));
    const int deep = std::max(1, static_cast<int>(front / spacing));
    for (int i = 0; i < deep; ++i)
      for (const double x : {half, width - half}) out.fill.push_back(bar_at(x, front * i / deep));
    out.fill.push_back(block({0, rail - 0.04, width, 0.04}, front - 0.02, front + 0.02, 0.01));
    for (const double x : {0.0, width - 0.04})
      out.fill.push_back(block({x, rail - 0.04, 0.04, 0.04}, 0, front, 0.01));
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(balcony) { return element_kind<Balcony>("balcony"); }
