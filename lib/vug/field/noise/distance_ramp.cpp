// SPDX-License-Identifier: Apache-2.0
#include <vug/field/modifier.h>
#include <vug/field/noise.h>

#include <cmath>

namespace vug::field {
namespace {

struct DistanceRamp {
  Field field;
  double from = 1, to = 2;

  static void describe(Schema<DistanceRamp>& s) {
    s.doc(
         "-1 where a field has the value `from`, 1 where it has the value `to`, linear between: as "
         "a mask it keeps drips or a displacement away from a path, or near it if `from` is larger "
         "than `to`.")
        .param(
            "field", &DistanceRamp::field,
            {.doc = "a solid or another field, such as centreline(of: NETWORK)", .required = true})
        .param("from", &DistanceRamp::from, any_length("value of the field where the noise is -1"))
        .param("to", &DistanceRamp::to, any_length("value of the field where the noise is 1"));
  }
  std::string fault() const { return from == to ? "'from' and 'to' must differ" : ""; }

  double slope() const { return 2 / (to - from); }

  template <class T>
  T apply(const T& value, const Point<T>&) const {
    return min(T(1.0), max(T(-1.0), (value - T(from)) * T(slope()) - T(1.0)));
  }
  Traits traits(const Traits& child) const {
    Traits out;
    out.lipschitz = child.lipschitz * std::fabs(slope());
    out.exactness = Exactness::sign;
    out.bounds = infinite_box();
    return out;
  }
  Interval range(Interval child) const {
    return min(Interval(1.0),
               max(Interval(-1.0), (child - Interval(from)) * Interval(slope()) - Interval(1.0)));
  }
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(distance_ramp) {
  return make_kind<Noise, DistanceRamp>("distance_ramp", "noise", [](const DistanceRamp& p) {
    const Field values(
        std::make_shared<ModifierNode<DistanceRamp>>("distance_ramp", p, p.field.node()));
    return Noise(values, {-1, 1});
  });
}
