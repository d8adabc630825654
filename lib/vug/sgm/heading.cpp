// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/sgm/heading.h>

#include <cmath>

namespace vug::sgm {
namespace {

/// The horizontal unit vector nearest to `flat` among the joints and their opposites.
Vec3d nearest_joint(const Vec3d& flat, const std::vector<double>& azimuths) {
  Vec3d best = flat;
  double alignment = -1;
  for (const double azimuth : azimuths) {
    const Vec3d joint(maths::sin(azimuth), 0, -maths::cos(azimuth));
    const double cosine = joint.dot(flat);
    if (std::fabs(cosine) <= alignment) continue;
    alignment = std::fabs(cosine);
    best = joint * (cosine < 0 ? -1.0 : 1.0);
  }
  return best;
}

}  // namespace

Vec3d Heading::turned(const Vec3d& direction) const {
  const double run = Vec3d(direction.x, 0, direction.z).length();
  if ((!slope && azimuths.empty()) || run < 1e-9) return direction;
  const Vec3d flat = nearest_joint(Vec3d(direction.x, 0, direction.z) / run, azimuths);
  if (!slope) return flat * run + Vec3d(0, direction.y, 0);
  return flat * maths::cos(*slope) + Vec3d(0, maths::sin(*slope), 0);
}

}  // namespace vug::sgm
