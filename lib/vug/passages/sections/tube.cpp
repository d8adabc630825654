// SPDX-License-Identifier: Apache-2.0
// The ellipse of a phreatic tube. The distance is the largest n . p - h(n) over unit normals n,
// with h(n) = |(a n_u, b n_v)| the ellipse's support function. The normal results from steps to the
// centre of curvature of the last point (a fixed number of them for single precision); the value is
// a lower bound for any n, with an error quadratic in that of n.
#include <vug/field/numbers/scalar.h>
#include <vug/passages/polygon_section.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace vug::passages {
namespace {

using field::abs, field::clamp, field::max, field::select, field::sign, field::sqrt, field::square;

class Ellipse final : public SectionModes<Ellipse> {
 public:
  Ellipse(double a, double b, double tilt)
      : SectionModes(traits_of(a, b, tilt)),
        a_(a),
        b_(b),
        round_(a == b),
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
    const PlaneDistance<S> first = quadrant(S(abs(x)), S(abs(y)));
    const S dx = first.du * sign(x), dy = first.dv * sign(y);
    return {first.value, dx * S(cosine_) - dy * S(sine_), dx * S(sine_) + dy * S(cosine_)};
  }

  std::vector<Vec2d> outline(int count) const override {
    std::vector<Vec2d> points;
    append_arc(points, {0, 0}, {a_, b_}, 0, 2 * kPi, std::max(count, 3));
    points.pop_back();
    for (Vec2d& p : points) p = {p.x * cosine_ - p.y * sine_, p.x * sine_ + p.y * cosine_};
    return points;
  }

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

  /// The point of the ellipse that is nearest to (x, y) is (a cu, b cv).
  template <class S>
  PlaneDistance<S> quadrant(const S& x, const S& y) const {
    constexpr int kSteps = std::is_same_v<S, double> ? 24 : 4;
    const double gap = a_ * a_ - b_ * b_;
    S cu(0.7071067811865475), cv(0.7071067811865475);
    for (int i = 0; i < kSteps; ++i) {
      const S ex = S(gap / a_) * cu * cu * cu, ey = S(-gap / b_) * cv * cv * cv;
      const S rx = S(a_) * cu - ex, ry = S(b_) * cv - ey;
      const S qx = x - ex, qy = y - ey;
      const S ratio = sqrt((square(rx) + square(ry)) / max(square(qx) + square(qy), S(1e-30)));
      const S nu = clamp((qx * ratio + ex) * S(1 / a_), S(0.0), S(1.0));
      const S nv = clamp((qy * ratio + ey) * S(1 / b_), S(0.0), S(1.0));
      const S size = S(1.0) / max(sqrt(square(nu) + square(nv)), S(1e-18));
      const S next_u = nu * size, next_v = nv * size;
      [[maybe_unused]] const S change = abs(next_u - cu) + abs(next_v - cv);
      cu = next_u;
      cv = next_v;
      if constexpr (std::is_same_v<S, double>)  // The value's error is quadratic in the next step.
        if (change < 1e-9) break;
    }
    S nu = cu * S(b_), nv = cv * S(a_);
    const S size = S(1.0) / max(sqrt(square(nu) + square(nv)), S(1e-18));
    nu = nu * size;
    nv = nv * size;
    const S support = sqrt(square(S(a_) * nu) + square(S(b_) * nv));
    return {nu * x + nv * y - support, nu, nv};
  }

  double a_, b_;
  bool round_;
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
