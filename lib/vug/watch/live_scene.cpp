// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/loading/dependencies.h>
#include <vug/picture/stereo_views.h>
#include <vug/watch/live_scene.h>

namespace vug::watch {

struct LiveScene::Version {
  Version(loading::Loaded from, const LiveOptions& options, std::shared_ptr<Progress> work)
      : progress(std::move(work)),
        loaded(std::move(from)),
        builder(loaded.shot, options.build ? options.build(loaded) : building::BuildOptions(),
                *progress) {}

  std::shared_ptr<Progress> progress;
  loading::Loaded loaded;
  building::Builder builder;
  size_t kept = 0;
};

LiveScene::LiveScene(std::filesystem::path file, LiveOptions options)
    : file_(std::move(file)),
      options_(std::move(options)),
      source_("", file_.string(), options_.load) {
  options_.picture.source = &source_;
}

LiveScene::~LiveScene() = default;

bool LiveScene::load(std::shared_ptr<Progress> progress) {
  source_.set_text(read_text(file_));
  loading::Loaded loaded = source_.at(options_.load.frame);
  if (!loaded.diagnostics.all().empty() && source_.reused() > 0)  // reused values repeat none
    problems_ = loading::load_text(source_.text(), file_.string(), options_.load).diagnostics;
  else
    problems_ = loaded.diagnostics;
  report_ = loaded.report(problems_);
  files_ = loading::file_dependencies(loaded);
  if (std::find(files_.begin(), files_.end(), file_) == files_.end()) files_.push_back(file_);
  if (!loaded.usable()) return false;
  auto next = std::make_unique<Version>(std::move(loaded), options_, std::move(progress));
  next->kept = source_.reused();
  if (version_) next->builder.reuse_from(std::move(version_->builder));
  version_ = std::move(next);
  before_ = session_.counters();
  return true;
}

const loading::Loaded& LiveScene::loaded() const { return version_->loaded; }

building::Builder& LiveScene::builder() { return version_->builder; }

std::vector<picture::RenderResult> LiveScene::render(const PictureStages& stages) {
  picture::RenderOptions options;
  options.session = &session_;
  options.unfinished = stages.unfinished;
  return picture::render_views(
      version_->builder, picture::plan_picture(version_->loaded.shot, options_.picture), options);
}

Work LiveScene::work() const {
  const render::SessionCounters& now = session_.counters();
  return {version_->kept,
          version_->builder.counts(),
          {now.trees.built - before_.trees.built, now.trees.reused - before_.trees.reused},
          now.samples - before_.samples};
}

}  // namespace vug::watch
