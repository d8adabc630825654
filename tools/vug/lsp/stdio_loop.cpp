// SPDX-License-Identifier: Apache-2.0
// Runs the server: one thread reads, this one answers, and a third one checks the scenes.
#include "lsp/stdio_loop.h"

#include "lsp/check_thread.h"
#include "lsp/framing.h"
#include "lsp/server.h"

#include <deque>
#include <istream>
#include <ostream>
#include <variant>

namespace vug::lsp {
namespace {

struct CheckDone {
  std::filesystem::path file;
  Diagnostics found;
};
struct EndOfInput {};
using Event = std::variant<std::string, CheckDone, EndOfInput>;

class EventQueue {
 public:
  void push(Event event) {
    {
      const std::lock_guard lock(mutex_);
      events_.push_back(std::move(event));
    }
    changed_.notify_one();
  }
  /// The next event; nothing after the time without one.
  std::optional<Event> pop(std::optional<std::chrono::milliseconds> time) {
    std::unique_lock lock(mutex_);
    const auto ready = [&] { return !events_.empty(); };
    if (!time)
      changed_.wait(lock, ready);
    else if (!changed_.wait_for(lock, *time, ready))
      return std::nullopt;
    Event event = std::move(events_.front());
    events_.pop_front();
    return event;
  }
  /// The ids of the requests that waiting messages cancel.
  std::vector<Json> cancellations() {
    const std::lock_guard lock(mutex_);
    std::vector<Json> ids;
    for (const Event& event : events_) {
      const auto* content = std::get_if<std::string>(&event);
      if (!content || content->find("$/cancelRequest") == std::string::npos) continue;
      const Json message = Json::parse(*content, nullptr, false);
      if (message.is_object() && message.value("method", Json()) == "$/cancelRequest" &&
          message.contains("params") && message["params"].is_object())
        ids.push_back(message["params"].value("id", Json()));
    }
    return ids;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Event> events_;
};

}  // namespace

int run_server(std::istream& in, std::ostream& out, const LoopOptions& options) {
  EventQueue events;
  Server server(options.workspace, [&](const Json& message) {
    write_message(out, message.dump(-1, ' ', false, Json::error_handler_t::replace));
  });
  CheckThread checks([&](const std::filesystem::path& file, const Diagnostics& found) {
    events.push(CheckDone{file, found});
  });
  std::thread reader([&] {
    while (auto content = read_message(in)) {
      const bool last = content->find("\"exit\"") != std::string::npos;
      const Json message = last ? Json::parse(*content, nullptr, false) : Json();
      events.push(std::move(*content));
      if (message.is_object() && message.value("method", Json()) == "exit") return;
    }
    events.push(EndOfInput{});
  });
  std::set<std::filesystem::path> stale;
  while (server.is_running()) {
    const auto wait = stale.empty() ? std::nullopt : std::optional(options.debounce);
    const std::optional<Event> event = events.pop(wait);
    if (!event) {
      checks.check(server.snapshot(), std::exchange(stale, {}));
      continue;
    }
    if (std::holds_alternative<EndOfInput>(*event)) break;
    if (const auto* done = std::get_if<CheckDone>(&*event)) {
      if (!stale.count(done->file)) server.publish(done->file, done->found);
      continue;
    }
    for (const Json& id : events.cancellations()) server.cancel(id);
    server.receive(std::get<std::string>(*event));
    const auto changed = server.take_stale();
    stale.insert(changed.begin(), changed.end());
  }
  reader.join();
  return server.exit_code();
}

}  // namespace vug::lsp
