// SPDX-License-Identifier: Apache-2.0
// A sheet along Schoen's gyroid (schoen1970), in its usual approximation
//   g = sin x cos y + sin y cos z + sin z cos x.
// By Cauchy's inequality (cos x cos y - sin z sin x)^2 <= cos^2 y + sin^2 z, and the three parts of
// the squared gradient add up to at most 3: |g| / sqrt(3) is 1-Lipschitz in (x, y, z). The bound is
// attained at the origin, where the sheet has the stated thickness; elsewhere it is thicker.
#include <vug/field/primitive.h>

namespace vug::field {
namespace {

struct GyroidShape {
  double period, thickness;
  double per_period = 1 / period;
  double scale = period / (2 * kPi * std::sqrt(3.0));

  /// 2 pi x / period, reduced to [-pi, pi] where the number type permits it.
  template <class T>
  T phase(const T& x) const {
    const T turns = x * T(per_period);
    if constexpr (std::is_same_v<T, Interval>) return turns * T(2 * kPi);
    return (turns - floor(turns + T(0.5))) * T(2 * kPi);
  }
  template <class T>
  T distance(const Point<T>& p) const {
    const T x = phase(p.x), y = phase(p.y), z = phase(p.z);
    const T g = sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x);
    return abs(g) * T(scale) - T(0.5 * thickness);
  }
  Box3d bounds() const { return infinite_box(); }
  Exactness exactness() const { return Exactness::bound; }
};

struct Gyroid {
  double period = 1;
  double thickness = 0.1;

  static void describe(Schema<Gyroid>& s) {
    s.doc("An infinite sheet that separates space into two intertwined tunnels.")
        .cite("schoen1970")
        .param("period", &Gyroid::period, positive_length("period along each axis"))
        .param("thickness", &Gyroid::thickness,
               positive_length("thickness of the sheet at its thinnest, below 0.27 periods"));
  }
  std::string fault() const {
    // |g| reaches 3/2: a thicker sheet would leave no air.
    return thickness < 3 * shape().scale ? "" : "a gyroid this thick fills all of space";
  }
  GyroidShape shape() const { return {period, thickness}; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(gyroid) { return primitive_kind<Gyroid>("gyroid"); }
