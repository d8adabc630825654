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
  /// Another thread wants a look: cancels the work.
  void interrupt() {
    const std::lock_guard lock(mutex_);
    if (work_ && !looking_) work_->cancel();
    woken_.notify_all();
  }
  /// While `looking`, only changes cancel the work.
  void set_looking(bool looking) {
    const std::lock_guard lock(mutex_);
    looking_ = looking;
  }
  /// Waits at most `time` for a change, until `is_awake` or the end. `is_awake` may take locks.
  template <class IsAwake>
  void wait(milliseconds time, const IsAwake& is_awake) {
    constexpr milliseconds kTurn{20};
    const Clock::time_point end = Clock::now() + time;
    while (!is_awake() && !stop_.cancelled() && Clock::now() < end) {
      std::unique_lock lock(mutex_);
      if (changed_) return;
      woken_.wait_for(lock, kTurn);
    }
  }
  /// When the last change was noticed; nothing if there is none.
  std::optional<Clock::time_point> take_change() {
    const std::lock_guard lock(mutex_);
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
  bool looking_ = false;
  std::optional<Clock::time_point> changed_;
  std::thread thread_;
};

}  // namespace

bool run_watch_loop(watch::LiveScene& scene, const WatchOptions& options, const WatchEvents& events,
                    const std::function<std::shared_ptr<Progress>()>& new_progress,
                    LookRequests& looks, const Progress& stop) {
  ChangeThread changes(options.polling, stop);
  changes.watch(scene.files());
  looks.on_request([&] { changes.interrupt(); });
  const std::shared_ptr<void> closing(nullptr, [&](void*) { looks.close(); });
  bool sound = false;
  /// Loads and renders; false if a look or a change came first.
  const auto render = [&](Clock::time_point begin) {
    const auto seconds = [&] {
      return std::chrono::duration<double>(Clock::now() - begin).count();
    };
    const std::shared_ptr<Progress> progress = new_progress();
    changes.set_work(progress);
    if (looks.has_request() && scene.has_version()) return false;
    try {
      sound = scene.load(progress);
      changes.watch(scene.files());
      events.problems(scene.problems(), scene.report());
      if (!sound) return true;
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
      if (error.code() == ErrorCode::cancelled && progress->cancelled()) return false;
      if (options.once) throw;
      sound = false;
      Diagnostics problems;
      problems.add(error, {});
      events.problems(problems, scene.has_version() ? scene.loaded().report(problems)
                                                    : error.located_message() + "\n");
      changes.watch(scene.files());
    }
    return true;
  };
  const auto look = [&] {
    const auto progress = std::make_shared<Progress>();
    changes.set_looking(true);
    changes.set_work(progress);
    try {
      looks.answer([&](const watch::ViewRequest& wanted) {
        return scene.has_version() ? scene.look(wanted, progress) : std::string();
      });
    } catch (const Error&) {  // the browser asks again; errors of the scene have been reported
    }
    changes.set_looking(false);
  };
  constexpr milliseconds kLooking{400};  // after the last look, the picture continues
  constexpr milliseconds kLong{3600000};
  Clock::time_point begin = Clock::now();
  while (!stop.cancelled()) {
    const bool complete = render(begin);
    if (options.once && complete) return sound;
    while (!stop.cancelled()) {
      if (const auto changed = changes.take_change()) {
        begin = *changed;
        break;
      }
      if (looks.has_request()) {
        look();
        continue;
      }
      changes.wait(complete ? kLong : kLooking, [&] { return looks.has_request(); });
      if (!complete && !looks.has_request()) break;
    }
  }
  return sound;
}

}  // namespace vug::cli
