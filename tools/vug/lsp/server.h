// SPDX-License-Identifier: Apache-2.0
// The language server: answers the messages of a client, one after the other. It does not read,
// write or start threads itself.
#pragma once

#include "lsp/diagnostics.h"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

namespace vug::lsp {

/// Error codes of JSON-RPC 2.0 and of the Language Server Protocol.
enum ErrorNumber : int {
  kParseError = -32700,
  kInvalidRequest = -32600,
  kMethodNotFound = -32601,
  kInvalidParams = -32602,
  kInternalError = -32603,
  kNotInitialized = -32002,
  kRequestCancelled = -32800,
  kRequestFailed = -32803
};

/// A failure that the client sees as an error of its request.
struct RequestError {
  int code = kRequestFailed;
  std::string message;
};

/// The state that answers depend on.
struct Session {
  explicit Session(language::WorkspaceOptions options) : documents(std::move(options)) {}

  Documents documents;
  PublishedDiagnostics published;
  bool snippets = false;  ///< The client fills in fields of completions.

  /// The analysis of the document in the parameters of a request.
  language::AnalysisPtr analysis(const Json& params) const;
  language::Position position(const language::Analysis& analysis, const Json& params) const;
};

/// Answers a request; throws RequestError, vug::Error or Json::exception for unsuitable parameters.
using Answer = std::function<Json(Session&, const Json& params)>;
/// The answers by method; each file adds its own.
using Answers = std::map<std::string, Answer>;
const Answers& answers();
void add_navigation(Answers& answers);
void add_editing(Answers& answers);
void add_structure(Answers& answers);
/// The result of `initialize`.
Json capabilities(const Session& session);

class Server {
 public:
  /// Receives each message for the client.
  using Send = std::function<void(const Json&)>;

  Server(language::WorkspaceOptions options, Send send);

  /// Handles the content of one message: a request, a notification or a batch.
  void receive(const std::string& content);
  /// A request of this id that has not been answered is answered with an error.
  void cancel(const Json& id) { cancelled_.insert(id.dump()); }

  /// Documents whose diagnostics are out of date, and forgets them.
  std::set<std::filesystem::path> take_stale();
  /// The texts as they are now, for a check in another thread.
  language::Workspace snapshot() const { return session_.documents.workspace(); }
  /// Publishes the result of a check, unless the document has been closed.
  void publish(const std::filesystem::path& document, const Diagnostics& found);

  bool is_running() const { return !exit_code_; }
  /// 0 if `exit` followed `shutdown`, else 1.
  int exit_code() const { return exit_code_.value_or(1); }

 private:
  void handle(const Json& message);
  Json answer(const std::string& method, const Json& params);
  void notify(const std::string& method, const Json& params);
  Json initialize(const Json& params);
  void mark_dependents_stale();
  void reply(const Json& id, Json result);
  void fail(const Json& id, int code, const std::string& message);

  Session session_;
  Send send_;
  std::set<std::string> cancelled_;
  std::set<std::filesystem::path> stale_;
  bool initialized_ = false;
  bool shut_down_ = false;
  std::optional<int> exit_code_;
};

}  // namespace vug::lsp
