// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/field/deformer.h>
#include <vug/field/modifier.h>
#include <vug/field/speleothems/turned.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

constexpr double kFirstShare = 0.65;  // Of the depth, of the wave with `count` ribs.

/// cos(n a) (r / radius)^n at the angle a is the real part of (x + i z)^n: no angle is computed,
/// and the wave fades out towards the axis. Beyond the radius, points are moved to it.
struct FluteModifier {
  int first, second;
  double depth, radius, cosine[2], sine[2];

  template <class T>
  T wave(const T& x, const T& z, int count, int which) const {
    T a = x, b = z, u(1.0), v(0.0);
    for (int n = count; n > 0; n /= 2) {
      if (n % 2) {
        const T next = u * a - v * b;
        v = u * b + v * a;
        u = next;
      }
      const T next = square(a) - square(b);
      b = a * b * T(2.0);
      a = next;
    }
    return u * T(cosine[which]) - v * T(sine[which]);
  }
  template <class T>
  T apply(const T& value, const Point<T>& p) const {
    const T scale = T(1.0) / max(length(p.x, p.z), T(radius));
    const T x = p.x * scale, z = p.z * scale;
    return value - T(kFirstShare * depth) * wave(x, z, first, 0) -
           T((1 - kFirstShare) * depth) * wave(x, z, second, 1);
  }
  Traits traits(const Traits& child) const {
    Traits out = child;
    out.growth = child.growth_rate();
    out.lipschitz += depth * (kFirstShare * first + (1 - kFirstShare) * second) / radius;
    out.exactness = Exactness::sign;
    out.bounds = child.bounds_below(depth);
    return out;
  }
  Interval range(Interval child) const { return {child.lo - depth, child.hi + depth}; }
  void add_to(Digester& digester) const {
    digester(first, second, depth, radius, cosine[0], cosine[1], sine[0], sine[1]);
  }
};

struct BendDeformer {
  BendProfile profile;
  Vec3d offset;
  double from, inverse, steepest;

  template <class T>
  T factor(const T& y) const {
    const T t = clamp((y - T(from)) * T(inverse), T(0.0), T(1.0)), rest = T(1.0) - t;
    if (profile == BendProfile::foot) return square(rest);
    return square(rest) * (T(1.0) + T(2.0) * t);
  }
  template <class T>
  Point<T> map(const Point<T>& p) const {
    const T f = factor(p.y);
    return {p.x - T(offset.x) * f, p.y, p.z - T(offset.z) * f};
  }
  Ball map(const Ball& ball) const {
    return {vector(map(point(ball.centre))), ball.radius * (1 + steepest)};
  }
  double scale() const { return 1; }
  Traits traits(const Traits& child) const {
    Traits out = child;
    out.growth = child.growth_rate() / (1 + steepest);
    out.lipschitz *= 1 + steepest;
    out.exactness = Exactness::sign;
    out.bounds = child.bounds;
    if (!out.bounds.isEmpty()) {
      const Vec3d low(std::min(offset.x, 0.0), 0, std::min(offset.z, 0.0)),
          high(std::max(offset.x, 0.0), 0, std::max(offset.z, 0.0));
      out.bounds = Box3d(child.bounds.min + low, child.bounds.max + high);
    }
    return out;
  }
};

}  // namespace

Field fluted(const Field& turned, const Flutes& f, RandomKey key) {
  if (f.count < 1 || !(f.depth > 0)) return turned;
  RandomStream random(key);
  FluteModifier flutes{f.count, 0, f.depth, f.radius, {}, {}};
  flutes.second = std::max(2, static_cast<int>(f.count * random.uniform(0.3, 0.8)));
  for (int i = 0; i < 2; ++i) {
    const double phase = random.uniform(0, 2 * kPi);
    flutes.cosine[i] = maths::cos(phase);
    flutes.sine[i] = maths::sin(phase);
  }
  return Field(std::make_shared<ModifierNode<FluteModifier>>("fluted", flutes, turned.node()));
}

Field bent(const Field& turned, const Bend& b) {
  if (!(b.offset.length2() > 0)) return turned;
  const double height = std::max(b.to - b.from, 1e-6);
  const double steepest = (b.profile == BendProfile::foot ? 2 : 1.5) * b.offset.length() / height;
  const BendDeformer deformer{b.profile, b.offset, b.from, 1 / height, steepest};
  return Field(std::make_shared<DeformerNode<BendDeformer>>("bent", deformer, turned.node()));
}

}  // namespace vug::field
