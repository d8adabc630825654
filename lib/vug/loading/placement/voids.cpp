// SPDX-License-Identifier: Apache-2.0
// Voids: the operands that differences remove.
#include <vug/field/affine.h>
#include <vug/field/operands.h>
#include <vug/field/placement.h>
#include <vug/loading/placement/checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <unordered_set>

namespace vug::loading {
namespace {

/// Points along each axis of a void's box: first few, then many before it is reported.
constexpr int kFew = 5, kMany = 16;

/// A node below the field of a volume, with the map to the volume's space.
struct PlacedNode {
  field::NodePtr node;
  Transform to_volume;

  field::Field in_volume() const { return field::transformed(field::Field(node), to_volume); }
};

/// Whether a rule of a grammar made the node: its productions may fill each other's voids.
bool is_of_rule(const scene::Provenance& made) {
  for (const scene::Frame* frame = made.frame.get(); frame; frame = frame->outer.get())
    if (frame->what.compare(0, 4, "rule") == 0) return true;
  return false;
}

/// The voids below a node that the text names. Of a node that is placed several times, only the
/// first place counts.
std::vector<PlacedNode> find_voids(const field::NodePtr& top, const Loaded& scene) {
  std::vector<PlacedNode> voids;
  std::unordered_set<const field::Node*> seen;
  std::vector<PlacedNode> pending = {{top, {}}};
  while (!pending.empty()) {
    const PlacedNode here = std::move(pending.back());
    pending.pop_back();
    const field::Node& node = *here.node;
    if (!seen.insert(&node).second) continue;
    if (const std::optional<Transform> placement = field::placement_of(node))
      pending.push_back({node.children().front(), here.to_volume * *placement});
    if (field::NodePtr child = field::undisplaced(node))
      pending.push_back({std::move(child), here.to_volume});
    field::Operands operands = field::operands_of(node);
    for (field::NodePtr& kept : operands.kept) pending.push_back({std::move(kept), here.to_volume});
    const scene::Provenance* made = scene.provenance.find(here.node);
    if (!made || is_of_rule(*made)) continue;
    for (field::NodePtr& removed : operands.removed)
      voids.push_back({std::move(removed), here.to_volume});
  }
  return voids;
}

enum class Content { unknown, air, rock };

/// Looks for air in the part of a void inside the box, at points of a lattice.
Content content_of(const field::Field& removed, const field::Field& whole, const Box3d& box,
                   int count, double slack, Accuracy accuracy) {
  Content content = Content::unknown;
  const Vec3d size = box.size();
  for (int i = 0; i < count * count * count; ++i) {
    const int row = i / count % count, slice = i / count / count;
    const Vec3d share((i % count + 0.5) / count, (row + 0.5) / count, (slice + 0.5) / count);
    const Vec3d p = box.min + size * share;
    if (!(field::bounds_at(removed, p).hi < -slack)) continue;
    const double rock =
        accuracy == Accuracy::exact ? whole.value(p) : field::bounds_at(whole, p).hi;
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
    for (const PlacedNode& one : find_voids(volume->field.node(), scene)) {
      const field::Field removed = one.in_volume();
      const Box3d box = intersection(region, removed.bounds());
      if (!is_finite(box)) continue;
      const auto filled = [&](int count) {
        return content_of(removed, volume->field, box, count, 0.5 * volume->voxel, accuracy) ==
               Content::rock;
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
