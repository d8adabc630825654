// SPDX-License-Identifier: Apache-2.0
#include <vug/field/opaque.h>
#include <vug/field/value_below.h>
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

class CentrelineNode final : public field::OpaqueNode<Tubes>, public field::ValueBelow {
 public:
  CentrelineNode(const field::Traits& traits, Tubes tubes)
      : OpaqueNode("centreline", traits, std::move(tubes)) {}
  double value_below(const field::Point<double>& p, double limit) const override {
    const double radius = source().radius;
    const double reach = (limit + radius) * (1 + 1e-12);  // Rounding does not matter beyond it.
    const double distance = source().lines->nearest(vector(p), reach).distance;
    return distance < reach ? distance - radius : limit;
  }
};

}  // namespace

field::Field centreline(std::vector<AxisLine> lines, double radius) {
  const auto bvh = std::make_shared<const LineBvh>(std::move(lines));
  field::Traits traits;
  traits.exactness = radius > 0 ? field::Exactness::eikonal : field::Exactness::exact;
  traits.bounds = grown(bvh->bounds(), radius);
  traits.growth = 1;
  return field::Field(std::make_shared<CentrelineNode>(traits, Tubes{bvh, radius}));
}

}  // namespace vug::passages
