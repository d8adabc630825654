// SPDX-License-Identifier: Apache-2.0
// The text of a scene that is being edited: the last version without errors and its products.
#pragma once

#include <vug/building/builder.h>
#include <vug/loading/scene_source.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vug::viewport {

/// The options of the builder of a version, which live as long as the version.
using BuildOptionsOf = std::function<building::BuildOptions(const loading::Loaded&)>;

/// Values of declarations and products that a change does not affect are kept. Not thread-safe.
class LiveText {
 public:
  /// `file`: the name of the text in messages, and the base of its relative paths.
  LiveText(std::filesystem::path file, loading::LoadOptions load, BuildOptionsOf build = nullptr);
  ~LiveText();
  LiveText(const LiveText&) = delete;
  LiveText& operator=(const LiveText&) = delete;

  /// Evaluates a text. Returns whether it has no errors; otherwise the last version stays. The
  /// version can be cancelled through `progress`, which it keeps. `check` may add faults.
  bool load(std::string text, std::shared_ptr<Progress> progress,
            const std::function<void(loading::Loaded&)>& check = nullptr);
  /// Another progress for the products of the version: work that was cancelled can continue.
  void resume(std::shared_ptr<Progress> progress);

  /// Faults and warnings of the last text, with its lines as printed by `vug check`.
  const Diagnostics& problems() const { return problems_; }
  const std::string& report() const { return report_; }
  /// The files of the last text, this one included.
  const std::vector<std::filesystem::path>& files() const { return files_; }

  bool has_version() const { return version_ != nullptr; }
  const loading::Loaded& loaded() const;
  building::Builder& builder();
  const building::Builder& builder() const;
  /// The number of declarations whose values are those of another version.
  size_t kept() const;
  /// The parts of level sets and meshes that were computed and reused in all versions.
  building::PartCounts part_counts() const { return parts_->counts(); }
  /// The source of the last text, for other frames.
  const loading::SceneSource& source() const { return source_; }

 private:
  struct Version;

  std::filesystem::path file_;
  loading::LoadOptions load_;
  BuildOptionsOf build_;
  loading::SceneSource source_;
  building::PartCachePtr parts_ = std::make_shared<building::PartCache>();
  std::unique_ptr<Version> version_;
  Diagnostics problems_;
  std::string report_;
  std::vector<std::filesystem::path> files_;
  /// The files of networks that were read, which a text need not name: surveys include others.
  std::map<std::filesystem::path, std::filesystem::file_time_type> network_files_;
};

}  // namespace vug::viewport
