// SPDX-License-Identifier: Apache-2.0
#include <vug/paint/kind.h>

#include <algorithm>

namespace vug::paint {
namespace {

struct Gradient {
  Mask mask;
  std::vector<Vec3d> colors;

  static void describe(Schema<Gradient>& s) {
    s.doc("Evenly spaced colours along a mask, from 0 to 1.")
        .param("mask", &Gradient::mask,
               {.doc = "position on the gradient, 0 to 1", .required = true})
        .param("colors", &Gradient::colors,
               {.doc = "linear Rec.709 albedos, as a list", .min = 0, .max = 1, .required = true});
  }
};

Vec3d gradient_color(const std::vector<Vec3d>& colors, double t) {
  if (colors.empty()) return Vec3d(0.5);
  const double x = std::clamp(t, 0.0, 1.0) * static_cast<double>(colors.size() - 1);
  const size_t i = std::min(static_cast<size_t>(x), colors.size() - 1);
  const size_t next = std::min(i + 1, colors.size() - 1);
  const double share = x - static_cast<double>(i);
  return colors[i] * (1 - share) + colors[next] * share;
}

}  // namespace
}  // namespace vug::paint

VUG_PAINT_KIND(gradient) {
  return paint_kind<Gradient>("gradient", [](const Gradient& g) {
    return make_paint(
        [g](const EvalPoint& point) { return gradient_color(g.colors, (*g.mask)(point)); },
        g.mask->uses());
  });
}
