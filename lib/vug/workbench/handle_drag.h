// SPDX-License-Identifier: Apache-2.0
// Drags of the handles of a scene text: from pixels to numbers.
#pragma once

#include <vug/language/literal_handles.h>
#include <vug/viewport/screen_view.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::workbench {

/// The length of the arrows and axes of handles in a picture, in pixels.
constexpr double kHandlePixels = 60;

/// The end of the arrow of a direction.
Vec3d arrow_tip(const language::LiteralHandle& handle, const viewport::ScreenView& view);
/// The point of a handle that is dragged: the position, or the end of the arrow.
Vec3d grip_point(const language::LiteralHandle& handle, const viewport::ScreenView& view);

/// The numbers of a handle after a drag by an offset in pixels. A point stays in the plane across
/// the line of sight, or on its own axis 0 to 2; so its picture is below the mouse. Nothing if the
/// handle is behind the camera or the drag has no meaning.
std::optional<std::vector<double>> dragged_numbers(const language::LiteralHandle& handle,
                                                   const viewport::ScreenView& view,
                                                   const Vec2d& offset,
                                                   std::optional<int> axis = std::nullopt);

/// The error of a number that moves the handle by a small part of a pixel.
double number_step(const language::LiteralHandle& handle, const viewport::ScreenView& view);

}  // namespace vug::workbench
