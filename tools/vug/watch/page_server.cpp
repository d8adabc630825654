// SPDX-License-Identifier: Apache-2.0
#include "watch/page_server.h"
#include "watch/page_files.h"

#include <fmt/format.h>
#include <httplib.h>
#include <vug/base/error.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <random>
#include <thread>

namespace vug::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kThreads = 32;

/// 128 random bits.
std::string random_token() {
  std::random_device random;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", random());
  return token;
}

void add_headers(httplib::Response& response) {
  response.set_header(
      "Content-Security-Policy",
      "default-src 'none'; img-src 'self' blob:; script-src 'self'; style-src 'self'; "
      "connect-src 'self'; base-uri 'none'; form-action 'none'; "
      "frame-ancestors 'none'");
  response.set_header("X-Content-Type-Options", "nosniff");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("Cache-Control", "no-store");
}

Json list_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// The options of a request for a look; nothing if it is invalid.
std::optional<watch::ViewRequest> look_options(const httplib::Request& request) {
  bool valid = true;
  const auto number = [&](const char* name, double low, double high) {
    const std::string text = request.get_param_value(name);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool usable = !text.empty() && *end == '\0' && value >= low && value <= high;
    valid = valid && usable;
    return usable ? value : low;  // any one that fits into an int
  };
  const auto point = [&](const std::string& name) {
    const auto axis = [&](char letter) { return number((name + letter).c_str(), -1e7, 1e7); };
    const double x = axis('x'), y = axis('y'), z = axis('z');
    return Vec3d(x, y, z);
  };
  watch::ViewRequest look;
  viewport::View& view = look.view;
  view.eye = point("e");
  view.target = point("t");
  view.fov = number("fov", 0.01, 3);
  look.width = static_cast<int>(number("w", 16, 960));
  look.height = static_cast<int>(number("h", 16, 960));
  if (request.get_param_value("clay") == "1") look.mode = viewport::Mode::clay;
  valid = valid && (view.eye - view.target).length() > 1e-6;
  return valid ? std::optional(look) : std::nullopt;
}

std::string json_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

struct PageServer::State {
  State(std::string name, Look make) : title(std::move(name)), look(std::move(make)) {}

  /// All that the page shows, with the number of the picture, which its address contains.
  std::string json() const {
    return json_text({{"title", title},
                      {"number", number},
                      {"complete", status.complete},
                      {"seconds", status.seconds},
                      {"work", status.work},
                      {"camera", status.camera},
                      {"eye", list_of(status.view.eye)},
                      {"target", list_of(status.view.target)},
                      {"fov", status.view.fov},
                      {"problems", problems}});
  }
  /// Sends the state to a browser whenever it has changed, until the browser or the server ends.
  bool send_events(httplib::DataSink& sink) {
    constexpr std::chrono::seconds kSilence{2};  // after which a closed browser is noticed
    uint64_t sent = 0;
    while (true) {
      std::string text = ":\n\n";
      {
        std::unique_lock lock(mutex);
        changed.wait_for(lock, kSilence, [&] { return ended || version != sent; });
        if (ended) return false;
        if (version != sent) text = fmt::format("data: {}\n\n", json());
        sent = version;
      }
      if (!sink.is_writable() || !sink.write(text.data(), text.size())) return false;
    }
  }

  const std::string title;
  const Look look;
  std::mutex mutex;
  std::condition_variable changed;
  bool ended = false;
  uint64_t version = 1;  ///< Increases with each change.
  uint64_t number = 0;   ///< The number of the picture; 0: none.
  std::string png;
  PageStatus status;
  Json problems = Json::array();
  httplib::Server server;
  std::thread thread;
  std::atomic<bool> listening_ended = false;
};

PageServer::PageServer(int port, std::string title, Look look)
    : state_(std::make_unique<State>(std::move(title), std::move(look))) {
  State& state = *state_;
  httplib::Server& server = state.server;
  const char* const address = "127.0.0.1";
  // The events of each open page occupy a thread.
  server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
  server.set_socket_options([](socket_t socket) {  // the port is not shared with other processes
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
  if (port == 0)
    port = server.bind_to_any_port(address);
  else if (!server.bind_to_port(address, port))
    port = -1;
  if (port < 0)
    throw Error(ErrorCode::io, "the port of the page cannot be used", {},
                "choose another one with --port, or none with --no-page");
  const std::string root = "/" + random_token() + "/";
  url_ = fmt::format("http://{}:{}{}", address, port, root);
  server.set_pre_routing_handler(
      [port](const httplib::Request& request, httplib::Response& response) {
        add_headers(response);
        const std::string host = request.get_header_value("Host");
        const bool known =
            host == fmt::format("127.0.0.1:{}", port) || host == fmt::format("localhost:{}", port);
        if (known && request.method == "GET") return httplib::Server::HandlerResponse::Unhandled;
        response.status = 403;
        response.set_content("403\n", "text/plain");
        return httplib::Server::HandlerResponse::Handled;
      });
  for (const PageFile& file : kPageFiles)
    server.Get(root + file.name, [&file](const httplib::Request&, httplib::Response& response) {
      response.set_content(file.text, file.type);
    });
  server.Get(root + "picture.png", [&state](const httplib::Request&, httplib::Response& response) {
    const std::lock_guard lock(state.mutex);
    if (state.number == 0)
      response.status = 404;
    else
      response.set_content(state.png, "image/png");
  });
  server.Get(root + "look.png",
             [&state](const httplib::Request& request, httplib::Response& response) {
               const auto wanted = look_options(request);
               const std::string png = wanted ? state.look(*wanted) : "";
               if (png.empty())
                 response.status = wanted ? 503 : 404;
               else
                 response.set_content(png, "image/png");
             });
  server.Get(root + "state.json", [&state](const httplib::Request&, httplib::Response& response) {
    const std::lock_guard lock(state.mutex);
    response.set_content(state.json(), "application/json");
  });
  server.Get(root + "events", [&state](const httplib::Request&, httplib::Response& response) {
    response.set_chunked_content_provider(
        "text/event-stream",
        [&state](size_t, httplib::DataSink& sink) { return state.send_events(sink); });
  });
  state.thread = std::thread([&state] {
    state.server.listen_after_bind();
    state.listening_ended = true;
  });
  while (!server.is_running()) {
    if (state.listening_ended) {
      state.thread.join();
      throw Error(ErrorCode::io, fmt::format("the page cannot be served at port {}", port), {},
                  "give another port with --port, or use --no-page");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

PageServer::~PageServer() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->ended = true;
  }
  state_->changed.notify_all();
  state_->server.stop();
  state_->thread.join();
}

void PageServer::show_picture(std::string png, const PageStatus& status) {
  {
    const std::lock_guard lock(state_->mutex);
    state_->png = std::move(png);
    state_->status = status;
    ++state_->number, ++state_->version;
  }
  state_->changed.notify_all();
}

void PageServer::show_problems(const Diagnostics& problems) {
  Json list = Json::array();
  for (const Diagnostic& each : problems.all())
    list.push_back({{"error", each.severity == Severity::error},
                    {"where", each.where.known() ? to_string(each.where) : ""},
                    {"message", each.message},
                    {"hint", each.hint}});
  {
    const std::lock_guard lock(state_->mutex);
    state_->problems = std::move(list);
    ++state_->version;
  }
  state_->changed.notify_all();
}

}  // namespace vug::cli
