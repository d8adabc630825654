// SPDX-License-Identifier: Apache-2.0
// A scene that is built for previews, with the places in the text that declare its objects.
#pragma once

#include <vug/picture/render_job.h>
#include <vug/viewport/gizmo.h>
#include <vug/viewport/live_text.h>
#include <vug/viewport/view.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vug::viewport {

/// A declaration that led to a thing in the picture.
struct DeclaredPlace {
  std::string kind;  ///< "object", "place", "mesh", "volume", ...
  std::string name;
  SourceLocation where;  ///< The whole declaration.
};

struct PreviewScene {
  picture::PictureJob job;                  ///< Its camera is that of the text.
  View home;                                ///< The view of the camera of the text.
  std::string camera;                       ///< Its name; empty if the text has none.
  uint64_t version = 0;                     ///< The number of the text; see Viewport.
  std::shared_ptr<const std::string> text;  ///< The text; null if the builder did not keep it.
  /// The declarations of each object or place of the shot: itself, then its mesh, cells, volume and
  /// material.
  std::map<std::string, std::vector<DeclaredPlace>> declared;
  std::vector<Gizmo> gizmos;  ///< Lights and cameras.
  Box3d bounds;               ///< The box around all objects.
};
using PreviewScenePtr = std::shared_ptr<const PreviewScene>;

/// Builds the products of the last version of the text. Throws as picture::prepare_picture does;
/// after Error(cancelled), the products that were made are kept.
PreviewScene build_preview(LiveText& text, const picture::PictureOptions& options);

}  // namespace vug::viewport
