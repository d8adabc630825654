// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/workbench/render_queue.h>
#include <vug/workbench/words.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace vug::workbench {
namespace {

namespace fs = std::filesystem;

/// The largest size of the messages of a program that are kept, in bytes.
constexpr size_t kMostMessages = 4000;

const std::string& name_of(RenderState state) {
  return render_state_names()[static_cast<size_t>(state)];
}

/// "render STATE SCENE RENDER OUTPUT ERROR [NAME=VALUE ...]"
std::string stored(const QueuedRender& render) {
  std::string out =
      fmt::format("render {} {} {} {} {}", name_of(render.state), quoted(render.scene.string()),
                  quoted(render.render), quoted(render.output.string()), quoted(render.error));
  for (const std::string& each : render.parameters) out += " " + quoted(each);
  return out + "\n";
}

/// Returns nothing for lines of other kinds.
std::optional<QueuedRender> read_stored(const std::string& line) {
  const std::vector<std::string> words = split_words(line);
  const auto& names = render_state_names();
  if (words.size() < 6 || words[0] != "render") return std::nullopt;
  const auto state = std::find(names.begin(), names.end(), words[1]);
  if (state == names.end()) return std::nullopt;
  QueuedRender out;
  out.state = static_cast<RenderState>(state - names.begin());
  out.scene = words[2], out.render = words[3], out.output = words[4], out.error = words[5];
  out.parameters.assign(words.begin() + 6, words.end());
  if (out.state == RenderState::running) out.state = RenderState::paused;
  return out;
}

/// The stage and the percentage of a line with a progress bar: "rendering   [===   ]  42% 3 s
/// left".
bool read_progress(const std::string& line, std::string& stage, double& fraction) {
  const size_t bar = line.find(" ["), end = line.find("] ", bar);
  if (bar == std::string::npos || end == std::string::npos) return false;
  char* after = nullptr;
  const double percent = std::strtod(line.c_str() + end + 1, &after);
  if (*after != '%') return false;
  stage = line.substr(0, line.find_last_not_of(' ', bar) + 1);
  fraction = std::clamp(percent / 100, 0.0, 1.0);
  return true;
}

}  // namespace

const std::vector<std::string>& render_state_names() {
  static const std::vector<std::string> names = {"waiting", "running", "paused",
                                                 "done",    "failed",  "cancelled"};
  return names;
}

fs::path QueuedRender::checkpoint() const { return output.string() + ".checkpoint"; }

std::vector<std::string> QueuedRender::arguments() const {
  std::vector<std::string> out = {"render", scene.string()};
  for (const std::string& each : parameters) out.insert(out.end(), {"-D", each});
  if (!render.empty()) out.insert(out.end(), {"--render", render});
  out.insert(out.end(), {"-o", output.string(), "--checkpoint", checkpoint().string(), "--resume",
                         "--progress"});
  return out;
}

