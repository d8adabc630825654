// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/field/noise_node.h>
#include <vug/passages/water/drop_rings.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

using field::Ball;
using field::clamp, field::cos, field::max, field::sqrt, field::square;
using field::Point;

constexpr size_t kMostRings = 1000;
constexpr double kHalfPacket = 1.5;  // Wavelengths from the middle of a packet to its end.

/// A packet of waves.
struct Ring {
  double x = 0, z = 0;
  double radius = 0;  ///< Radius of the middle of the packet.
  double height = 1;
};

class Rings {
 public:
  explicit Rings(const DropRingsOptions& o)
      : wave_(2 * kPi / o.wavelength), half_(kHalfPacket * o.wavelength) {
    for (size_t i = 0; i < o.points.size(); ++i) {
      RandomStream random(RandomKey(o.seed).at("drop rings").at(i));
      Ring ring{o.points[i].x, o.points[i].z, random.uniform() * o.reach, 1};
      ring.height = 1 / std::sqrt(1 + ring.radius / o.wavelength);
      rings_.push_back(ring);
    }
    // Rings that can overlap at one point are all near each of them.
    size_t most = 0;
    for (const Ring& a : rings_)
      most = std::max(
          most, static_cast<size_t>(std::count_if(rings_.begin(), rings_.end(), [&](const Ring& b) {
            return std::hypot(a.x - b.x, a.z - b.z) <= a.radius + b.radius + 2 * half_;
          })));
    // The envelope (1 - t^2)^2 has a slope of at most 8 / (3 sqrt 3).
    slope_ = static_cast<double>(most) * (wave_ + 8 / (3 * std::sqrt(3.0)) / half_);
  }

  template <class T>
  T at(const Point<T>& p) const {
    T sum(0.0);
    for (const Ring& ring : rings_) {
      const T dx = p.x - T(ring.x), dz = p.z - T(ring.z);
      // Not 0 in the middle, where the slope has no direction.
      const T away = sqrt(dx * dx + dz * dz + T(1e-8)) - T(ring.radius);
      const T inside = max(T(1.0) - square(away * T(1 / half_)), T(0.0));
      sum = sum + T(ring.height) * inside * inside * cos(away * T(wave_));
    }
    return clamp(sum, T(-1.0), T(1.0));
  }
  Interval over(const Ball& ball) const { return field::centred_bounds(*this, ball); }
  Interval range() const { return {-1, 1}; }
  double lipschitz() const { return slope_; }

 private:
  std::vector<Ring> rings_;
  double wave_, half_, slope_ = 0;
};

}  // namespace

field::Noise drop_rings(const DropRingsOptions& options) {
  if (options.points.size() > kMostRings)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("{} points of drop rings are more than {}", options.points.size(), kMostRings),
        {}, "use the drops of one pool, or a 'budget' of drips");
  return field::formula_noise("drop_rings", Rings(options), options);
}

}  // namespace vug::passages
