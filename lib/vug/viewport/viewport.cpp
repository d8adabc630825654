// SPDX-License-Identifier: Apache-2.0
#include <vug/viewport/viewport.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace vug::viewport {
namespace {

/// The smallest number of samples per pixel for denoising: fewer give no variances.
constexpr int kDenoisedSamples = 4;

/// The times at which unfinished pictures are denoised: at most once a second, and during half of
/// the time at most.
class DenoisingPace {
 public:
  using Clock = std::chrono::steady_clock;

  bool is_due() const { return Clock::now() >= next_; }
  /// Does the work and measures its duration.
  template <class Work>
  void run(const Work& work) {
    const Clock::time_point begin = Clock::now();
    work();
    const Clock::time_point end = Clock::now();
    next_ = end + std::max<Clock::duration>(std::chrono::seconds(1), end - begin);
  }

 private:
  Clock::time_point next_ = Clock::now();
};

/// Whether the last picture of a request is to be denoised.
bool needs_denoising(const Preview& picture) {
  return picture.display.denoise && picture.mode == Mode::path &&
         picture.samples >= kDenoisedSamples && picture.denoised_samples != picture.samples;
}

/// The view with its target on the surface in the middle of the picture.
View with_surface_target(const View& view, const PickScene& scene) {
  const std::optional<Pick> middle = pick(scene, 0.5, 0.5);
  if (!middle || middle->distance <= 0) return view;
  View out = view;
  out.target = view.eye + (view.target - view.eye).normalized() * middle->distance;
  return out;
}

}  // namespace

Viewport::Viewport(std::filesystem::path file, ViewportOptions options,
                   std::function<void()> notify)
    : file_(std::move(file)),
      options_(std::move(options)),
      notify_(std::move(notify)),
      builder_([this] { build_texts(); }),
      renderer_([this] { render_pictures(); }) {}

Viewport::~Viewport() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    build_->cancel();
    render_->cancel();
  }
  changed_.notify_all();
  builder_.join();
  renderer_.join();
}

void Viewport::update(const std::function<void(ViewportStatus&)>& change) {
  {
    const std::lock_guard lock(mutex_);
    change(status_);
  }
  changed_.notify_all();
  if (notify_) notify_();
}

uint64_t Viewport::set_text(std::string text) {
  uint64_t version = 0;
  update([&](ViewportStatus& status) {
    text_ = std::move(text);
    version = ++status.wanted;
    ++orders_;
    build_->cancel();
    status.building = true;
    status.stopped = false;
  });
  return version;
}

void Viewport::refresh() {
  update([&](ViewportStatus& status) {
    if (status.wanted == 0) return;
    ++orders_;
    build_->cancel();
    status.building = true;
    status.stopped = false;
  });
}

void Viewport::set_view(const std::optional<View>& view) {
  request_.view = view;
  request_picture();
}

void Viewport::set_mode(Mode mode) {
  request_.mode = mode;
  request_picture();
}

void Viewport::set_size(int width, int height) {
  request_.width = std::max(1, width), request_.height = std::max(1, height);
  request_picture();
}

void Viewport::set_region(const std::optional<RegionBox>& region) {
  request_.region = region;
  request_picture();
}

void Viewport::set_display(const DisplayChoice& display) {
  request_.display = display;
  request_picture();
}

void Viewport::set_paused(bool paused) {
  update([&](ViewportStatus& status) {
    if (status.paused == paused) return;
    status.paused = paused;
    if (paused && refining_) render_->cancel();
    ++requests_;
    status.rendering = scene_ != nullptr;
    if (paused) return;
    status.stopped = false;
  });
}

void Viewport::request_picture() {
  update([&](ViewportStatus& status) {
    if (shown_ == request_ && requests_ > 0) return;
    shown_ = request_;
    ++requests_;
    if (refining_) render_->cancel();
    status.rendering = status.rendering || scene_ != nullptr;
    status.stopped = false;
  });
}

void Viewport::stop() {
  update([&](ViewportStatus& status) {
    if (!status.busy()) return;
    build_->cancel();
    render_->cancel();
    status.stopped = true;
  });
}

View Viewport::view() const {
  if (request_.view) return *request_.view;
  const std::lock_guard lock(mutex_);
  return home_.value_or(View());
}

ViewportStatus Viewport::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

void Viewport::wait() const {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return !status_.busy(); });
}

