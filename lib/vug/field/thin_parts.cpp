// SPDX-License-Identifier: Apache-2.0
#include <vug/field/placement.h>
#include <vug/field/thickness.h>
#include <vug/field/thin_parts.h>

#include <algorithm>
#include <set>

namespace vug::field {
namespace {

/// A point of a solid with its value.
struct Depth {
  Vec3d at{0, 0, 0};
  double value = kInfinity;
};

constexpr int kSteps = 7, kSamples = 1 + kSteps * kSteps * kSteps;

/// The centre of the box, then the centres of its parts.
Vec3d sample_of(const Box3d& box, int n) {
  const int i = n == 0 ? (kSamples - 1) / 2 : n - 1;
  const int slice = i / (kSteps * kSteps), row = i / kSteps % kSteps;
  const Vec3d share = Vec3d(slice, row, i % kSteps) + Vec3d(0.5);
  return box.min + box.size() * share * (1.0 / kSteps);
}

/// Follows the gradient inwards, with steps that halve when they do not lead deeper.
Depth descended(const Field& part, Depth from, double step) {
  for (int i = 0; i < 40; ++i) {
    const Gradient here = part.gradient(from.at);
    const double slope = here.gradient.length();
    if (!(slope > 0)) break;
    const Vec3d next = from.at - here.gradient * (step / slope);
    const double value = part.value(next);
    if (value < from.value)
      from = {next, value};
    else
      step *= 0.5;
  }
  return from;
}

/// The deepest point of a part that samples of its box find, or one that is deeper than `enough`.
Depth deepest(const Field& part, double enough) {
  Depth best;
  for (int n = 0; n < kSamples && best.value > -enough; ++n) {
    const Vec3d at = sample_of(part.bounds(), n);
    if (const double value = part.value(at); value < best.value) best = {at, value};
  }
  if (best.value <= -enough) return best;
  return descended(part, best, std::max(best.value, enough));
}

/// Whether the values inside are distances, if those of its operand are. A shell promises less, for
/// points outside.
bool has_depths(const NodePtr& node) {
  const Field part(node->name() == "shell" ? node->children().front() : node);
  return part.exactness() <= Exactness::eikonal;
}

class Search {
 public:
  Search(const Field& whole, double thickness) : whole_(whole), thickness_(thickness) {}

  void visit(const NodePtr& node, const Transform& outwards) {
    if (!seen_.insert(node).second) return;
    if (add_passages(node, outwards)) return;
    const std::string name = node->name();
    if (const std::optional<Transform> placement = placement_of(*node))
      return visit(node->children().front(), outwards * *placement);
    if (name == "union") {
      for (const NodePtr& child : node->children()) visit(child, outwards);
      return;
    }
    const std::vector<NodePtr> operands = node->children();
    if (name == "difference" && operands.size() > 1) {
      for (size_t i = 1; i < operands.size(); ++i) find_passages(operands[i], outwards);
      return visit(operands.front(), outwards);
    }
    judge(node, outwards);
    for (const NodePtr& each : operands) find_passages(each, outwards);
  }

  std::vector<ThinPart> found;

 private:
  /// Adds the passages below a node.
  void find_passages(const NodePtr& node, const Transform& outwards) {
    if (!seen_.insert(node).second || add_passages(node, outwards)) return;
    const std::optional<Transform> placement = placement_of(*node);
    for (const NodePtr& child : node->children())
      find_passages(child, placement ? outwards * *placement : outwards);
  }
  /// Returns whether the node is a passage.
  bool add_passages(const NodePtr& node, const Transform& outwards) {
    const auto* passage = dynamic_cast<const VariesInThickness*>(node.get());
    if (!passage) return false;
    const double scale = outwards.min_stretch();
    if (const auto thin = passage->thinner_than(thickness_ / scale))
      found.push_back({node, outwards.point(thin->at), thin->thickness * scale, thin->share});
    return true;
  }

  void judge(const NodePtr& node, const Transform& outwards) {
    const Field part(node);
    if (!has_depths(node) || !is_finite(part.bounds()) || part.bounds().isEmpty()) return;
    const double scale = outwards.min_stretch(), enough = 0.5 * thickness_ / scale;
    const Depth depth = deepest(part, enough);
    if (depth.value >= 0 || depth.value <= -enough) return;
    if (const std::optional<Vec3d> at = exposed(part, depth, outwards))
      found.push_back({node, *at, -2 * depth.value * scale});
  }

  /// A point of the part where the whole solid is as thin; nothing inside larger parts.
  std::optional<Vec3d> exposed(const Field& part, const Depth& depth,
                               const Transform& outwards) const {
    for (int n = -1; n < kSamples; ++n) {
      const Vec3d local = n < 0 ? depth.at : sample_of(part.bounds(), n);
      if (n >= 0 && part.value(local) >= 0) continue;
      const Vec3d at = outwards.point(local);
      const double value = whole_.value(at);
      if (value <= 0 && value > -0.5 * thickness_) return at;
    }
    return std::nullopt;
  }

  const Field& whole_;
  double thickness_;
  std::set<NodePtr> seen_;
};

}  // namespace

std::vector<ThinPart> thin_parts(const Field& field, double thickness) {
  Search search(field, thickness);
  search.visit(field.node(), Transform());
  return std::move(search.found);
}

}  // namespace vug::field
