// SPDX-License-Identifier: Apache-2.0
// The ellipse of a phreatic tube.
#include <vug/field/numbers/scalar.h>
#include <vug/passages/polygon_section.h>
#include <vug/passages/sections/ellipse.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

using field::max, field::sqrt, field::square;

class Ellipse final : public SectionModes<Ellipse> {
 public:
  Ellipse(double a, double b, double tilt)
      : SectionModes(traits_of(a, b, tilt)),
        a_(a),
        b_(b),
        round_(a == b),
        steps_(ellipse_steps(std::max(a, b) / std::min(a, b))),
        cosine_(maths::cos(tilt)),
        sine_(maths::sin(tilt)) {}

  template <class S>
  PlaneDistance<S> sample(const S& u, const S& v) const {
    if (round_) {
      const S radius = sqrt(square(u) + square(v));
      const S inverse = S(1.0) / max(radius, S(1e-18));
      return {radius - S(a_), u * inverse, v * inverse};
    }
    const S x = u * S(cosine_) + v * S(sine_), y = v * S(cosine_) - u * S(sine_);
    const PlaneDistance<S> d = ellipse_distance(S(a_), S(b_), x, y, steps_);
    return {d.value, d.du * S(cosine_) - d.dv * S(sine_), d.du * S(sine_) + d.dv * S(cosine_)};
  }

  std::optional<EllipseAxes> ellipse() const override {
    return EllipseAxes{{a_ * cosine_, a_ * sine_}, {-b_ * sine_, b_ * cosine_}};
  }

  std::vector<Vec2d> outline(int count) const override {
    std::vector<Vec2d> points;
    append_arc(points, {0, 0}, {a_, b_}, 0, 2 * kPi, std::max(count, 3));
    points.pop_back();
    for (Vec2d& p : points) p = {p.x * cosine_ - p.y * sine_, p.x * sine_ + p.y * cosine_};
    return points;
  }

 protected:
  void add_numbers_to(Digester& digester) const override { digester(a_, b_, cosine_, sine_); }

 private:
  static SectionTraits traits_of(double a, double b, double tilt) {
    const double c = maths::cos(tilt), s = maths::sin(tilt);
    SectionTraits traits;
    traits.max = {std::sqrt(a * a * c * c + b * b * s * s),
                  std::sqrt(a * a * s * s + b * b * c * c)};
    traits.min = -traits.max;
    traits.reach = std::max(a, b);
    traits.core = traits.depth = std::min(a, b);
    traits.area = kPi * a * b;
    return traits;
  }

  double a_, b_;
  bool round_;
  int steps_;
  double cosine_, sine_;
};

struct Tube {
  double tilt = 0;

  static void describe(Schema<Tube>& s) {
    s.doc("The ellipse of a passage that water filled completely (phreatic).")
        .param("tilt", &Tube::tilt,
               {.doc = "of the horizontal axis towards up on the right, e.g. the dip of the bed",
                .dimension = Dimension::angle,
                .min = -kPi / 2,
                .max = kPi / 2});
  }
  /// The half-axes of the ellipse with the tilt; its bounding rectangle is that of the place only
  /// if the tilt is 0.
  SectionPtr fit(const SectionPlace& place) const {
    return std::make_shared<Ellipse>(0.5 * place.width, 0.5 * place.height, tilt);
  }
};

}  // namespace
}  // namespace vug::passages

VUG_SECTION_KIND(tube) { return section_kind<Tube>("tube"); }
