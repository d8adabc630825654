// SPDX-License-Identifier: Apache-2.0
#include <vug/base/memory.h>
#include <vug/picture/render_job.h>
#include <vug/render/film/guiding_file.h>
#include <vug/render/session.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vug::picture {
namespace {
namespace fs = std::filesystem;

bool is_whole_picture(const render::RenderSlice& slice) {
  return slice.bands == 1 && slice.band == 0 && slice.begin == 0 && slice.end == 0;
}

void require_consistent(const RenderOptions& options) {
  if (!is_whole_picture(options.slice) && options.part.empty())
    throw Error(ErrorCode::bad_input, "a partial render needs a file of its own", {},
                "name the file with --part, and combine all parts with vug merge");
  if (options.resume && options.checkpoint.empty())
    throw Error(ErrorCode::bad_input, "there is nothing to resume from", {},
                "name the file with --checkpoint");
  if (!options.checkpoint.empty() && !options.resume && fs::exists(options.checkpoint))
    throw Error(ErrorCode::bad_input,
                fmt::format("the checkpoint '{}' already exists", options.checkpoint.string()), {},
                "continue from it with --resume, or remove it");
}

/// A hint on how to continue after a stop. A render that is stopped while trees are built and light
/// is learned has no samples, and writes no checkpoint.
std::string resume_hint(const RenderOptions& options, const render::RenderState& state) {
  if (!fs::exists(options.checkpoint))
    return fmt::format(
        "the render was stopped before its first sample, so '{}' was not written; the same command "
        "starts again",
        options.checkpoint.string());
  return fmt::format("'{}' contains the work so far, {:.1f} %; {} continues from it",
                     options.checkpoint.string(), std::floor(1000 * state.fraction()) / 10,
                     options.resume ? "the same command" : "the same command with --resume");
}

/// The initial state: that of the checkpoint, or an empty one.
render::RenderState initial_state(const PictureJob& job, const render::PartialRenderHeader& header,
                                  const RenderOptions& options) {
  render::RenderState state = render::begin_render(job.options, options.slice);
  if (!options.resume || !fs::exists(options.checkpoint)) return state;
  constexpr const char* kAnew = "remove it to start again";
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
                 fmt::format("the checkpoint '{}' belongs to another picture: {}",
                             options.checkpoint.string(), what),
                 {}, kAnew);
  };
  if (const std::string what = render::difference(kept.header, header); !what.empty())
    throw refuse("different " + what);
  if (!(kept.state.region == state.region) || kept.state.begin != state.begin ||
      kept.state.end != state.end)
    throw refuse("another tile or range of samples");
  return std::move(kept.state);
}

/// Prepares the pixels of the region with the light of the guiding file, which is written if it
/// does not exist.
render::PreparedRender prepare_region(const PictureJob& job,
                                      const render::PartialRenderHeader& header,
                                      const render::Region& region, const fs::path& guiding,
                                      Progress& progress) {
  render::PrepareOptions part;
  part.region = region;
  const bool known = !guiding.empty() && fs::exists(guiding);
  if (known) part.learned = render::read_guiding(guiding, header);
  render::PreparedRender prepared = render::prepare(job.scene, job.options, part, progress);
  if (!guiding.empty() && !known) render::write_guiding(guiding, header, *prepared.learned);
  return prepared;
}

/// Options of a small picture of the whole view, without anything that pays off only for many
/// samples; nothing if the picture is small or cropped.
std::optional<render::Options> coarse_options(render::Options options) {
  constexpr int kWidth = 160;
  const int shrink = (std::max(options.width, options.height) + kWidth - 1) / kWidth;
  if (shrink == 1 || !(options.crop == render::Region())) return std::nullopt;
  options.width = std::max(1, options.width / shrink);
  options.height = std::max(1, options.height / shrink);
  options.spp = 1;
  options.noise = 0;
  options.openings = options.bright_edges = false;
  options.deep.reset();
  return options;
}

