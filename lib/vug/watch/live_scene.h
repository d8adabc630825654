// SPDX-License-Identifier: Apache-2.0
// A scene file that is loaded and rendered again after each change, and keeps what the change
// leaves as it was.
#pragma once

#include <vug/building/builder.h>
#include <vug/loading/scene_source.h>
#include <vug/picture/render_job.h>
#include <vug/render/session.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vug::watch {

struct LiveOptions {
  loading::LoadOptions load;        ///< `frame` chooses the frame.
  picture::PictureOptions picture;  ///< `source` is ignored.
  /// The options of the builder of a version, which live as long as the version.
  std::function<building::BuildOptions(const loading::Loaded&)> build = nullptr;
};

/// The work for one version of a scene.
struct Work {
  size_t declarations_kept = 0;      ///< Declarations whose values are those of another version.
  building::ProductCounts products;  ///< Made, or read from the store.
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
struct View {
  Vec3d eye{0, 0, 5}, target{0, 0, 0};
  double fov = 1.2;   ///< Radians, as the `fov` of a perspective camera.
  bool clay = false;  ///< Grey surfaces, lit from the eye, without a medium.
  int width = 320, height = 180;
  int spp = 4;
};

/// The eye of the scene's camera, and a target in the middle of its picture.
View view_of(const render::Camera& camera, int width, int height);

/// The last version without errors, its products and its picture. The picture has the bytes of
/// `vug render` of the same text, after any sequence of changes. Not thread-safe.
class LiveScene {
 public:
  LiveScene(std::filesystem::path file, LiveOptions options);
  ~LiveScene();

  /// Reads the files again. Returns whether the scene has no errors; otherwise the last version
  /// stays. Error(bad_input) or Error(io) if the file cannot be read. The version can be cancelled
  /// through `progress`, which it keeps.
  bool load(std::shared_ptr<Progress> progress);
  /// Faults and warnings of the text that was read last, with its lines as printed by `vug check`.
  const Diagnostics& problems() const { return problems_; }
  const std::string& report() const { return report_; }
  /// The files of the text that was read last.
  const std::vector<std::filesystem::path>& files() const { return files_; }

  /// Renders the last version without errors, one view or both views of a stereo camera. Throws as
  /// picture::render_picture does; after an error, the products that were made are kept.
  std::vector<picture::RenderResult> render(const PictureStages& stages = {});
  /// A small picture of the last version, denoised: a PNG. Clay is metered. Keeps trees and learned
  /// light for the next look, so that its bytes depend on the looks before. The version keeps
  /// `progress`. Error(cancelled).
  std::string look(const View& view,
                   std::shared_ptr<Progress> progress = std::make_shared<Progress>());
  /// The view and the name of the camera of the last picture; empty without a camera in the text.
  View view() const;
  std::string camera_name() const;
  bool has_version() const { return version_ != nullptr; }
  const loading::Loaded& loaded() const;
  /// The work since the last call of `load` that returned true.
  Work work() const;

 private:
  struct Version;

  std::filesystem::path file_;
  LiveOptions options_;
  loading::SceneSource source_;
  render::Session session_;
  render::Session looks_{render::Learning::kept};
  std::map<mesh::MeshPtr, mesh::MeshPtr> clay_meshes_;  ///< Meshes without colours.
  std::unique_ptr<Version> version_;
  render::SessionCounters before_;  ///< At the last load.
  Diagnostics problems_;
  std::string report_;
  std::vector<std::filesystem::path> files_;
  /// The files of networks that were read, which a text need not name: surveys include others.
  std::map<std::filesystem::path, std::filesystem::file_time_type> network_files_;
};

}  // namespace vug::watch
