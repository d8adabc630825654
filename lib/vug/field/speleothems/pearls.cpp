// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/field/speleothems/pearls.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

constexpr int kDirections = 12;

/// The height of the middle of a ball that is let down at a place until it touches.
class Landing {
 public:
  Landing(const PearlBowl& bowl, const std::vector<Lobe>& lying) : bowl_(bowl), lying_(lying) {}

  double height(double x, double z, double radius) const {
    const double inner = bowl_.curvature() - radius;
    double high = bowl_.curvature() - std::sqrt(std::max(inner * inner - x * x - z * z, 0.0));
    for (const Lobe& other : lying_) {
      const double dx = x - other.centre.x, dz = z - other.centre.z;
      const double touch = radius + other.radius;
      const double left = touch * touch - dx * dx - dz * dz;
      if (left > 0) high = std::max(high, other.centre.y + std::sqrt(left));
    }
    return high;
  }
  /// The place below which the ball rests, by a pattern search down the slope.
  Vec3d rest(double x, double z, double radius) const {
    const double most = bowl_.mouth - radius;
    double low = height(x, z, radius);
    for (double step = 0.5 * radius; step > 1e-4 * radius; step *= 0.5) {
      for (bool moved = true; moved;) {
        moved = false;
        for (int k = 0; k < kDirections; ++k) {
          const double angle = 2 * kPi * k / kDirections;
          const double to_x = x + step * maths::cos(angle), to_z = z + step * maths::sin(angle);
          if (to_x * to_x + to_z * to_z > most * most) continue;
          const double there = height(to_x, to_z, radius);
          if (!(there < low - 1e-6 * step)) continue;
          low = there;
          x = to_x;
          z = to_z;
          moved = true;
        }
      }
    }
    return {x, low, z};
  }

 private:
  const PearlBowl& bowl_;
  const std::vector<Lobe>& lying_;
};

}  // namespace

std::vector<Lobe> packed_pearls(const PearlBowl& bowl, const std::vector<double>& radii,
                                RandomStream& random) {
  std::vector<Lobe> lying;
  for (const double radius : radii) {
    const double away = (bowl.mouth - radius) * std::sqrt(random.uniform());
    const double angle = 2 * kPi * random.uniform();
    const Vec3d at =
        Landing(bowl, lying).rest(away * maths::cos(angle), away * maths::sin(angle), radius);
    if (at.y <= bowl.depth) lying.push_back({at, radius});
  }
  return lying;
}

}  // namespace vug::field