RenderQueue::RenderQueue(const fs::path& folder) : file_(folder / "renders.vugqueue") {
  std::error_code fault;
  fs::create_directories(folder, fault);
  lock_ = ::open((folder / "renders.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (lock_ >= 0 && ::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    ::close(lock_);
    lock_ = -1;
  }
  if (lock_ >= 0 && fs::is_regular_file(file_, fault)) read();
}

RenderQueue::~RenderQueue() {
  if (lock_ >= 0) ::close(lock_);
}

void RenderQueue::read() {
  std::istringstream lines(read_text(file_));
  for (std::string line; std::getline(lines, line);)
    if (auto render = read_stored(line); render && render->state != RenderState::cancelled) {
      render->number = static_cast<int>(all_.size()) + 1;
      all_.push_back(std::move(*render));
    }
}

void RenderQueue::changed() {
  ++revision_;
  std::string text;
  for (const QueuedRender& each : all_) text += stored(each);
  write_text(file_, text);
}

QueuedRender& RenderQueue::render(int number) {
  for (QueuedRender& each : all_)
    if (each.number == number) return each;
  throw Error(ErrorCode::bad_input, fmt::format("the queue has no render {}", number), {},
              all_.empty() ? "add one first: queue_render OUTPUT.exr"
                           : fmt::format("the last one is {}", all_.back().number));
}

const QueuedRender& RenderQueue::find(int number) const {
  return const_cast<RenderQueue*>(this)->render(number);
}

int RenderQueue::add(QueuedRender added) {
  if (is_held_elsewhere())
    throw Error(ErrorCode::bad_input, "another window of vug-studio owns the queue of renders", {},
                "add the render there, or close that window");
  for (const QueuedRender& each : all_)
    if (each.state != RenderState::done && each.output == added.output)
      throw Error(ErrorCode::bad_input,
                  fmt::format("render {} of the queue already writes '{}'", each.number,
                              added.output.string()),
                  {}, "name another file, or cancel that render");
  added.number = all_.empty() ? 1 : all_.back().number + 1;
  added.state = RenderState::waiting;
  all_.push_back(std::move(added));
  changed();
  return all_.back().number;
}

void RenderQueue::pause(int number) {
  QueuedRender& paused = render(number);
  if (paused.state != RenderState::waiting && paused.state != RenderState::running)
    throw Error(ErrorCode::bad_input, fmt::format("render {} is {}", number, name_of(paused.state)),
                {}, "pause a render that waits or runs");
  paused.state = RenderState::paused;
  changed();
}

void RenderQueue::resume(int number) {
  QueuedRender& resumed = render(number);
  if (resumed.state != RenderState::paused && resumed.state != RenderState::failed)
    throw Error(ErrorCode::bad_input,
                fmt::format("render {} is {}, not paused", number, name_of(resumed.state)), {},
                "resume a render that is paused or has failed");
  resumed.state = RenderState::waiting;
  resumed.error.clear();
  changed();
}

void RenderQueue::cancel(int number) {
  QueuedRender& cancelled = render(number);
  if (number == active_) {  // Also a paused one, as long as its process writes the checkpoint.
    cancelled.state = RenderState::cancelled;
    return changed();
  }
  std::error_code ignored;
  if (cancelled.state != RenderState::done) fs::remove(cancelled.checkpoint(), ignored);
  all_.erase(all_.begin() + (&cancelled - all_.data()));
  changed();
}

std::optional<int> RenderQueue::next() const {
  for (const QueuedRender& each : all_)
    if (each.state == RenderState::running) return std::nullopt;
  for (const QueuedRender& each : all_)
    if (each.state == RenderState::waiting) return each.number;
  return std::nullopt;
}

void RenderQueue::started(int number) {
  QueuedRender& running = render(number);
  running.state = RenderState::running;
  active_ = number;
  running.stage.clear();
  running.fraction = 0;
  line_.clear();
  messages_.clear();
  changed();
}

void RenderQueue::take_line(QueuedRender& running, const std::string& line) {
  if (read_progress(line, running.stage, running.fraction) ||
      line.find_first_not_of(' ') == std::string::npos)
    return;
  messages_ += line + "\n";
  if (messages_.size() > kMostMessages) messages_.erase(0, messages_.size() - kMostMessages);
}

void RenderQueue::said(int number, std::string_view text) {
  QueuedRender& running = render(number);
  // The bar of an unfinished line is also shown: it ends when the next one replaces it.
  for (const char each : text) {
    if (each != '\r' && each != '\n') {
      line_ += each;
      continue;
    }
    take_line(running, line_);
    line_.clear();
  }
  read_progress(line_, running.stage, running.fraction);
  ++revision_;
}

void RenderQueue::ended(int number, int exit) {
  active_ = 0;
  QueuedRender& ended = render(number);
  take_line(ended, line_);
  line_.clear();
  ended.stage.clear();
  if (ended.state == RenderState::cancelled) {
    ended.state = RenderState::paused;  // no process writes its checkpoint any more
    return cancel(number);
  }
  if (ended.state == RenderState::running) {
    ended.state = exit == 0 ? RenderState::done : RenderState::failed;
    ended.fraction = exit == 0 ? 1 : ended.fraction;
    const size_t first = messages_.find("error:");
    if (exit != 0)
      ended.error = first != std::string::npos ? messages_.substr(first)
                    : exit < 0                 ? "error: the program was killed\n"
                               : fmt::format("error: the program ended with code {}\n", exit);
  }
  changed();
}

}  // namespace vug::workbench
