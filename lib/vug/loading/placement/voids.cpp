// SPDX-License-Identifier: Apache-2.0
// Voids: the operands that differences remove.
#include <vug/field/operands.h>
#include <vug/loading/placement/checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

namespace vug::loading {
namespace {

/// Points along each axis of a void's box: first few, then many before it is reported.
constexpr int kFew = 5, kMany = 16;

/// A void and the solid of which it is a part, in the same space.
struct Void {
  field::NodePtr node;
  field::Field whole;
};

/// Whether a rule of a grammar made the node: its productions may fill each other's voids.
bool is_of_rule(const scene::Provenance& made) {
  for (const scene::Frame* frame = made.frame.get(); frame; frame = frame->outer.get())
    if (frame->what.compare(0, 4, "rule") == 0) return true;
  return false;
}

/// The voids below a node that the text names.
void find_voids(const field::NodePtr& top, const field::Field& whole, const Loaded& scene,
                std::vector<Void>& voids) {
  std::unordered_set<const field::Node*> seen;
  std::vector<field::NodePtr> pending = {top};
  while (!pending.empty()) {
    const field::NodePtr node = std::move(pending.back());
    pending.pop_back();
    if (!seen.insert(node.get()).second) continue;
    if (field::NodePtr child = field::undisplaced(*node)) pending.push_back(std::move(child));
    field::Operands operands = field::operands_of(*node);
    if (operands.kept.empty()) continue;
    for (field::NodePtr& kept : operands.kept) pending.push_back(std::move(kept));
    const scene::Provenance* made = scene.provenance.find(node);
    if (!made || is_of_rule(*made)) continue;
    for (field::NodePtr& removed : operands.removed) voids.push_back({std::move(removed), whole});
  }
}

enum class Content { unknown, air, rock };

/// Looks for air in the void, at points of a lattice.
Content content_of(const Void& one, const Box3d& box, int count, double slack, Accuracy accuracy) {
  const field::Field removed(one.node);
  Content content = Content::unknown;
  const Vec3d size = box.size();
  for (int i = 0; i < count * count * count; ++i) {
    const int row = i / count % count, slice = i / count / count;
    const Vec3d share((i % count + 0.5) / count, (row + 0.5) / count, (slice + 0.5) / count);
    const Vec3d p = box.min + size * share;
    if (!(field::bounds_at(removed, p).hi < -slack)) continue;
    const double rock =
        accuracy == Accuracy::exact ? one.whole.value(p) : field::bounds_at(one.whole, p).hi;
    if (!(rock < -slack)) return Content::air;
    content = Content::rock;
  }
  return content;
}

}  // namespace

void check_voids(const Loaded& scene, const shot::Shot& part, Accuracy accuracy,
                 Diagnostics& diagnostics) {
  for (const shot::VolumePtr& volume : part.volumes) {
    if (volume->source_mesh || volume->fog) continue;
    Box3d region = volume->field.bounds();
    if (volume->from) region = intersection(region, Box3d(*volume->from, *volume->to));
    std::vector<Void> voids;
    find_voids(volume->field.node(), volume->field, scene, voids);
    for (const Void& one : voids) {
      const Box3d box = intersection(region, one.node->traits().bounds);
      if (!is_finite(box)) continue;
      const auto filled = [&](int count) {
        return content_of(one, box, count, 0.5 * volume->voxel, accuracy) == Content::rock;
      };
      const scene::Provenance* made = scene.provenance.find(one.node);
      if (!made || !filled(kFew) || !filled(kMany)) continue;
      diagnostics.error(
          made->where, fmt::format("this void is filled: '{}' has rock in all of it", volume->name),
          "another solid is united with the rock after the void has been removed: "
          "unite it first, and remove the void last");
    }
  }
}

}  // namespace vug::loading
