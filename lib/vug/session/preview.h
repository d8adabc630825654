// A page that shows a scene to whoever has a browser.
#pragma once

#include <vug/building/builder.h>
#include <vug/loading/load.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::session {

struct PreviewOptions {
  /// A page with the marks @VUG_TITLE@, @VUG_DATA@ and @VUG_MODEL@, once and in that order: see
  /// plugins/preview.
  std::string page;
  std::filesystem::path picture;  ///< A PNG or JPEG to show; empty: none, or one that is rendered.
  bool render = false;            ///< Renders a small picture where there is none.
  size_t max_triangles = 300000;  ///< Of the model; see exchange::coarser.
  std::string mesh;               ///< Whose metrics are told; empty: the largest that is shown.
};

struct Preview {
  std::string page;                      ///< Whole, and needs no other file.
  size_t triangles = 0, whole = 0;       ///< In the page, and before they were thinned out.
  std::vector<std::string> unsupported;  ///< In sentences, what the model cannot hold.
};

/// The model as glTF in the page, with the picture, the derivation trees, the metrics, the
/// parameters and the recipe as JSON. The builder's shot is that of `loaded` by with_meshes. The
/// same scene, the same bytes. Error(bad_input) where the page lacks a mark or the picture is none.
Preview make_preview(building::Builder& builder, const loading::Loaded& loaded,
                     const PreviewOptions& options);

}  // namespace vug::session
