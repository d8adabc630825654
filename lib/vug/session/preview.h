// SPDX-License-Identifier: Apache-2.0
// Writes the page of `vug preview`: the model, cameras and lights of a scene in the template that
// plugins/preview builds.
#pragma once

#include <vug/building/builder.h>
#include <vug/loading/load.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::session {

struct PreviewOptions {
  /// HTML template with the marks @VUG_TITLE@, @VUG_DATA@ and @VUG_MODEL@, once each and in that
  /// order; see plugins/preview.
  std::string page;
  std::filesystem::path picture;  ///< PNG or JPEG to show; empty: none, or a rendered one.
  bool render = false;            ///< Render a small picture if none is given.
  size_t max_triangles = 300000;  ///< Limit for the model; see exchange::coarser.
  std::string mesh;               ///< Mesh to measure; empty: the largest shown mesh.
};

struct Preview {
  std::string page;                      ///< Complete HTML, independent of other files.
  size_t triangles = 0, whole = 0;       ///< In the page, and before decimation.
  std::vector<std::string> unsupported;  ///< Sentences about omitted features.
};

/// Fills the template with the model as glTF, and the picture, the derivation trees, the metrics,
/// the parameters and the recipe as JSON. The builder's shot must be that of `loaded` after
/// with_meshes. The output is deterministic. Error(bad_input) if the template lacks a mark or the
/// picture cannot be read.
Preview make_preview(building::Builder& builder, const loading::Loaded& loaded,
                     const PreviewOptions& options);

}  // namespace vug::session
