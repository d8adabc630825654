// SPDX-License-Identifier: Apache-2.0
// The values of a pixel of a preview, and the thing below it.
#pragma once

#include <vug/viewport/pick.h>
#include <vug/viewport/preview_renderer.h>

#include <array>
#include <optional>

namespace vug::viewport {

struct PixelReport {
  int x = 0, y = 0;  ///< The pixel of the picture, from the top left corner.
  /// Linear values: radiance in Mode::path; nothing outside of the region that is rendered.
  std::optional<Vec3d> light;
  std::array<uint8_t, 3> shown{};         ///< Display values.
  int samples = 0;                        ///< Per pixel of the picture; 0 outside of the region.
  std::optional<Pick> pick;               ///< Nothing where the ray leaves the scene.
  std::optional<DeclaredPlace> material;  ///< The declaration of the material of the object.
};

/// The pixel at a position of the picture, (0, 0) at its top left corner and (1, 1) at the bottom
/// right.
PixelReport inspect(const Preview& picture, double x, double y);

/// "(0.1, 0.2, 0.3) shown as 90 123 148, object ball, material stone".
std::string describe(const PixelReport& report);

}  // namespace vug::viewport
