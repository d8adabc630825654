// SPDX-License-Identifier: Apache-2.0
#include <vug/field/opaque.h>
#include <vug/passages/lines/centreline.h>
#include <vug/passages/lines/line_bvh.h>

namespace vug::passages {
namespace {

struct Tubes {
  std::shared_ptr<const LineBvh> lines;
  double radius;

  field::Gradient sample(const Vec3d& p) const {
    const LineBvh::Nearest nearest = lines->nearest(p);
    const Vec3d away = p - nearest.point;
    return {nearest.distance - radius, nearest.distance > 0 ? away / nearest.distance : Vec3d(0.0)};
  }
  double value(const Vec3d& p) const { return lines->nearest(p).distance - radius; }
};

}  // namespace

field::Field centreline(std::vector<AxisLine> lines, double radius) {
  const auto bvh = std::make_shared<const LineBvh>(std::move(lines));
  field::Traits traits;
  traits.exactness = radius > 0 ? field::Exactness::eikonal : field::Exactness::exact;
  traits.bounds = grown(bvh->bounds(), radius);
  traits.growth = 1;
  return field::Field(
      std::make_shared<field::OpaqueNode<Tubes>>("centreline", traits, Tubes{bvh, radius}));
}

}  // namespace vug::passages
