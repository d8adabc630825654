// SPDX-License-Identifier: Apache-2.0
#include "part_requests.h"

#include <fmt/format.h>
#include <vug/base/error.h>

#include <nlohmann/json.hpp>

namespace vug::cli {

using Json = nlohmann::ordered_json;

std::string to_line(const PartRequest& request) {
  return Json{{"part", request.part},
              {"samples", request.samples},
              {"checkpoint", request.checkpoint},
              {"log", request.log}}
      .dump();
}

PartRequest part_request(const std::string& line) try {
  const Json json = Json::parse(line);
  return {json.at("part").get<std::string>(), json.at("samples").get<std::string>(),
          json.value("checkpoint", ""), json.value("log", "")};
} catch (const nlohmann::json::exception& error) {
  throw Error(ErrorCode::bad_input,
              fmt::format("'{}' is not a request for a part: {}", line, error.what()), {},
              R"(write one line for each part: {"part": "FILE", "samples": "0..4"})");
}

std::string answer_line(int exit) { return Json{{"exit", exit}}.dump(); }

int exit_of_answer(const std::string& line) try {
  return Json::parse(line).at("exit").get<int>();
} catch (const nlohmann::json::exception&) {
  throw Error(ErrorCode::io, fmt::format("'{}' is not the answer of a render process", line), {},
              "see the log of the task");
}

}  // namespace vug::cli
