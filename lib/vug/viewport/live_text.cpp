// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/dependencies.h>
#include <vug/viewport/live_text.h>

#include <algorithm>
#include <utility>

namespace vug::viewport {
namespace {

/// When a file was written; the earliest time if it does not exist.
std::filesystem::file_time_type time_of(const std::filesystem::path& file) {
  std::error_code code;
  const auto time = std::filesystem::last_write_time(file, code);
  return code ? std::filesystem::file_time_type::min() : time;
}

}  // namespace

struct LiveText::Version {
  Version(loading::Loaded from, const BuildOptionsOf& build, const building::PartCachePtr& parts,
          std::shared_ptr<Progress> work)
      : progress(std::move(work)),
        loaded(std::move(from)),
        builder(loaded.shot, build ? build(loaded) : building::BuildOptions(), *progress) {
    builder.use_parts(parts);
  }

  std::shared_ptr<Progress> progress;
  loading::Loaded loaded;
  building::Builder builder;
  size_t kept = 0;
};

LiveText::LiveText(std::filesystem::path file, loading::LoadOptions load, BuildOptionsOf build)
    : file_(std::move(file)),
      load_(std::move(load)),
      build_(std::move(build)),
      source_("", file_.string(), load_),
      files_{file_} {}

LiveText::~LiveText() = default;

bool LiveText::load(std::string text, std::shared_ptr<Progress> progress,
                    const std::function<void(loading::Loaded&)>& check) {
  source_.set_text(std::move(text));
  for (auto& [file, known] : network_files_)
    if (const auto now = time_of(file); std::exchange(known, now) != now) source_.forget_values();
  loading::Loaded loaded = source_.at(load_.frame);
  // Reused values do not repeat their warnings: those of the last text may apply to this one.
  const bool any = !loaded.diagnostics.all().empty() || !problems_.all().empty();
  const bool usable = loaded.usable();
  if (any && source_.reused() > 0)
    loaded.diagnostics = loading::load_text(source_.text(), file_.string(), load_).diagnostics;
  if (check && usable) check(loaded);
  problems_ = loaded.diagnostics;
  report_ = loaded.report(problems_);
  files_ = loading::file_dependencies(loaded);
  for (const std::filesystem::path& file : loaded.provenance.network_files())
    network_files_.try_emplace(file, time_of(file));
  const auto add = [&](const std::filesystem::path& file) {
    if (std::find(files_.begin(), files_.end(), file) == files_.end()) files_.push_back(file);
  };
  add(file_);
  for (const auto& [file, time] : network_files_) add(file);
  if (!usable) return false;
  auto next = std::make_unique<Version>(std::move(loaded), build_, parts_, std::move(progress));
  next->kept = source_.reused();
  if (version_) next->builder.reuse_from(std::move(version_->builder));
  version_ = std::move(next);
  return true;
}

void LiveText::resume(std::shared_ptr<Progress> progress) {
  auto same =
      std::make_unique<Version>(std::move(version_->loaded), build_, parts_, std::move(progress));
  same->kept = version_->kept;
  same->builder.reuse_from(std::move(version_->builder));
  version_ = std::move(same);
}

const loading::Loaded& LiveText::loaded() const { return version_->loaded; }
building::Builder& LiveText::builder() { return version_->builder; }
const building::Builder& LiveText::builder() const { return version_->builder; }
size_t LiveText::kept() const { return version_->kept; }

}  // namespace vug::viewport
