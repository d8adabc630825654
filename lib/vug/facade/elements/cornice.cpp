// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/facade/blocks.h>
#include <vug/facade/outline.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::facade {
namespace {

struct Cornice {
  double projection = 0;
  double dentils = 0;
  double past = 0;

  static void describe(Schema<Cornice>& s) {
    const auto length = [](std::string doc) {
      return ParamSpec{.doc = std::move(doc), .dimension = Dimension::length, .min = 0};
    };
    s.doc(
         "A moulding along the wall as high as its rectangle: a hollow, a drip and a wave above "
         "it.")
        .param("projection", &Cornice::projection,
               length("projection of the cornice; 0: its height"))
        .param("dentils", &Cornice::dentils,
               length("distance between the dentils below it; 0: none"))
        .param("past", &Cornice::past, length("overhang at both ends"));
  }

  Solids solids(double width, double height) const {
    const double out_most = projection > 0 ? projection : height;
    const double h = height, p = out_most;
    Outline outline{{-0.1, 0}, {0.12 * p, 0}, {0.12 * p, 0.3 * h}};
    // A quarter-circle cove up to the drip, then an S-curve.
    for (int i = 1; i <= 6; ++i) {
      const double t = i / 6.0 * kPi / 2;
      outline.push_back({(0.12 + 0.5 * (1 - maths::cos(t))) * p, (0.3 + 0.22 * maths::sin(t)) * h});
    }
    outline.push_back({0.78 * p, 0.52 * h});
    outline.push_back({0.78 * p, 0.72 * h});
    for (int i = 0; i <= 8; ++i) {
      const double t = i / 8.0;
      outline.push_back({(0.89 - 0.11 * maths::cos(t * kPi)) * p, (0.72 + 0.22 * t) * h});
    }
    outline.push_back({p, h});
    outline.push_back({-0.1, h});
    Solids out;
    out.add.push_back(moulding(outline, -past, width + past));
    if (dentils > 0) {
      const double count = std::floor(width / dentils);
      if (count > 5000)
        throw Error(ErrorCode::too_large,
                    fmt::format("too many dentils of a cornice: {:.3g}", count));
      const double step = width / std::max(1.0, count);
      for (int i = 0; i < static_cast<int>(count); ++i)
        out.add.push_back(
            block({(i + 0.22) * step, 0.12 * h, 0.56 * step, 0.26 * h}, -0.05, 0.36 * p));
    }
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(cornice) { return element_kind<Cornice>("cornice"); }
