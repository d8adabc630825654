// SPDX-License-Identifier: Apache-2.0
#include "watch/watch_loop.h"

#include <vug/picture/stereo_views.h>
#include <vug/watch/file_watcher.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace vug::cli {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Looks for changes on a thread of its own. A change cancels the current work.
class ChangeThread {
 public:
  ChangeThread(bool polling, const Progress& stop)
      : watcher_(polling ? watch::FileWatcher::Method::polling
                         : watch::FileWatcher::Method::events),
        stop_(stop),
        thread_([this] { run(); }) {}
  ~ChangeThread() {
    ended_ = true;
    thread_.join();
  }
  ChangeThread(const ChangeThread&) = delete;
  ChangeThread& operator=(const ChangeThread&) = delete;

  void watch(const std::vector<std::filesystem::path>& files) {
    const std::lock_guard lock(mutex_);
    files_ = files;
  }
  /// The work that the next change cancels.
  void set_work(std::shared_ptr<Progress> work) {
    const std::lock_guard lock(mutex_);
    work_ = std::move(work);
    if (changed_ || stop_.cancelled()) work_->cancel();
  }
  bool has_change() {
    const std::lock_guard lock(mutex_);
    return changed_.has_value();
  }
  /// Waits for a change and returns when it was noticed; nothing if the loop must end.
  std::optional<Clock::time_point> wait() {
    std::unique_lock lock(mutex_);
    while (!changed_ && !stop_.cancelled()) woken_.wait_for(lock, kStep);
    if (stop_.cancelled()) return std::nullopt;
    return std::exchange(changed_, std::nullopt);
  }

 private:
  static constexpr milliseconds kStep{50};   ///< Time after which `stop` is noticed.
  static constexpr milliseconds kQuiet{15};  ///< See watch::FileWatcher::wait.

  void run() {
    while (!ended_) {
      std::vector<std::filesystem::path> files;
      {
        const std::lock_guard lock(mutex_);
        files = files_;
        if (stop_.cancelled() && work_) work_->cancel();
      }
      watcher_.watch(files);
      const Clock::time_point begin = Clock::now();
      if (!watcher_.wait(kStep, kQuiet)) continue;
      const std::lock_guard lock(mutex_);
      changed_ = std::max(begin, Clock::now() - kQuiet - milliseconds(5));
      if (work_) work_->cancel();
      woken_.notify_all();
    }
  }

  watch::FileWatcher watcher_;
  const Progress& stop_;
  std::atomic<bool> ended_{false};
  std::mutex mutex_;
  std::condition_variable woken_;
  std::vector<std::filesystem::path> files_;
  std::shared_ptr<Progress> work_;
  std::optional<Clock::time_point> changed_;
  std::thread thread_;
};

}  // namespace

bool run_watch_loop(watch::LiveScene& scene, const WatchOptions& options, const WatchEvents& events,
                    const std::function<std::shared_ptr<Progress>()>& new_progress,
                    const Progress& stop) {
  ChangeThread changes(options.polling, stop);
  bool sound = false;
  for (std::optional<Clock::time_point> begin = Clock::now(); begin; begin = changes.wait()) {
    const auto seconds = [&] {
      return std::chrono::duration<double>(Clock::now() - *begin).count();
    };
    const std::shared_ptr<Progress> progress = new_progress();
    changes.set_work(progress);
    try {
      sound = scene.load(progress);
      changes.watch(scene.files());
      events.problems(scene.problems(), scene.report());
      if (!sound) {
        if (options.once) return false;
        continue;
      }
      const auto unfinished = [&](const image::Image& image, const picture::PictureOutput& output) {
        const render::PartialRenderHeader header;
        picture::PictureOutput plain = output;
        plain.settings.denoise = false;  // it would take longer than the stage
        const std::vector<picture::PictureView> views = {{image, header, plain}};
        events.picture({views, false, seconds(), scene.work()});
      };
      const std::vector<picture::RenderResult> rendered = scene.render({unfinished});
      events.picture({picture::picture_views(rendered), true, seconds(), scene.work()});
    } catch (const Error& error) {
      const bool is_new = changes.has_change() || stop.cancelled();
      if (error.code() == ErrorCode::cancelled && is_new) continue;
      if (options.once) throw;
      sound = false;
      Diagnostics problems;
      problems.add(error, {});
      events.problems(problems, scene.has_version() ? scene.loaded().report(problems)
                                                    : error.located_message() + "\n");
      changes.watch(scene.files());
    }
    if (options.once) return sound;
  }
  return sound;
}

}  // namespace vug::cli
