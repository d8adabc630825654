#include <vug/base/memory.h>
#include <vug/picture/render_job.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::picture {
namespace {
namespace fs = std::filesystem;

bool whole(const render::RenderSlice& slice) {
  return slice.bands == 1 && slice.band == 0 && slice.begin == 0 && slice.end == 0;
}

void require_fit(const RenderOptions& options) {
  if (!whole(options.slice) && options.part.empty())
    throw Error(ErrorCode::bad_input, "a part of a picture is no picture yet", {},
                "name a file for it with --part, and put all parts together with vug merge");
  if (options.resume && options.checkpoint.empty())
    throw Error(ErrorCode::bad_input, "there is nothing to resume from", {},
                "name the file with --checkpoint");
  if (!options.checkpoint.empty() && !options.resume && fs::exists(options.checkpoint))
    throw Error(ErrorCode::bad_input,
                fmt::format("the checkpoint '{}' is there already", options.checkpoint.string()),
                {}, "go on from it with --resume, or remove it");
}

/// How to go on after a stop.
std::string resume_hint(const RenderOptions& options, const render::RenderState& state) {
  return fmt::format("'{}' keeps what is done, {:.1f} %; {} goes on from it",
                     options.checkpoint.string(), std::floor(1000 * state.fraction()) / 10,
                     options.resume ? "the same command" : "the same command with --resume");
}

/// The state to begin with: that of the checkpoint, or an empty one.
render::RenderState initial_state(const PictureJob& job, const RenderOptions& options) {
  render::RenderState state = render::begin_render(job.options, options.slice);
  if (!options.resume || !fs::exists(options.checkpoint)) return state;
  constexpr const char* kAnew = "remove it to begin anew";
  const auto read = [&] {
    try {
      return render::read_partial_render(options.checkpoint, "checkpoint");
    } catch (const Error& error) {
      if (error.code() != ErrorCode::bad_input) throw;
      throw Error(error.code(), error.what(), error.where(), kAnew);
    }
  };
  render::PartialRender kept = read();
  const auto refuse = [&](const std::string& what) {
    return Error(ErrorCode::bad_input,
                 fmt::format("the checkpoint '{}' is of another picture: {}",
                             options.checkpoint.string(), what),
                 {}, kAnew);
  };
  if (const std::string what = render::difference(kept.header, job.header); !what.empty())
    throw refuse("different " + what);
  if (!(kept.state.region() == state.region()) || kept.state.begin != state.begin ||
      kept.state.end != state.end)
    throw refuse("another tile or range of samples");
  return std::move(kept.state);
}

}  // namespace

RenderResult render_picture(building::Builder& builder, const RenderOptions& options) {
  require_fit(options);
  const bool kept =
      !options.part.empty() || !options.checkpoint.empty() || !options.preview.empty();
  PictureJob job = prepare_picture(builder, options.picture, kept);
  RenderResult rendered{std::nullopt, std::nullopt, job.header, job.where};
  render::RenderCallbacks callbacks;
  const double memory = static_cast<double>(resident_memory()) +
                        render::memory_estimate(job.scene, job.options, kept);
  if (options.estimate) callbacks.estimate = [&](double seconds) { options.estimate(seconds, memory); };
  callbacks.invalid_samples = [&](uint64_t refused, uint64_t cut) {
    if (refused > 0)
      builder.warn(job.where, fmt::format("{} samples were no number and left out", refused),
                   "a material or a light gives values that are none");
    if (cut > 0)
      builder.warn(job.where, fmt::format("{} samples were cut to {:.0f}", cut, render::kMaxLight),
                   "a light is brighter than pictures can hold");
  };
  if (!kept) {
    image::DeepImage* deep = job.options.deep ? &rendered.deep.emplace() : nullptr;
    rendered.image = render::render(job.scene, job.options, builder.progress(), callbacks, deep);
    return rendered;
  }
  if (!options.checkpoint.empty()) {
    callbacks.save_every = options.checkpoint_every;
    callbacks.save = [&](const render::RenderState& state) {
      render::write_partial_render(options.checkpoint, job.header, state);
    };
  }
  if (!options.preview.empty())
    callbacks.pass = [&](const render::RenderState& state) {
      write_preview(options.preview, render::develop(state, job.options.aovs), job.header);
    };
  render::RenderState state = initial_state(job, options);
  try {
    render::continue_render(job.scene, job.options, state, callbacks, builder.progress());
  } catch (const Error& error) {
    if (error.code() != ErrorCode::cancelled || options.checkpoint.empty()) throw;
    throw Error(error.code(), error.what(), error.where(), resume_hint(options, state));
  }
  if (!options.part.empty())
    render::write_partial_render(options.part, job.header, state);
  else
    rendered.image = render::develop(state, job.options.aovs);
  return rendered;
}

void remove_checkpoint(const RenderOptions& options) {
  std::error_code ignored;
  if (!options.checkpoint.empty()) fs::remove(options.checkpoint, ignored);
}

}  // namespace vug::picture