/// The picture, each pixel of which becomes a rectangle.
image::Image enlarged(const image::Image& small, int width, int height) {
  image::Image out(width, height, small.channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      std::copy_n(&small.pixels[small.index(x * small.width / width, y * small.height / height)],
                  small.channels.size(), &out.pixels[out.index(x, y)]);
  return out;
}

/// Renders the picture of the job in a session.
void render_in_session(const PictureJob& job, const RenderOptions& options,
                       render::RenderCallbacks callbacks, Progress& progress,
                       RenderResult& rendered) {
  render::Session& session = *options.session;
  session.set_scene(job.scene);
  session.set_options(job.options);
  const bool is_new = !session.has_samples();
  if (const auto coarse = coarse_options(job.options); coarse && is_new && options.unfinished) {
    session.set_options(*coarse);
    session.proceed(1, progress);
    options.unfinished(enlarged(session.image(), job.options.width, job.options.height),
                       job.output);
    session.set_options(job.options);
  }
  const render::PreparedRender& prepared = session.prepared(progress);
  if (options.inspect) options.inspect(prepared);
  if (options.unfinished && !session.is_complete())
    callbacks.pass = [&](const render::RenderState& state) {
      if (!state.complete())
        options.unfinished(render::develop(state, job.options.aovs), job.output);
    };
  session.proceed(static_cast<uint32_t>(job.options.spp), progress, callbacks);
  rendered.image = session.image();
  if (job.options.deep) rendered.deep = session.deep();
}

/// Adds the noise that was reached to the metadata of the picture. They contain no times, since the
/// same picture has the same bytes.
void add_noise(const render::NoiseReport& report, PictureOutput& output) {
  std::erase_if(output.metadata,
                [](const auto& each) { return each.first == kNoise || each.first == kSamples; });
  output.metadata.emplace_back(kNoise, fmt::format("{:.5f}", report.noise));
  output.metadata.emplace_back(kSamples, fmt::format("{:.2f}", report.samples));
}

/// Reports samples that were discarded or clamped.
void add_sample_warnings(building::Builder& builder, const SourceLocation& where,
                         render::RenderCallbacks& callbacks) {
  callbacks.invalid_samples = [&builder, where](uint64_t refused, uint64_t cut) {
    if (refused > 0)
      builder.warn(where,
                   fmt::format("{} samples were NaN or infinite and were discarded", refused),
                   "a material or a light returns invalid values");
    if (cut > 0)
      builder.warn(where, fmt::format("{} samples were clamped to {:.0f}", cut, render::kMaxLight),
                   "a light exceeds the range of pictures");
  };
}

/// Writes the checkpoint of the options while rendering.
void add_saving(const RenderOptions& options, const render::PartialRenderHeader& header,
                render::RenderCallbacks& callbacks) {
  if (options.checkpoint.empty()) return;
  callbacks.save_every = options.checkpoint_every;
  callbacks.save = [&](const render::RenderState& state) {
    render::write_partial_render(options.checkpoint, header, state);
  };
}

/// An error while rendering, with a hint on how to continue after a stop.
Error stop_error(const Error& error, const RenderOptions& options,
                 const render::RenderState& state) {
  if (error.code() != ErrorCode::cancelled || options.checkpoint.empty()) return error;
  return Error(error.code(), error.what(), error.where(), resume_hint(options, state));
}

}  // namespace

