// SPDX-License-Identifier: Apache-2.0
#include <vug/base/pluralize.h>
#include <vug/building/thin_part_warnings.h>
#include <vug/field/thin_parts.h>

#include <fmt/format.h>

namespace vug::building {
namespace {

/// The thin parts that one text made.
struct ThinParts {
  SourceLocation where;
  field::ThinPart thinnest;
  size_t count = 0;
};

bool is_same(const SourceLocation& a, const SourceLocation& b) {
  return a.file == b.file && a.line == b.line && a.column == b.column;
}

std::string message_of(const ThinParts& parts, const shot::VolumePlan& plan) {
  const field::ThinPart& part = parts.thinnest;
  if (part.share)
    return fmt::format(
        "{:.0f} % of the length of the {} in the volume '{}' is thinner than its voxels of {} m, "
        "so "
        "they may fall to pieces; the least is {:.3g} m at ({:.6g}, {:.6g}, {:.6g})",
        std::max(1.0, 100 * *part.share), part.node->name(), plan.name, plan.voxel, part.thickness,
        part.at.x, part.at.y, part.at.z);
  std::string others = parts.count > 1 ? ", and " + pluralize(parts.count - 1, "other") : "";
  return fmt::format(
      "the {} in the volume '{}' is {:.3g} m thick at ({:.6g}, {:.6g}, {:.6g}){}: the level set "
      "may not contain parts thinner than its voxels of {} m",
      part.node->name(), plan.name, part.thickness, part.at.x, part.at.y, part.at.z, others,
      plan.voxel);
}

/// Karst passages have narrow places as real caves do, for which no voxel is small enough.
std::string hint_of(const field::ThinPart& part) {
  if (part.share)
    return "use smaller voxels or larger passages: 'least_width', 'least_height' and 'size' of "
           "'karst' and 'with_sections'";
  return fmt::format("use voxels of at most {:.2g} m, or a thicker solid", 0.5 * part.thickness);
}

}  // namespace

Diagnostics thin_part_warnings(
    const shot::VolumePlan& plan,
    const std::function<SourceLocation(const field::NodePtr&)>& where_of) {
  std::vector<ThinParts> groups;
  for (const field::ThinPart& part : field::thin_parts(plan.field, plan.voxel)) {
    if (plan.from && !Box3d(*plan.from, *plan.to).intersects(part.at)) continue;
    SourceLocation where = where_of ? where_of(part.node) : SourceLocation();
    if (!where.known()) where = plan.where;
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const ThinParts& each) { return is_same(each.where, where); });
    if (group == groups.end()) group = groups.insert(group, {where, part, 0});
    ++group->count;
    if (part.thickness < group->thinnest.thickness) group->thinnest = part;
  }
  constexpr size_t kMost = 5;
  Diagnostics warnings;
  for (size_t i = 0; i < std::min(kMost, groups.size()); ++i)
    warnings.warning(groups[i].where, message_of(groups[i], plan), hint_of(groups[i].thinnest));
  return warnings;
}

}  // namespace vug::building
