// SPDX-License-Identifier: Apache-2.0
// For any bytes: edits a scene as they say and sends a request after each edit. Every request has
// one answer, which is not an internal error, and the text of the server is that of the edits.
#include "lsp/server.h"
#include "require.h"
#include "target.h"

#include <vug/scene/lexer.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace vug;
using lsp::Json;

constexpr const char* kScenes[] = {
    R"(param voxel = 4cm in 1cm..50cm "edge"
let radius = 10 * voxel  # of the ball
def ball(size, hole = 0.2 * size) "hollow" = difference(sphere(size), [sphere(hole)]) where k = 1
volume rock = level_set(ball(radius).translate((0, 1, 0)), voxel: voxel)
mesh skin on rock { paint (0.5, 0.2, 0.1)  smooth 3 }
camera main { kind orthographic  eye (0, 1, 4)  target (0, 0, 0) }
light lamp[i in 0..3] = sphere(center: (i, 3, 0), radiance: srgb("#c0a080"))
)",
    R"(grammar cave {
  label random
  axiom Room*3
  Room -> + sphere(0.5..1m) Hall(2) label +X
  Hall(n) @ 2 if n > 0 -> - box() ~30% sphere(1m) Hall(m) where m = n - 1
  Hall(n) -> nothing
}
include "part.vug" as part { size 3m }
variant tall { part.size 4m }
)",
    R"(grammar plant: lsystem {
  steps 3
  axiom FA(1)
  ignore + -
  table spring { A(x) < B > F -> F[+B]A(x + 1) }
  schedule spring*2
  B -> FfFl{.F.}
  interpret { F -> f }
}
grammar front: facade {
  axiom Wall
  Wall -> rows([Floor: 3m, Floor: 1])
  Floor -> window(width: 1m)
}
)"};

constexpr const char* kPieces[] = {"(",
                                   ")",
                                   "{",
                                   "}",
                                   "[",
                                   "]",
                                   ",",
                                   ":",
                                   "\"",
                                   "#",
                                   "\n",
                                   "\r\n",
                                   ".",
                                   "..",
                                   "->",
                                   " = ",
                                   "= 3cm",
                                   "let a",
                                   "param b = ",
                                   "sphere(",
                                   "radius: ",
                                   "level_set(",
                                   "part.",
                                   "camera c {",
                                   " on ",
                                   "grammar g {",
                                   "axiom ",
                                   "where ",
                                   "include \"part.vug\"",
                                   "for i in ",
                                   "@",
                                   "*",
                                   "\xc3\xa4",
                                   "\xf0\x9f\xa7\x8a",
                                   "\t",
                                   "\xff",
                                   ";",
                                   "12",
                                   "cm",
                                   "if(",
                                   "by rock { ",
                                   "-",
                                   "voxel",
                                   "A(",
                                   "table t {",
                                   "srgb(\"#",
                                   "}\n\n",
                                   "\xef\xbb\xbf"};

constexpr const char* kMethods[] = {
    "completion",        "hover",         "signatureHelp",    "definition", "references",
    "documentHighlight", "prepareRename", "rename",           "formatting", "documentSymbol",
    "foldingRange",      "documentColor", "documentLink",     "inlayHint",  "semanticTokens/full",
    "codeAction",        "codeLens",      "colorPresentation"};

constexpr const char* kUri = "file:///nowhere/main.vug";

class Session {
 public:
  Session() : server_({}, [this](const Json& message) { receive(message); }) {
    request("initialize", {{"capabilities", Json::object()}});
  }
  void open(const std::string& uri, const std::string& text) {
    notify("textDocument/didOpen",
           {{"textDocument", {{"uri", uri}, {"version", 1}, {"text", text}}}});
  }
  void notify(const std::string& method, const Json& params) {
    server_.receive(text_of({{"jsonrpc", "2.0"}, {"method", method}, {"params", params}}));
  }
  void request(const std::string& method, const Json& params) {
    answered_ = 0;
    server_.receive(
        text_of({{"jsonrpc", "2.0"}, {"id", ++id_}, {"method", method}, {"params", params}}));
    require(answered_ == 1, "a request has one answer");
  }

 private:
  static std::string text_of(const Json& message) {
    return message.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  void receive(const Json& message) {
    if (!message.contains("id")) return;
    require(message["id"] == id_, "an answer has the id of its request");
    require(!message.contains("error") || message["error"]["code"] != lsp::kInternalError,
            "an answer is not an internal error");
    text_of(message);
    ++answered_;
  }

  lsp::Server server_;
  int id_ = 0;
  int answered_ = 0;
};

Json position(int line, int character) { return {{"line", line}, {"character", character}}; }

/// The parameters that any of the methods needs.
Json request_params(int line, int character) {
  const Json at = position(line, character);
  return {{"textDocument", {{"uri", kUri}}},
          {"position", at},
          {"context", {{"includeDeclaration", true}, {"diagnostics", Json::array()}}},
          {"newName", "renamed"},
          {"options", Json::object()},
          {"color", {{"red", 0.5}, {"green", 0.2}, {"blue", 1}, {"alpha", 1}}},
          {"range", {{"start", at}, {"end", position(line + 3, character)}}}};
}

}  // namespace

VUG_FUZZ_TARGET(lsp) {
  if (size == 0) return;
  Session session;
  session.open("file:///nowhere/part.vug",
               "param size = 2m\ndef slab(h) = box(size: (1m, h, size))\n");
  session.open(kUri, kScenes[data[0] % std::size(kScenes)]);
  constexpr size_t kBytes = 5;
  for (size_t at = 1; at + kBytes <= size; at += kBytes) {
    const int line = data[at] % 16, character = data[at + 1] % 64, removed = data[at + 2] % 8;
    const bool keeps = data[at + 2] >= 128;
    const Json begin = position(line, character);
    const Json end =
        removed == 7 ? position(line + 1, 0) : position(line, character + (keeps ? 0 : removed));
    session.notify("textDocument/didChange",
                   {{"textDocument", {{"uri", kUri}, {"version", 2}}},
                    {"contentChanges",
                     {{{"range", {{"start", begin}, {"end", end}}},
                       {"text", kPieces[data[at + 3] % std::size(kPieces)]}}}}});
    session.request(std::string("textDocument/") + kMethods[data[at + 4] % std::size(kMethods)],
                    request_params(line, character + 1));
  }
  session.request("shutdown", Json::object());
}
