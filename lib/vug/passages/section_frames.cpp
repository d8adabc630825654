// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/passages/curves/frames.h>
#include <vug/passages/curves/star_outline.h>
#include <vug/passages/section_frames.h>

#include <cmath>
#include <utility>

namespace vug::passages {
namespace {

bool applies(const SectionRule& rule, const CurvePoint& point, const Vec3d& tangent) {
  const double ratio = point.width / point.height;
  if (!rule.family || (rule.stage && *rule.stage != point.stage)) return false;
  if (!(point.width >= rule.min_width && point.width <= rule.max_width)) return false;
  if (!(ratio >= rule.min_ratio && ratio <= rule.max_ratio)) return false;
  if (std::fabs(tangent.y) > maths::sin(rule.max_dip)) return false;
  if (!rule.bed) return true;
  const Vec3d offset = point.position - rule.bed->point;
  return std::fabs(offset.dot(rule.bed->normal.normalized())) <= 0.5 * rule.bed->thickness;
}

const SectionFamily& family_at(const PassageOptions& options, const CurvePoint& point,
                               const Vec3d& tangent) {
  for (const SectionRule& rule : options.rules)
    if (applies(rule, point, tangent)) return *rule.family;
  return *options.section;
}

/// Positive where the curve turns left, seen from above.
double signed_curvature(const Curve& curve, size_t i, double curvature) {
  if (i == 0 || i + 1 == curve.size()) return 0;
  const Vec3d before = curve[i].position - curve[i - 1].position;
  const Vec3d after = curve[i + 1].position - curve[i].position;
  return before.cross(after).y > 0 ? curvature : -curvature;
}

/// Sections between two stations, of which splays measured at least one, change from one to the
/// other.
void blend_measured(const Curve& curve, std::vector<SectionFrame>& frames) {
  const std::vector<double> along = arc_lengths(curve);
  size_t from = curve.size();
  StarOutline start;
  for (size_t i = 0; i < curve.size(); ++i) {
    if (curve[i].station < 0) continue;
    const bool blends =
        from + 1 < i && (curve[from].measured != nullptr || curve[i].measured != nullptr);
    if (blends && start.empty()) start = star_outline(*frames[from].section);
    StarOutline end;
    if (blends) end = star_outline(*frames[i].section);
    for (size_t k = from + 1; blends && k < i; ++k) {
      const double t = (along[k] - along[from]) / (along[i] - along[from]);
      frames[k].section = blended_section(start, end, t * t * (3 - 2 * t));
    }
    start = std::move(end);
    from = i;
  }
}

}  // namespace

std::vector<SectionFrame> section_frames(const Curve& curve, const PassageOptions& options) {
  const std::vector<Vec3d> directions = tangents(curve);
  std::vector<Vec3d> points;
  for (const CurvePoint& p : curve) points.push_back(p.position);
  const std::vector<Frame> across = frames(points, directions);
  const std::vector<double> bends = curvatures(curve);
  std::vector<SectionFrame> out;
  const SectionFamily* family = nullptr;
  SectionPlace place;
  SectionPtr section;
  for (size_t i = 0; i < curve.size(); ++i) {
    const CurvePoint& p = curve[i];
    if (p.measured) {
      section = p.measured;
      family = nullptr;
    } else {
      const SectionFamily& next = family_at(options, p, directions[i]);
      const double bend = next.migrates() ? signed_curvature(curve, i, bends[i]) : 0;
      const SectionPlace here{p.width, p.height, bend};
      const bool same = family == &next && here.width == place.width &&
                        here.height == place.height && here.curvature == place.curvature;
      if (!same) section = next.fit(here);
      family = &next;
      place = here;
    }
    out.push_back({p.position, across[i].right, across[i].up, section});
  }
  blend_measured(curve, out);
  return out;
}

}  // namespace vug::passages
