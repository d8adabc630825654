// SPDX-License-Identifier: Apache-2.0
#include <vug/base/vec.h>
#include <vug/flora/node_displacement.h>

#include <algorithm>
#include <cmath>

namespace vug::flora {
namespace {

/// Shares of the groove's length over which it fades in above the ridge and fades out at its end.
constexpr double kFadeIn = 0.08, kFadeOut = 0.5;

}  // namespace

const char* NodeDisplacementOptions::fault() const {
  if (!(scar >= 0 && ridge >= 0 && scar + ridge <= 1))
    return "rings must be 0 to 100% of the radius high";
  if (!(scar_width > 0 && ridge_width > 0 && ridge_above >= 0))
    return "rings must have a width above 0";
  if (!(groove >= 0 && groove <= 0.3)) return "a groove must be at most 30% of the radius deep";
  if (!(groove_width > 0 && groove_width <= kPi))
    return "a groove must be at most 180 degrees wide";
  if (!(groove_length > 0 && groove_length <= 1))
    return "a groove must be at most an internode long";
  return "";
}

NodeDisplacement::NodeDisplacement(const NodeDisplacementOptions& displacement,
                                   std::vector<DisplacedNode> nodes)
    : displacement_(displacement), nodes_(std::move(nodes)) {
  for (const DisplacedNode& node : nodes_) {
    const double r = node.radius;
    highest_ = std::max(highest_, (displacement.scar + displacement.ridge) * r);
    // Heights and widths are both relative to the radius, so the slope does not depend on the size.
    slope_ = std::max(slope_, kBumpSlope * (displacement.scar / displacement.scar_width +
                                            displacement.ridge / displacement.ridge_width));
    const double length = displacement.groove_length * (node.next - node.along);
    if (node.angles.empty() || displacement.groove <= 0 || length <= 0) continue;
    deepest_ = std::max(deepest_, displacement.groove * r);
    slope_ = std::max(slope_, 1.5 * displacement.groove * r / (kFadeIn * length));
    max_angular_slope_ = std::max(max_angular_slope_,
                                  kBumpSlope * displacement.groove * r / displacement.groove_width);
  }
}

DisplacementSample NodeDisplacement::ring_of(const DisplacedNode& node, double along) const {
  const double x = (along - node.along) / node.radius;
  const double scar = x / displacement_.scar_width;
  const double ridge = (x - displacement_.ridge_above) / displacement_.ridge_width;
  return {node.radius * (displacement_.scar * bump(scar) + displacement_.ridge * bump(ridge)),
          displacement_.scar / displacement_.scar_width * bump_slope(scar) +
              displacement_.ridge / displacement_.ridge_width * bump_slope(ridge)};
}

DisplacementSample NodeDisplacement::rings(double along) const {
  // Overlapping rings of neighbouring nodes are combined by their maximum.
  DisplacementSample most;
  const double reach =
      std::max(displacement_.scar_width, displacement_.ridge_above + displacement_.ridge_width);
  const auto take = [&](const DisplacedNode& node) {
    if (!(node.radius > 0)) return;
    const DisplacementSample ring = ring_of(node, along);
    if (ring.height > most.height) most = ring;
  };
  const auto above =
      std::lower_bound(nodes_.begin(), nodes_.end(), along,
                       [](const DisplacedNode& node, double s) { return node.along < s; });
  for (auto node = above; node != nodes_.end(); ++node) {
    if (node->along - along > reach * node->radius) break;
    take(*node);
  }
  for (auto node = above; node != nodes_.begin();) {
    --node;
    if (along - node->along > reach * node->radius) break;
    take(*node);
  }
  return most;
}

DisplacementSample NodeDisplacement::groove_shape(const DisplacedNode& node, double along) const {
  const double length = displacement_.groove_length * (node.next - node.along);
  const double x = length > 0 ? (along - node.along) / length : -1;
  if (x <= 0 || x >= 1) return {};
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  const auto slope = [](double t) { return 6 * t * (1 - t); };
  const double in = std::min(1.0, x / kFadeIn), out = std::min(1.0, (1 - x) / kFadeOut);
  return {smooth(in) * smooth(out),
          (slope(in) * smooth(out) / kFadeIn - smooth(in) * slope(out) / kFadeOut) / length};
}

const DisplacedNode* NodeDisplacement::below(double along) const {
  const auto above =
      std::upper_bound(nodes_.begin(), nodes_.end(), along,
                       [](double s, const DisplacedNode& node) { return s < node.along; });
  return above == nodes_.begin() ? nullptr : &*(above - 1);
}

DisplacementSample NodeDisplacement::beds(double along, double angle) const {
  const DisplacedNode* node = below(along);
  if (!node || deepest_ == 0) return {};
  double most = 0, turn = 0;
  for (const double bed : node->angles) {
    double off = angle - bed;
    off -= 2 * kPi * std::round(off / (2 * kPi));
    const double x = off / displacement_.groove_width, depth = bump(x);
    if (depth > most) most = depth, turn = bump_slope(x) / displacement_.groove_width;
  }
  if (!(most > 0)) return {};
  const DisplacementSample shape = groove_shape(*node, along);
  return {most * shape.height, most * shape.along, turn * shape.height};
}

DisplacementSample NodeDisplacement::grooves(double along, double angle) const {
  const DisplacementSample bed = beds(along, angle);
  if (!(bed.height > 0)) return {};
  const double deep = displacement_.groove * below(along)->radius;
  return {bed.height * deep, bed.along * deep, bed.around * deep};
}

std::vector<double> NodeDisplacement::rows() const {
  // Relative positions between crest and foot, denser where a bump is curved most.
  constexpr double kPlaces[] = {-1, -0.8, -0.577, -0.35, -0.15, 0, 0.15, 0.35, 0.577, 0.8, 1};
  std::vector<double> rows;
  for (const DisplacedNode& node : nodes_) {
    for (const double x : kPlaces) {
      if (displacement_.scar > 0)
        rows.push_back(node.along + x * displacement_.scar_width * node.radius);
      if (displacement_.ridge > 0)
        rows.push_back(node.along +
                       (displacement_.ridge_above + x * displacement_.ridge_width) * node.radius);
    }
    if (node.angles.empty() || deepest_ == 0) continue;
    const double length = displacement_.groove_length * (node.next - node.along);
    for (const double x : {0., 0.25, 0.5, 0.75, 1.}) {
      rows.push_back(node.along + x * kFadeIn * length);
      rows.push_back(node.along + (1 - x * kFadeOut) * length);
    }
  }
  return rows;
}

}  // namespace vug::flora