void Viewport::build_texts() {
  Diagnostics warnings;  // of the products
  const BuildOptionsOf with_warnings = [&](const loading::Loaded& loaded) {
    building::BuildOptions out = options_.build ? options_.build(loaded) : building::BuildOptions();
    out.on_warning = [&](const Diagnostics& found) { warnings.append(found); };
    return out;
  };
  // All pictures have the layers that denoising needs, so that a switch needs no new samples.
  picture::PictureOptions picture = options_.picture;
  picture.settings.emplace_back("denoise", true);
  LiveText text(file_, options_.load, with_warnings);
  uint64_t done = 0;
  while (true) {
    std::string content;
    uint64_t version = 0;
    std::shared_ptr<Progress> progress;
    {
      std::unique_lock lock(mutex_);
      if (status_.stopped) done = orders_;
      if (orders_ == done) status_.building = false;
      changed_.notify_all();
      changed_.wait(lock, [&] { return ended_ || orders_ != done; });
      if (ended_) return;
      if (status_.stopped) continue;
      done = orders_, version = status_.wanted, content = text_;
      progress = std::make_shared<Progress>([this](const std::string& stage, double fraction) {
        update([&](ViewportStatus& status) { status.stage = stage, status.fraction = fraction; });
      });
      build_ = progress;
    }
    warnings = {};
    Diagnostics problems;
    std::string report;
    const auto show_problems = [&](bool failed) {
      update([&](ViewportStatus& status) {
        status.problems = std::make_shared<const Diagnostics>(problems);
        status.report = report;
        status.checked = version;
        if (failed) status.failed = version;
      });
    };
    try {
      const auto kept = std::make_shared<const std::string>(content);
      const bool usable = text.load(std::move(content), progress, options_.check);
      problems = text.problems();
      report = text.report();
      update([&](ViewportStatus& status) { ++status.counters.texts; });
      show_problems(!usable);
      if (!usable) continue;
      progress->check();
      auto scene = std::make_shared<PreviewScene>(build_preview(text, picture));
      scene->text = kept;
      scene->version = version;
      problems.append(warnings);
      report = text.loaded().report(problems);
      show_problems(false);
      update([&](ViewportStatus& status) {
        ++status.counters.scenes;
        status.counters.products += text.builder().counts().total();
        scene_ = scene;
        home_ = scene->home;
        ++requests_;
        if (refining_) render_->cancel();
        status.rendering = true;
      });
    } catch (const Error& error) {
      if (error.code() == ErrorCode::cancelled) {
        update([&](ViewportStatus& status) { status.failed = version; });
        continue;
      }
      problems.append(warnings);
      problems.add(error, {file_.string(), 1, 1});
      report = text.has_version() ? text.loaded().report(problems) : error.located_message() + "\n";
      show_problems(true);
    } catch (const std::exception& error) {
      problems.error({file_.string(), 1, 1}, error.what(), "reduce the size of the scene");
      show_problems(true);
    }
  }
}

void Viewport::publish(Preview picture, const render::SessionCounters& counters) {
  std::optional<View> home;
  if (picture.view == picture.scene.scene->home)
    home = with_surface_target(picture.view, picture.scene);
  const auto shared = std::make_shared<const Preview>(std::move(picture));
  update([&](ViewportStatus& status) {
    status.picture = shared;
    ++status.counters.pictures;
    status.counters.trees = counters.trees.built;
    status.counters.samples = counters.samples;
    if (home && scene_ == shared->scene.scene) home_ = home;
  });
}

void Viewport::render_pictures() {
  PreviewRenderer renderer;
  PreviewScenePtr known;
  uint64_t done = 0;
  // The steps for the last request whose samples differ from those before it, and the next of them.
  std::optional<PreviewRequest> rendered;
  std::vector<PreviewStep> steps;
  size_t next = 0;
  DenoisingPace pace;
  while (true) {
    PreviewRequest request;
    PreviewScenePtr scene;
    std::shared_ptr<Progress> progress;
    {
      std::unique_lock lock(mutex_);
      refining_ = false;
      if (status_.stopped) done = requests_;
      if (requests_ == done || !scene_) status_.rendering = false;
      changed_.notify_all();
      changed_.wait(lock, [&] { return ended_ || (requests_ != done && scene_); });
      if (ended_) return;
      if (status_.stopped) continue;
      done = requests_, request = shown_, scene = scene_;
      render_ = progress = std::make_shared<Progress>();
      status_.rendering = true;
    }
    if (notify_) notify_();
    const auto denoise = [&] {
      const PreviewPtr last = status().picture;
      if (!last || last->scene.scene != scene || !needs_denoising(*last)) return;
      {
        const std::lock_guard lock(mutex_);
        if (requests_ != done) return;
        refining_ = true;
      }
      pace.run([&] { publish(renderer.denoised(*last, *progress), renderer.counters()); });
    };
    try {
      const bool continues = scene == known && next > 0 && rendered->same_samples(request);
      if (scene != known) renderer.set_scene(known = scene);
      if (!continues) {
        rendered = request;
        steps = renderer.steps(request);
        next = 0;
      } else if (const PreviewPtr last = status().picture; last->display != request.display) {
        publish(PreviewRenderer::displayed(*last, request.display), renderer.counters());
      }
      while (next < steps.size()) {
        {
          const std::lock_guard lock(mutex_);
          if (next > 0 && (requests_ != done || status_.paused)) break;
          refining_ = next > 0;
        }
        publish(renderer.render(request, steps[next], next + 1 == steps.size(), *progress),
                renderer.counters());
        ++next;
        if (next < steps.size() && pace.is_due()) denoise();
      }
      denoise();
    } catch (const Error& error) {
      if (error.code() == ErrorCode::cancelled) continue;
      update([&](ViewportStatus& status) {
        Diagnostics problems = *status.problems;
        problems.add(error, {file_.string(), 1, 1});
        status.problems = std::make_shared<const Diagnostics>(std::move(problems));
        status.report += error.located_message() + "\n";
      });
    }
  }
}

}  // namespace vug::viewport
