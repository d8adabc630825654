// SPDX-License-Identifier: Apache-2.0
#include "watch/page_server.h"
#include "watch/page_files.h"

#include <fmt/format.h>
#include <httplib.h>
#include <vug/base/error.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <random>
#include <thread>

namespace vug::cli {
namespace {

using Json = nlohmann::ordered_json;

/// 128 random bits.
std::string random_token() {
  std::random_device random;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", random());
  return token;
}

void add_headers(httplib::Response& response) {
  response.set_header("Content-Security-Policy",
                      "default-src 'none'; img-src 'self'; script-src 'self'; style-src 'self'; "
                      "connect-src 'self'; base-uri 'none'; form-action 'none'; "
                      "frame-ancestors 'none'");
  response.set_header("X-Content-Type-Options", "nosniff");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("Cache-Control", "no-store");
}

std::string json_text(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

struct PageServer::State {
  explicit State(std::string name) : title(std::move(name)) {}

  /// All that the page shows, with the number of the picture, which its address contains.
  std::string json() const {
    return json_text({{"title", title},
                      {"number", number},
                      {"complete", status.complete},
                      {"seconds", status.seconds},
                      {"work", status.work},
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
};

PageServer::PageServer(int port, std::string title)
    : state_(std::make_unique<State>(std::move(title))) {
  State& state = *state_;
  httplib::Server& server = state.server;
  const char* const address = "127.0.0.1";
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
  server.Get(root + "state.json", [&state](const httplib::Request&, httplib::Response& response) {
    const std::lock_guard lock(state.mutex);
    response.set_content(state.json(), "application/json");
  });
  server.Get(root + "events", [&state](const httplib::Request&, httplib::Response& response) {
    response.set_chunked_content_provider(
        "text/event-stream",
        [&state](size_t, httplib::DataSink& sink) { return state.send_events(sink); });
  });
  state.thread = std::thread([&server] { server.listen_after_bind(); });
  while (!server.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
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
