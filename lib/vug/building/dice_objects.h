// SPDX-License-Identifier: Apache-2.0
// Replaces the meshes of objects with detail by diced ones: micro-displacement, for one picture or
// for an export.
#pragma once

#include <vug/building/flat_scene.h>
#include <vug/render/cameras/pixel_size.h>

namespace vug::building {

/// The pixels that define the lengths of edges.
struct DicingView {
  /// All views for which the mesh must be fine enough: the eyes of a stereo picture, at all times
  /// of the exposure. Empty for exports: only objects with a fixed edge length are diced.
  std::vector<render::CameraPtr> cameras;
  render::PictureSize picture;  ///< The whole picture, even if only a part of it is rendered.
};

/// Dices the objects of `part` that are shown at their own position; `objects` are those of its
/// flat scene. Instances are not diced, and drafts neither. The number of triangles of all objects
/// and their memory, in the mesh and in the renderer, are estimated first: Error(too_large), with
/// the rate that would fit, if they exceed the memory budget. Warns about vertices that could not
/// follow the detail.
void dice_objects(Builder& builder, const shot::Shot& part, const DicingView& view,
                  std::vector<render::Object>& objects);

}  // namespace vug::building
