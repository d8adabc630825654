// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/drips/planes.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::drips {

Planes::Planes(karst::Geology geology, uint64_t seed) : geology_(std::move(geology)) {
  joints_ = karst::Rock(geology_, seed).joints();
}

std::optional<NearPlane> Planes::nearest(const Vec3d& p) const {
  std::optional<NearPlane> best;
  const auto offer = [&](const NearPlane& plane) {
    if (!best || std::fabs(plane.distance) < std::fabs(best->distance)) best = plane;
  };
  for (size_t i = 0; i < joints_.size(); ++i) {
    const double along = p.dot(joints_[i].normal());
    const int64_t middle = joints_[i].nearest(p);
    for (int64_t n = middle - 1; n <= middle + 1; ++n)
      offer({NearPlane::Kind::joint, i, n, joints_[i].normal(), along - joints_[i].offset(n)});
  }
  for (size_t i = 0; i < geology_.faults.size(); ++i) {
    const karst::Fault& fault = geology_.faults[i];
    const Vec3d normal = karst::plane_normal(fault.azimuth, fault.dip);
    offer({NearPlane::Kind::fault, i, 0, normal, (p - fault.point).dot(normal)});
  }
  for (size_t i = 0; i < geology_.beds.size(); ++i) {
    const karst::Layer& bed = geology_.beds[i];
    const Vec3d normal = karst::strike_vector(bed.dip_azimuth) * maths::sin(bed.dip) +
                         Vec3d(0, maths::cos(bed.dip), 0);
    offer({NearPlane::Kind::bed, i, 0, normal, (p - bed.point).dot(normal)});
  }
  return best;
}

std::string Planes::name(const NearPlane& plane) const {
  if (plane.kind == NearPlane::Kind::fault) return fmt::format("fault {}", plane.family + 1);
  if (plane.kind == NearPlane::Kind::bed) return fmt::format("bed {}", plane.family + 1);
  return joints_.size() < 2 ? fmt::format("joint {}", plane.number)
                            : fmt::format("joint {} of family {}", plane.number, plane.family + 1);
}

}  // namespace vug::drips
