// SPDX-License-Identifier: Apache-2.0
// The lens between two equal circular arcs (vesica), after quilez2008distance: the nearest point
// lies on the arc of the point's side, or is the nearer tip beyond the arc's end.
#include <vug/field/numbers/scalar.h>
#include <vug/passages/polygon_section.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

using field::abs, field::max, field::select, field::sign, field::sqrt, field::square;

class Vesica final : public SectionModes<Vesica> {
 public:
  /// `half` is half the distance between the tips, `bulge` half the thickness, at most `half`; the
  /// tips lie along u, or along v if `upright`, before the tilt.
  Vesica(double half, double bulge, bool upright, double tilt)
      : SectionModes(traits_of(half, bulge, upright, tilt)),
        half_(half),
        radius_((half * half + bulge * bulge) / (2 * bulge)),
        offset_(radius_ - bulge) {
    // A quarter turn is written out, so that upright lenses are exactly symmetric.
    cosine_ = upright ? -maths::sin(tilt) : maths::cos(tilt);
    sine_ = upright ? maths::cos(tilt) : maths::sin(tilt);
  }

  template <class S>
  PlaneDistance<S> sample(const S& u, const S& v) const {
    const S x = u * S(cosine_) + v * S(sine_), y = v * S(cosine_) - u * S(sine_);
    const S px = abs(x), py = abs(y), past = px - S(half_);
    const auto beyond = past * S(offset_) > py * S(half_);
    const S ox = select(beyond, past, px), oy = select(beyond, py, py + S(offset_));
    const S away = sqrt(square(ox) + square(oy));
    const S inverse = S(1.0) / max(away, S(1e-18));
    const S dx = ox * inverse * sign(x), dy = oy * inverse * sign(y);
    // away - radius without the difference of large numbers, as flat lenses have them.
    const S side = (past * (px + S(half_)) + py * (py + S(2 * offset_))) / (away + S(radius_));
    return {select(beyond, away, side), dx * S(cosine_) - dy * S(sine_),
            dx * S(sine_) + dy * S(cosine_)};
  }

  std::vector<Vec2d> outline(int count) const override {
    std::vector<Vec2d> points;
    const double open = maths::atan2(half_, offset_);  // From v to a tip, seen from the centre.
    const int each = std::max(2, count / 2);
    append_arc(points, {0, -offset_}, Vec2d(radius_), kPi / 2 - open, kPi / 2 + open, each);
    points.pop_back();
    append_arc(points, {0, offset_}, Vec2d(radius_), -kPi / 2 - open, -kPi / 2 + open, each);
    points.pop_back();
    for (Vec2d& p : points) p = {p.x * cosine_ - p.y * sine_, p.x * sine_ + p.y * cosine_};
    return points;
  }

 protected:
  void add_numbers_to(Digester& digester) const override {
    digester(half_, radius_, offset_, cosine_, sine_);
  }

 private:
  static SectionTraits traits_of(double half, double bulge, bool upright, double tilt) {
    const double radius = (half * half + bulge * bulge) / (2 * bulge), offset = radius - bulge;
    const double angle = tilt + (upright ? kPi / 2 : 0);
    SectionTraits traits;
    const double c = std::abs(maths::cos(angle)), s = std::abs(maths::sin(angle));
    // The support function: a normal touches an arc, or a tip if it is too close to their axis.
    const auto extent = [&](double tip, double side) {
      return side * radius >= offset ? radius - offset * side : half * tip;
    };
    traits.max = {extent(c, s), extent(s, c)};
    traits.min = -traits.max;
    traits.reach = half;
    traits.core = traits.depth = bulge;
    const double open = maths::atan2(half, offset);
    traits.area = 2 * radius * radius * open - 2 * offset * half;
    return traits;
  }

  double half_, radius_, offset_, cosine_, sine_;
};

struct Lens {
  double tilt = 0;

  static void describe(Schema<Lens>& s) {
    s.doc("The lens of a passage along a bedding plane, with sharp edges on both sides.")
        .cite("quilez2008distance")
        .param("tilt", &Lens::tilt,
               {.doc = "of the horizontal axis towards up on the right, e.g. the dip of the bed",
                .dimension = Dimension::angle,
                .min = -kPi / 2,
                .max = kPi / 2});
  }
  SectionPtr fit(const SectionPlace& place) const {
    const bool upright = place.height > place.width;
    return std::make_shared<Vesica>(0.5 * std::max(place.width, place.height),
                                    0.5 * std::min(place.width, place.height), upright, tilt);
  }
};

}  // namespace
}  // namespace vug::passages

VUG_SECTION_KIND(lens) { return section_kind<Lens>("lens"); }
