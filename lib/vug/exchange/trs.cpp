// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/trs.h>

#include <algorithm>
#include <cmath>

namespace vug::exchange {
namespace {

/// The quaternion of a rotation's columns: the largest of the four components is computed first and
/// divides the others (Shepperd 1978, "Quaternion from rotation matrix", cite shepperd1978).
std::array<double, 4> quaternion(const Vec3d& x, const Vec3d& y, const Vec3d& z) {
  const double squares[4] = {1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z,
                             1 + x.x + y.y + z.z};
  const auto largest = std::max_element(std::begin(squares), std::end(squares));
  const double root = std::sqrt(*largest), by = 0.5 / root;
  switch (largest - std::begin(squares)) {
    case 0:
      return {0.5 * root, (x.y + y.x) * by, (x.z + z.x) * by, (y.z - z.y) * by};
    case 1:
      return {(x.y + y.x) * by, 0.5 * root, (y.z + z.y) * by, (z.x - x.z) * by};
    case 2:
      return {(x.z + z.x) * by, (y.z + z.y) * by, 0.5 * root, (x.y - y.x) * by};
    default:
      return {(y.z - z.y) * by, (z.x - x.z) * by, (x.y - y.x) * by, 0.5 * root};
  }
}

}  // namespace

std::optional<TrsTransform> decompose_trs(const Transform& map) {
  constexpr double kRightAngle = 1e-6;
  Vec3d axes[3] = {map.column(0), map.column(1), map.column(2)};
  TrsTransform out;
  out.translation = map.origin();
  for (int i = 0; i < 3; ++i) {
    out.scale[i] = axes[i].length();
    axes[i] /= out.scale[i];
  }
  for (int i = 0; i < 3; ++i)
    if (std::fabs(axes[i].dot(axes[(i + 1) % 3])) > kRightAngle) return std::nullopt;
  if (map.determinant() < 0) {
    out.scale.x = -out.scale.x;
    axes[0] = -axes[0];
  }
  out.rotation = quaternion(axes[0], axes[1], axes[2]);
  double squared = 0;
  for (const double part : out.rotation) squared += part * part;
  for (double& part : out.rotation) part /= std::sqrt(squared);
  return out;
}

bool is_identity(const Transform& map) {
  return map.column(0) == Vec3d(1, 0, 0) && map.column(1) == Vec3d(0, 1, 0) &&
         map.column(2) == Vec3d(0, 0, 1) && map.origin() == Vec3d(0, 0, 0);
}

std::array<double, 16> matrix(const Transform& map) {
  const Vec3d &x = map.column(0), &y = map.column(1), &z = map.column(2), &o = map.origin();
  return {x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, o.x, o.y, o.z, 1};
}

}  // namespace vug::exchange
