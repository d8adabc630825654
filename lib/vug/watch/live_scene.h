// SPDX-License-Identifier: Apache-2.0
// A scene file that is loaded and rendered again after each change, and keeps what the change
// leaves as it was.
#pragma once

#include <vug/picture/render_job.h>
#include <vug/render/session.h>
#include <vug/viewport/live_text.h>
#include <vug/viewport/preview_modes.h>
#include <vug/viewport/view.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace vug::watch {

struct LiveOptions {
  loading::LoadOptions load;        ///< `frame` chooses the frame.
  picture::PictureOptions picture;  ///< `source` is ignored.
  /// The options of the builder of a version, which live as long as the version.
  viewport::BuildOptionsOf build = nullptr;
};

/// The work for one version of a scene.
struct Work {
  size_t declarations_kept = 0;      ///< Declarations whose values are those of another version.
  building::ProductCounts products;  ///< Made, or read from the store.
  building::PartCounts parts;        ///< Computed and reused for these products.
  render::TreeCounts trees;
  uint64_t samples = 0;  ///< Samples of all pixels.
};

/// The pictures of a version while it is rendered.
struct PictureStages {
  /// A small picture with one sample per pixel, scaled to the size of the picture, and the picture
  /// after 4, 8, 16, ... samples.
  std::function<void(const image::Image& image, const picture::PictureOutput& output)> unfinished =
      nullptr;
};

/// A look at a scene from an eye that its text does not have.
struct ViewRequest {
  viewport::View view;
  viewport::Mode mode = viewport::Mode::path;
  int width = 320, height = 180;
  int spp = 4;
};

/// The last version without errors, its products and its picture. The picture has the bytes of
/// `vug render` of the same text, after any sequence of changes. Not thread-safe.
class LiveScene {
 public:
  LiveScene(std::filesystem::path file, LiveOptions options);

  /// Reads the files again. Returns whether the scene has no errors; otherwise the last version
  /// stays. Error(bad_input) or Error(io) if the file cannot be read. The version can be cancelled
  /// through `progress`, which it keeps.
  bool load(std::shared_ptr<Progress> progress);
  /// Faults and warnings of the text that was read last, with its lines as printed by `vug check`.
  const Diagnostics& problems() const { return text_.problems(); }
  const std::string& report() const { return text_.report(); }
  /// The files of the text that was read last.
  const std::vector<std::filesystem::path>& files() const { return text_.files(); }

  /// Renders the last version without errors, one view or both views of a stereo camera. Throws as
  /// picture::render_picture does; after an error, the products that were made are kept.
  std::vector<picture::RenderResult> render(const PictureStages& stages = {});
  /// A small picture of the last version: a PNG. That of Mode::path is denoised, and its bytes
  /// depend on the looks before, since trees and learned light are kept for the next look. The
  /// version keeps `progress`. Error(cancelled).
  std::string look(const ViewRequest& look,
                   std::shared_ptr<Progress> progress = std::make_shared<Progress>());
  /// The view and the name of the camera of the last picture; empty without a camera in the text.
  viewport::View view() const;
  std::string camera_name() const;
  bool has_version() const { return text_.has_version(); }
  const loading::Loaded& loaded() const { return text_.loaded(); }
  /// The work since the last call of `load` that returned true.
  Work work() const;

 private:
  std::filesystem::path file_;
  LiveOptions options_;
  viewport::LiveText text_;
  building::PartCounts parts_before_;  ///< At the last load.
  render::Session session_;
  render::Session looks_{render::Learning::kept};
  render::SessionCounters before_;  ///< At the last load.
};

}  // namespace vug::watch
