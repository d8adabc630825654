// SPDX-License-Identifier: Apache-2.0
// Blends between solids: smooth minima of compact support. All have the form
//   smin(a, b) = min(a, b) - k g(h),  h = max(0, 1 - |a - b| / k),
// so operands that differ by more than k do not affect each other, and 1-Lipschitz operands give a
// 1-Lipschitz result.
#pragma once

#include <vug/base/schema.h>
#include <vug/field/point.h>

namespace vug::field {

enum class Profile {
  sharp,    ///< min(a, b).
  smooth,   ///< Quadratic, g = h^2/4 (quilez2013smin): a soft fillet.
  round,    ///< g = (1 + h - sqrt(1 - h (h - 2))) / 2: a fillet of radius k between square faces.
  chamfer,  ///< g = h/2: a flat cut whose legs are k.
};

struct Blend {
  Profile profile = Profile::sharp;
  double radius = 0;  ///< k, metres: where |a - b| >= k the operands do not blend.

  /// The maximum of min - smin.
  double depth() const;

  template <class T>
  T smin(const T& a, const T& b) const {
    if (profile == Profile::sharp || radius <= 0) return min(a, b);
    const T h = max(T(0.0), T(1.0) - abs(a - b) * T(1.0 / radius));
    return min(a, b) - T(radius) * kernel(h);
  }
  /// The share of b in smin(a, b), by which materials mix (quilez2013smin): 0 where b does not
  /// affect the value, 1/2 where a = b, 1 where a does not affect it; continuous if the blend is
  /// not sharp.
  double share(double a, double b) const {
    const double h = radius > 0 ? max(0.0, 1 - abs(a - b) / radius) : 0;
    const double farther = profile == Profile::sharp ? 0 : kernel(h) / (2 * kernel(1.0));
    return a <= b ? farther : 1 - farther;
  }

 private:
  /// g(h) with g(0) = 0 and slope at most 1/2 on [0, 1], which keeps both weights in [0, 1].
  template <class T>
  T kernel(const T& h) const {
    switch (profile) {
      case Profile::smooth:
        return h * h * T(0.25);
      case Profile::chamfer:
        return h * T(0.5);
      case Profile::round:
        return T(0.5) * (T(1.0) + h - sqrt(T(1.0) - h * (h - T(2.0))));
      case Profile::sharp:
        break;
    }
    return T(0.0);
  }
};

}  // namespace vug::field

namespace vug {

template <>
struct ValueTraits<field::Blend> : ObjectTraits<field::Blend> {
  static constexpr const char* kWord = "blend";
  static std::optional<field::Blend> read(const Value& v) {
    if (const auto* b = v.object<field::Blend>()) return *b;
    const auto* name = v.get<Value::Name>();
    return name && name->text == "sharp" ? std::optional(field::Blend{}) : std::nullopt;
  }
  static Value write(const field::Blend& b) {
    if (b.profile == field::Profile::sharp) return Value::Name{"sharp"};
    return ObjectTraits::write(b);
  }
};

}  // namespace vug
