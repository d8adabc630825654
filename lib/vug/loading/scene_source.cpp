// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/loading/scene_source.h>

#include <fmt/format.h>

namespace vug::loading {

SceneSource::SceneSource(std::string text, std::string file, LoadOptions options)
    : text_(std::move(text)), file_(std::move(file)), options_(std::move(options)) {}

SceneSource::SceneSource(const std::filesystem::path& file, LoadOptions options)
    : SceneSource(read_text(file), file.string(), std::move(options)) {}

Loaded SceneSource::at(double frame) const { return evaluate("", frame); }

Loaded SceneSource::evaluate(const std::string& expression, double frame) const {
  const std::lock_guard lock(mutex_);
  LoadOptions options = options_;
  options.expression = expression;
  options.frame = frame;
  options.static_cache = &static_cache_;
  return load_text(text_, file_, options);
}

std::shared_ptr<const shot::Shot> SceneSource::shot_at(double frame) const {
  Loaded loaded = at(frame);
  for (const Diagnostic& each : loaded.diagnostics.all())
    if (each.severity == Severity::error)
      throw Error(ErrorCode::bad_input, each.message, each.where, each.hint)
          .within(fmt::format("loading frame {}", frame));
  return std::make_shared<const shot::Shot>(std::move(loaded.shot));
}

}  // namespace vug::loading
