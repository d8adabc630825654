// SPDX-License-Identifier: Apache-2.0
#include "lsp/server.h"

#include <fmt/format.h>

namespace vug::lsp {

Server::Server(language::WorkspaceOptions options, Send send)
    : session_(std::move(options)), send_(std::move(send)) {}

void Server::reply(const Json& id, Json result) {
  send_({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
}

void Server::fail(const Json& id, int code, const std::string& message) {
  send_({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", message}}}});
}

void Server::receive(const std::string& content) {
  const Json message = Json::parse(content, nullptr, false);
  if (message.is_discarded())
    return fail(nullptr, kParseError,
                "the message is not valid JSON after a Content-Length header");
  if (!message.is_array()) return handle(message);
  if (message.empty()) return fail(nullptr, kInvalidRequest, "the batch is empty");
  for (const Json& each : message) handle(each);
}

void Server::handle(const Json& message) {
  const bool object = message.is_object();
  const Json id = object && message.contains("id") ? message["id"] : Json();
  const bool has_method = object && message.contains("method") && message["method"].is_string();
  if (!has_method) {
    const bool response = object && (message.contains("result") || message.contains("error"));
    if (!response) fail(id, kInvalidRequest, "a request is an object with a text 'method'");
    return;
  }
  if (!id.is_null() && !id.is_number_integer() && !id.is_string())
    return fail(nullptr, kInvalidRequest, "the id of a request is a number or a text");
  const std::string method = message["method"];
  const Json params = message.contains("params") ? message["params"] : Json::object();
  const bool request = !id.is_null();
  try {
    if (!request) return notify(method, params);
    if (cancelled_.erase(id.dump()) > 0)
      return fail(id, kRequestCancelled, "the client has cancelled the request");
    reply(id, answer(method, params));
  } catch (const RequestError& error) {
    if (request) fail(id, error.code, error.message);
  } catch (const Error& error) {
    const std::string hint = error.hint().empty() ? "" : "; " + error.hint();
    if (request) fail(id, kRequestFailed, error.what() + hint);
  } catch (const Json::exception& error) {
    if (request) fail(id, kInvalidParams, fmt::format("unsuitable parameters: {}", error.what()));
  } catch (const std::exception& error) {
    if (request) fail(id, kInternalError, error.what());
  }
}

Json Server::answer(const std::string& method, const Json& params) {
  if (shut_down_) throw RequestError{kInvalidRequest, "the server has been shut down"};
  if (method == "initialize") return initialize(params);
  if (!initialized_) throw RequestError{kNotInitialized, "the first request must be 'initialize'"};
  if (method == "shutdown") {
    shut_down_ = true;
    return nullptr;
  }
  const auto known = answers().find(method);
  if (known == answers().end())
    throw RequestError{kMethodNotFound, fmt::format("unknown method '{}'", method)};
  return known->second(session_, params);
}

void Server::notify(const std::string& method, const Json& params) {
  if (method == "exit") {
    exit_code_ = shut_down_ ? 0 : 1;
    return;
  }
  if (method == "$/cancelRequest" && params.contains("id")) return;  // see cancel()
  if (!initialized_ || shut_down_) return;
  Documents& documents = session_.documents;
  if (method == "textDocument/didOpen") {
    documents.open(params);
    mark_dependents_stale();
  } else if (method == "textDocument/didChange") {
    documents.change(params);
    mark_dependents_stale();
  } else if (method == "textDocument/didClose") {
    const std::filesystem::path file = documents.close(params);
    for (const Json& each : session_.published.remove(documents, file)) send_(each);
    mark_dependents_stale();
  }
}

/// Every open document may include the one that changed; a check of an unchanged one is repeated.
void Server::mark_dependents_stale() {
  for (const auto& [file, document] : session_.documents.all()) stale_.insert(file);
}

std::set<std::filesystem::path> Server::take_stale() { return std::exchange(stale_, {}); }

void Server::publish(const std::filesystem::path& document, const Diagnostics& found) {
  if (!session_.documents.all().count(document)) return;
  for (const Json& each : session_.published.update(session_.documents, document, found))
    send_(each);
}

language::AnalysisPtr Session::analysis(const Json& params) const {
  const std::string uri = params.at("textDocument").at("uri");
  for (const auto& [file, document] : documents.all())
    if (document.uri == uri) return documents.workspace().analyse(file);
  throw RequestError{kInvalidParams, fmt::format("the document '{}' is not open", uri)};
}

language::Position Session::position(const language::Analysis& analysis, const Json& params) const {
  return documents.position(analysis.file, params.at("position"));
}

}  // namespace vug::lsp
