// SPDX-License-Identifier: Apache-2.0
// The planes along which water comes through the rock: joints, faults and beds of a geology.
#pragma once

#include <vug/karst/rock.h>

#include <optional>
#include <string>

namespace vug::drips {

/// The plane nearest to a point.
struct NearPlane {
  enum class Kind { joint, fault, bed } kind = Kind::joint;
  size_t family = 0;   ///< Index in the geology.
  int64_t number = 0;  ///< The number of a joint in its family.
  Vec3d normal{0.0};
  double distance = 0;  ///< Signed distance of the point along the normal, in metres.

  bool same_as(const NearPlane& other) const {
    return kind == other.kind && family == other.family && number == other.number;
  }
};

class Planes {
 public:
  /// The joints are those that the network kind `karst` has for the same geology and seed. The
  /// geology must be valid, see karst::require_valid.
  Planes(karst::Geology geology, uint64_t seed);

  /// Nothing for a geology without planes.
  std::optional<NearPlane> nearest(const Vec3d& point) const;
  /// E.g. "joint 3", or "joint 3 of family 2" if there are several families.
  std::string name(const NearPlane& plane) const;
  void add_to(Digester& digester) const { digester(geology_, joints_); }

 private:
  karst::Geology geology_;
  std::vector<karst::Joints> joints_;
};

}  // namespace vug::drips
