// SPDX-License-Identifier: Apache-2.0
// The symbols over the picture of a scene: handles of the statement at the caret, lights and
// cameras. Windows only draw them.
#pragma once

#include <vug/language/literal_handles.h>
#include <vug/viewport/gizmo.h>
#include <vug/viewport/screen_view.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace vug::workbench {

/// Positions are pixels of the viewport, from its top left corner.
struct OverlayHandle {
  std::string name;
  language::HandleRole role = language::HandleRole::point;
  Vec2d at{0, 0};                            ///< Where it is dragged.
  std::optional<Vec2d> anchor;               ///< The beginning of the arrow or of the length.
  std::array<std::optional<Vec2d>, 3> axes;  ///< Ends of the axes of a point.
};

struct OverlayGizmo {
  std::string kind, name;
  Vec2d at{0, 0};
  std::optional<Vec2d> tip;  ///< The end of its direction.
  SourceLocation where;
  bool selected = false;  ///< The caret is in its declaration.
};

struct SceneOverlay {
  std::string title;  ///< The statement of the handles, as "light lamp".
  std::vector<OverlayHandle> handles;
  std::vector<OverlayGizmo> gizmos;
};

SceneOverlay overlay_of(const language::StatementHandles& handles,
                        const std::vector<viewport::Gizmo>& gizmos,
                        const viewport::ScreenView& view);

/// The part of a handle within a distance of a pixel: the grip, or the end of an axis.
struct OverlayHit {
  std::string name;
  std::optional<int> axis;
};
std::optional<OverlayHit> handle_at(const SceneOverlay& overlay, const Vec2d& pixel,
                                    double distance);
/// The nearest gizmo within a distance of a pixel; null if there is none.
const OverlayGizmo* gizmo_at(const SceneOverlay& overlay, const Vec2d& pixel, double distance);

}  // namespace vug::workbench
