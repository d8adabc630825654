// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/handle_drag.h>
#include <vug/workbench/scene_overlay.h>

namespace vug::workbench {
namespace {

using language::HandleRole;
using language::LiteralHandle;
using viewport::ScreenView;

/// Gizmos are shown within this distance of the picture, in pixels.
constexpr double kMargin = 40;

std::optional<OverlayHandle> shown_handle(const LiteralHandle& handle, const ScreenView& view) {
  const std::optional<Vec2d> at = view.project(grip_point(handle, view));
  if (!at) return std::nullopt;
  OverlayHandle out{handle.name, handle.role, *at, std::nullopt, {}};
  if (handle.role != HandleRole::point) {
    out.anchor = view.project(handle.place.point(handle.anchor));
    return out;
  }
  const Vec3d position = handle.position();
  const double length = kHandlePixels * view.pixel_size(position);
  for (int i = 0; i < 3; ++i) {
    const Vec3d axis = handle.place.column(i).normalized();
    out.axes[static_cast<size_t>(i)] = view.project(position + axis * length);
  }
  return out;
}

bool is_near(const Vec2d& pixel, const ScreenView& view) {
  return pixel.x > -kMargin && pixel.y > -kMargin && pixel.x < view.width + kMargin &&
         pixel.y < view.height + kMargin;
}

}  // namespace

SceneOverlay overlay_of(const language::StatementHandles& handles,
                        const std::vector<viewport::Gizmo>& gizmos, const ScreenView& view) {
  SceneOverlay out;
  out.title = handles.title;
  for (const LiteralHandle& each : handles.handles)
    if (auto shown = shown_handle(each, view)) out.handles.push_back(std::move(*shown));
  for (const viewport::Gizmo& each : gizmos) {
    const std::optional<Vec2d> at = view.project(each.position);
    const double size = view.pixel_size(each.position);
    if (!at || !is_near(*at, view) || !(size > 0)) continue;
    OverlayGizmo gizmo{each.kind, each.name, *at, std::nullopt, each.where, false};
    if (each.direction)
      gizmo.tip = view.project(each.position + *each.direction * (kHandlePixels * size));
    gizmo.selected = each.where.known() && handles.extent.contains(each.where);
    out.gizmos.push_back(std::move(gizmo));
  }
  return out;
}

std::optional<OverlayHit> handle_at(const SceneOverlay& overlay, const Vec2d& pixel,
                                    double distance) {
  std::optional<OverlayHit> found;
  double nearest = distance;
  const auto test = [&](const std::optional<Vec2d>& at, const OverlayHit& hit) {
    if (!at || (*at - pixel).length() > nearest) return;
    nearest = (*at - pixel).length();
    found = hit;
  };
  for (const OverlayHandle& each : overlay.handles) {
    for (int i = 0; i < 3; ++i) test(each.axes[static_cast<size_t>(i)], {each.name, i});
    test(each.at, {each.name, std::nullopt});
  }
  return found;
}

const OverlayGizmo* gizmo_at(const SceneOverlay& overlay, const Vec2d& pixel, double distance) {
  const OverlayGizmo* found = nullptr;
  for (const OverlayGizmo& each : overlay.gizmos)
    if (const double away = (each.at - pixel).length(); away <= distance) {
      distance = away;
      found = &each;
    }
  return found;
}

}  // namespace vug::workbench
