// SPDX-License-Identifier: Apache-2.0
// The rectangle with rounded corners of a joint slot (quilez2008distance).
#include <vug/field/numbers/scalar.h>
#include <vug/passages/polygon_section.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

using field::abs, field::max, field::min, field::select, field::sign, field::sqrt, field::square;

class RoundedRectangle final : public SectionModes<RoundedRectangle> {
 public:
  RoundedRectangle(const Vec2d& half, double radius, double tilt)
      : SectionModes(traits_of(half, radius, tilt)),
        inner_(half - Vec2d(radius)),
        radius_(radius),
        cosine_(maths::cos(tilt)),
        sine_(maths::sin(tilt)) {}

  template <class S>
  PlaneDistance<S> sample(const S& u, const S& v) const {
    const S x = u * S(cosine_) + v * S(sine_), y = v * S(cosine_) - u * S(sine_);
    const S qx = abs(x) - S(inner_.x), qy = abs(y) - S(inner_.y);
    const S ox = max(qx, S(0.0)), oy = max(qy, S(0.0));
    const S corner = sqrt(square(ox) + square(oy)), side = max(qx, qy);
    const auto outside = corner > S(0.0);
    const S inverse = S(1.0) / max(corner, S(1e-18));
    const auto wide = qx > qy;
    const S dx = select(outside, ox * inverse, select(wide, S(1.0), S(0.0))) * sign(x);
    const S dy = select(outside, oy * inverse, select(wide, S(0.0), S(1.0))) * sign(y);
    return {select(outside, corner, side) - S(radius_), dx * S(cosine_) - dy * S(sine_),
            dx * S(sine_) + dy * S(cosine_)};
  }

  std::vector<Vec2d> outline(int count) const override {
    const double length = 4 * (inner_.x + inner_.y) + 2 * kPi * radius_;
    const double step = length / std::max(count, 4);
    std::vector<Vec2d> points;
    for (int corner = 0; corner < 4; ++corner) {
      const Vec2d at(corner == 0 || corner == 3 ? inner_.x : -inner_.x,
                     corner < 2 ? inner_.y : -inner_.y);
      const double from = 0.5 * kPi * corner;
      const int turns = std::max(1, static_cast<int>(std::ceil(0.5 * kPi * radius_ / step)));
      if (radius_ > 0)
        append_arc(points, at, Vec2d(radius_), from, from + 0.5 * kPi, turns);
      else
        points.push_back(at);
      const double side = 2 * (corner % 2 == 0 ? inner_.x : inner_.y);
      const Vec2d way(corner == 0   ? -1
                      : corner == 2 ? 1
                                    : 0,
                      corner == 1   ? -1
                      : corner == 3 ? 1
                                    : 0);
      const int pieces = static_cast<int>(std::ceil(side / step));
      const Vec2d start = points.back();
      for (int k = 1; k < pieces; ++k) points.push_back(start + way * (side * k / pieces));
    }
    for (Vec2d& p : points) p = {p.x * cosine_ - p.y * sine_, p.x * sine_ + p.y * cosine_};
    return points;
  }

 protected:
  void add_numbers_to(Digester& digester) const override {
    digester(inner_, radius_, cosine_, sine_);
  }

 private:
  static SectionTraits traits_of(const Vec2d& half, double radius, double tilt) {
    const double c = std::abs(maths::cos(tilt)), s = std::abs(maths::sin(tilt));
    const Vec2d inner = half - Vec2d(radius);
    SectionTraits traits;
    traits.max = {inner.x * c + inner.y * s + radius, inner.x * s + inner.y * c + radius};
    traits.min = -traits.max;
    traits.reach = inner.length() + radius;
    traits.core = traits.depth = std::min(half.x, half.y);
    traits.area = 4 * half.x * half.y - (4 - kPi) * radius * radius;
    return traits;
  }

  Vec2d inner_;
  double radius_, cosine_, sine_;
};

struct Slot {
  double rounding = 0.5;
  double tilt = 0;

  static void describe(Schema<Slot>& s) {
    s.doc("The slot of a passage along a joint: two parallel walls with round ends.")
        .cite("quilez2008distance")
        .param("rounding", &Slot::rounding,
               section_fraction("radius of the corners as a fraction of half the smaller size"))
        .param("tilt", &Slot::tilt,
               {.doc = "of the horizontal axis towards up on the right, e.g. the joint's hade",
                .dimension = Dimension::angle,
                .min = -kPi / 2,
                .max = kPi / 2});
  }
  SectionPtr fit(const SectionPlace& place) const {
    const Vec2d half(0.5 * place.width, 0.5 * place.height);
    return std::make_shared<RoundedRectangle>(half, rounding * std::min(half.x, half.y), tilt);
  }
};

}  // namespace
}  // namespace vug::passages

VUG_SECTION_KIND(slot) { return section_kind<Slot>("slot"); }
