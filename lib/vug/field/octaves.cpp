// SPDX-License-Identifier: Apache-2.0
#include <vug/base/rng.h>
#include <vug/base/transform.h>
#include <vug/field/octaves.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

/// A uniformly distributed random rotation (a random unit quaternion: Marsaglia 1972).
Transform random_rotation(RandomStream& random) {
  double q[4], squared = 0;
  do {
    squared = 0;
    for (double& x : q) {
      x = random.uniform(-1, 1);
      squared += x * x;
    }
  } while (squared > 1 || squared < 0.01);
  const Vec3d axis(q[1], q[2], q[3]);
  if (axis.length2() < 1e-12) return {};
  return Transform::rotation(axis, 2 * maths::atan2(axis.length(), q[0]));
}

}  // namespace

Octaves::Octaves(const OctaveParams& params) {
  const RandomKey key = RandomKey(static_cast<uint64_t>(params.seed)).at("noise");
  double frequency = 1, strength = 1, squares = 0;
  for (int i = 0; i < params.octaves; ++i) {
    RandomStream random(key.at(static_cast<uint64_t>(i)));
    const Transform turn = random_rotation(random);
    Layer layer;
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c)
        layer.rows[r][c] = turn.column(c)[r] * frequency / params.scale.each[c];
      layer.shift[r] = random.uniform(0, 1);
    }
    layer.weight = strength;
    const Vec3d& s = params.scale.each;
    layer.slope = kGradientNoiseSlope * frequency / std::min({s.x, s.y, s.z});
    layer.seed = random.bits();
    layers_.push_back(layer);
    squares += strength * strength;
    frequency *= params.lacunarity;
    strength *= params.gain;
  }
  for (Layer& layer : layers_) layer.weight /= std::sqrt(squares);
}

Interval Octaves::noise(int i, const Ball& ball) const {
  constexpr Interval all(-kGradientNoiseBound, kGradientNoiseBound);
  const double reach = slope(i) * ball.radius;
  if (reach >= all.width()) return all;
  const double value = noise(i, point(ball.centre));
  return intersection({value - reach, value + reach}, all);
}

}  // namespace vug::field
