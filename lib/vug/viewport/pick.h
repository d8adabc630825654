// SPDX-License-Identifier: Apache-2.0
// The thing below a pixel of a preview, and its declarations.
#pragma once

#include <vug/render/prepared_scene.h>
#include <vug/viewport/preview_scene.h>

#include <optional>

namespace vug::viewport {

/// All that picking reads; immutable, so that any thread can pick while others render.
struct PickScene {
  PreviewScenePtr scene;
  std::shared_ptr<const render::PreparedScene> world;
  render::CameraPtr camera;
  double aspect = 1;
};

struct Pick {
  std::string object;    ///< Its name in the picture; of a placed one with that of its place.
  std::string material;  ///< The name of its material; "default" without one.
  Vec3d position, normal;
  double distance = 0;
  uint32_t triangle = 0;  ///< Index in the mesh of the object, or of the brick of a level set.
  /// The declarations of the object, the nearest one first.
  std::vector<DeclaredPlace> declared;
};

/// The surface at a position of the picture, (0, 0) at its top left corner and (1, 1) at the bottom
/// right; nothing where the ray leaves the scene.
std::optional<Pick> pick(const PickScene& scene, double x, double y);

}  // namespace vug::viewport
