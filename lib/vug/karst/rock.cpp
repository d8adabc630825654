// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/karst/rock.h>

#include <cmath>

namespace vug::karst {

Rock::Rock(const Geology& geology, uint64_t seed) : geology_(geology) {
  const RandomKey key = RandomKey(seed).at("joints");
  for (size_t i = 0; i < geology.fractures.size(); ++i)
    joints_.emplace_back(geology.fractures[i], key.at(i));
  for (const Fault& fault : geology.faults)
    fault_normals_.push_back(plane_normal(fault.azimuth, fault.dip));
  for (const Layer& bed : geology.beds) bed_cosines_.push_back(maths::cos(bed.dip));
}

bool Rock::contains(const Vec3d& point) const {
  return geology_.bounds.intersects(point) &&
         (!geology_.solid || geology_.solid->value(point) <= 0);
}

double Rock::bed_distance(const Vec3d& point) const {
  double least = kInfinity;
  for (size_t i = 0; i < geology_.beds.size(); ++i)
    least = std::min(
        least, std::abs(point.y - geology_.beds[i].height_at(point.x, point.z)) * bed_cosines_[i]);
  return least;
}

bool Rock::has_permeability() const { return !geology_.permeable.empty(); }

double Rock::permeability(const Vec3d& point) const {
  double sum = 0;
  for (const PermeableBall& ball : geology_.permeable)
    sum += ball.strength * smooth_falloff((point - ball.center).length(), ball.radius);
  return std::clamp(sum, -1.0, 1.0);
}

bool Rock::in_ghost_rock(const Vec3d& point) const {
  return std::any_of(geology_.ghost_rock.begin(), geology_.ghost_rock.end(),
                     [&](const field::Field& body) { return body.value(point) <= 0; });
}

double Rock::joint_alignment(const Vec3d& middle, const Vec3d& direction) const {
  double best = 0;
  for (const Joints& joints : joints_) {
    const double across = direction.dot(joints.normal()) / joints.family().spread;
    const double aligned = maths::exp(-0.5 * across * across);
    if (aligned <= best) continue;
    const double near = smooth_falloff(joints.distance(middle), joints.family().spacing / 4);
    best = std::max(best, aligned * (0.5 + 0.5 * near));
  }
  return best;
}

double Rock::fault_alignment(const Vec3d& middle, const Vec3d& direction) const {
  double best = 0;
  for (size_t i = 0; i < fault_normals_.size(); ++i) {
    const Fault& fault = geology_.faults[i];
    const double distance = std::abs((middle - fault.point).dot(fault_normals_[i]));
    const double across = direction.dot(fault_normals_[i]);
    best = std::max(best, smooth_falloff(distance, fault.width) * (1 - across * across));
  }
  return best;
}

double Rock::table_height(int tier, const Vec3d& point) const {
  if (geology_.water_tables.empty()) return geology_.bounds.center().y;
  return geology_.water_tables[static_cast<size_t>(tier)].height_at(point.x, point.z);
}

}  // namespace vug::karst