RenderResult render_picture(building::Builder& builder, const PicturePlan& plan,
                            const RenderOptions& options) {
  require_consistent(options);
  const bool saved = !options.part.empty() || !options.checkpoint.empty();
  const bool kept = saved || !options.preview.empty();
  const PictureJob job = prepare_picture(builder, plan, kept);
  const SourceLocation& where = plan.render.where;
  RenderResult rendered{std::nullopt, std::nullopt, render::partial_render_header(job.options),
                        job.output, where};
  render::RenderCallbacks callbacks;
  const double memory = static_cast<double>(resident_memory()) +
                        render::memory_estimate(job.scene, job.options, kept);
  if (options.estimate)
    callbacks.estimate = [&](double seconds) { options.estimate(seconds, memory); };
  add_sample_warnings(builder, where, callbacks);
  callbacks.noise = [&](const render::NoiseReport& report, double seconds) {
    add_noise(report, rendered.output);
    if (options.noise) options.noise(report, seconds);
  };
  render::PartialRenderHeader header;  // identifies the picture by hashes of all meshes
  if (saved || !options.guiding.empty()) header = file_header(job, builder.shot(), plan);
  if (options.session) {
    render_in_session(job, options, std::move(callbacks), builder.progress(), rendered);
    return rendered;
  }
  if (!kept) {
    image::DeepImage* deep = job.options.deep ? &rendered.deep.emplace() : nullptr;
    const render::PreparedRender prepared = prepare_region(
        job, header, render::render_region(job.options), options.guiding, builder.progress());
    if (options.inspect) options.inspect(prepared);
    rendered.image = render::render(prepared, builder.progress(), callbacks, deep);
    return rendered;
  }
  add_saving(options, header, callbacks);
  if (!options.preview.empty())
    callbacks.pass = [&](const render::RenderState& state) {
      write_preview(options.preview, render::develop(state, job.options.aovs), job.output);
    };
  render::RenderState state = initial_state(job, header, options);
  try {
    const render::PreparedRender prepared =
        prepare_region(job, header, state.region, options.guiding, builder.progress());
    if (options.inspect) options.inspect(prepared);
    if (!options.part.empty() && options.guiding.empty() && prepared.learned->guiding)
      builder.warn(where, "this part learned the light of the whole picture for itself",
                   "parts that name the same --guiding FILE share it, and it is learned once");
    render::continue_render(prepared, state, callbacks, builder.progress());
  } catch (const Error& error) {
    throw stop_error(error, options, state);
  }
  if (!options.part.empty()) {
    render::write_partial_render(options.part, header, state);
    return rendered;
  }
  rendered.image = render::develop(state, job.options.aovs);
  if (job.options.deep) rendered.deep = render::develop(state, *job.options.deep);
  return rendered;
}

void learn_light(building::Builder& builder, const PicturePlan& plan, const fs::path& guiding) {
  const PictureJob job = prepare_picture(builder, plan, false);
  const render::PartialRenderHeader header = file_header(job, builder.shot(), plan);
  if (fs::exists(guiding)) {
    render::read_guiding(guiding, header);
    return;
  }
  prepare_region(job, header, render::Region(), guiding, builder.progress());
}

void remove_checkpoint(const RenderOptions& options) {
  std::error_code ignored;
  if (!options.checkpoint.empty()) fs::remove(options.checkpoint, ignored);
}

struct PartRenderer::Picture {
  building::Builder& builder;
  SourceLocation where;
  fs::path guiding;
  PictureJob job;
  render::PartialRenderHeader header;
  std::optional<render::PreparedRender> prepared;  // refers to `job`
  size_t preparations = 0;
};

PartRenderer::PartRenderer(building::Builder& builder, const PicturePlan& plan,
                           const fs::path& guiding)
    : picture_(new Picture{
          builder, plan.render.where, guiding, prepare_picture(builder, plan, true), {}, {}, 0}) {
  picture_->header = file_header(picture_->job, builder.shot(), plan);
}

PartRenderer::~PartRenderer() = default;

void PartRenderer::render(const RenderOptions& options) {
  if (options.part.empty())
    throw Error(ErrorCode::bad_input, "a partial render needs a file of its own", {},
                "name the file with --part, and combine all parts with vug merge");
  require_consistent(options);
  Picture& picture = *picture_;
  Progress& progress = picture.builder.progress();
  render::RenderCallbacks callbacks;
  add_sample_warnings(picture.builder, picture.where, callbacks);
  add_saving(options, picture.header, callbacks);
  render::RenderState state = initial_state(picture.job, picture.header, options);
  try {
    if (!picture.prepared || !(picture.prepared->region == state.region)) {
      picture.prepared.reset();  // before the memory of the next one is needed
      picture.prepared =
          prepare_region(picture.job, picture.header, state.region, picture.guiding, progress);
      ++picture.preparations;
    }
    render::continue_render(*picture.prepared, state, callbacks, progress);
  } catch (const Error& error) {
    throw stop_error(error, options, state);
  }
  render::write_partial_render(options.part, picture.header, state);
  remove_checkpoint(options);
}

size_t PartRenderer::preparations() const { return picture_->preparations; }

}  // namespace vug::picture
