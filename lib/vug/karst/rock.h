// SPDX-License-Identifier: Apache-2.0
// Questions about a point of the geology.
#pragma once

#include <vug/karst/joints.h>

#include <algorithm>

namespace vug::karst {

/// 1 at 0, 0 from `reach` on, smooth between: (1 - (d / reach)^2)^3.
inline double smooth_falloff(double distance, double reach) {
  const double t = 1 - (distance / reach) * (distance / reach);
  return t > 0 ? t * t * t : 0;
}

class Rock {
 public:
  /// The geology must outlive the object.
  Rock(const Geology& geology, uint64_t seed);

  const Geology& geology() const { return geology_; }
  const std::vector<Joints>& joints() const { return joints_; }

  /// Whether a point is in the bounds and in the solid.
  bool contains(const Vec3d& point) const;
  /// The vertical distance to the nearest inception horizon, times the cosine of its dip; infinite
  /// without horizons.
  double bed_distance(const Vec3d& point) const;
  /// -1 to 1: how easily water flows through the rock compared with rock without features.
  double permeability(const Vec3d& point) const;
  bool has_permeability() const;
  bool in_ghost_rock(const Vec3d& point) const;
  /// 0 to 1: how well a leg through `middle` in a unit `direction` follows a joint.
  double joint_alignment(const Vec3d& middle, const Vec3d& direction) const;
  /// The same for faults.
  double fault_alignment(const Vec3d& middle, const Vec3d& direction) const;
  /// The height of the water table of a tier above or below a point; without tables the middle of
  /// the bounds.
  double table_height(int tier, const Vec3d& point) const;
  int tiers() const { return std::max(1, static_cast<int>(geology_.water_tables.size())); }

 private:
  const Geology& geology_;
  std::vector<Joints> joints_;
  std::vector<Vec3d> fault_normals_;
  std::vector<double> bed_cosines_;
};

}  // namespace vug::karst
