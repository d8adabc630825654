// SPDX-License-Identifier: Apache-2.0
#include "image_case.h"

#include "diff_limits.h"
#include "process.h"

#include <fmt/format.h>
#include <vug/base/atomic_file.h>
#include <vug/base/diagnostics.h>
#include <vug/base/json_file.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <functional>
#include <map>

namespace vug::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Sets one member from the value of its key. Throws an Error with a one-sentence message.
using Reader = std::function<void(ImageCase&, const Json&)>;

[[noreturn]] void refuse(const std::string& what, const std::string& hint) {
  throw Error(ErrorCode::bad_input, what, {}, hint);
}

std::string text(const Json& value) {
  if (!value.is_string() || value.get<std::string>().empty())
    refuse("it is not a string", "write \"...\"");
  return value.get<std::string>();
}

std::vector<std::string> texts(const Json& value) {
  std::vector<std::string> out;
  if (!value.is_array()) refuse("it is not a list of strings", "write [\"...\", \"...\"]");
  for (const Json& each : value) out.push_back(text(each));
  return out;
}

double number(const Json& value, double low, double high) {
  if (!value.is_number() || !(value.get<double>() >= low) || !(value.get<double>() <= high))
    refuse(fmt::format("it is not a number from {} to {}", low, high),
           "see docs/guides/image_tests.md");
  return value.get<double>();
}

/// Turns {"size": "64x36", "spp": 64, "float": true, "D": ["LD=4"]} into command-line options. A
/// list of words is taken as it is.
std::vector<std::string> render_options(const Json& value) {
  if (value.is_array()) return texts(value);
  if (!value.is_object()) refuse("it is not an object", "write {\"size\": \"64x36\", \"spp\": 64}");
  std::vector<std::string> out;
  for (const auto& [key, given] : value.items()) {
    const std::string option = (key.size() == 1 ? "-" : "--") + key;
    if (given.is_boolean() && given.get<bool>()) out.push_back(option);
    if (given.is_boolean()) continue;
    for (const Json& each : given.is_array() ? given : Json::array({given})) {
      out.push_back(option);
      out.push_back(each.is_string() ? each.get<std::string>() : each.dump());
    }
  }
  return out;
}

const std::map<std::string, Reader>& readers() {
  static const std::map<std::string, Reader> all = {
      {"scene", [](ImageCase& c, const Json& v) { c.scene = c.folder / text(v); }},
      {"render", [](ImageCase& c, const Json& v) { c.render = render_options(v); }},
      {"command", [](ImageCase& c, const Json& v) { c.command = texts(v); }},
      {"reference", [](ImageCase& c, const Json& v) { c.reference = c.folder / text(v); }},
      {"mask", [](ImageCase& c, const Json& v) { c.mask = c.folder / text(v); }},
      {"layers", [](ImageCase& c, const Json& v) { c.diff.layers = texts(v); }},
      {"limits",
       [](ImageCase& c, const Json& v) {
         c.diff.limits = limits_of(v, (c.folder / "case.json").string());
       }},
      {"alarm",
       [](ImageCase& c, const Json& v) { c.diff.false_alarm_rate = number(v, 1e-9, 0.5); }},
      {"exposure", [](ImageCase& c, const Json& v) { c.diff.exposure = number(v, -30, 30); }},
      {"timeout", [](ImageCase& c, const Json& v) { c.timeout = number(v, 0.1, 1e6); }},
      {"note", [](ImageCase&, const Json& v) { text(v); }}};
  return all;
}

std::string replaced(std::string word, const std::string& mark, const std::string& by) {
  for (size_t at = 0; (at = word.find(mark, at)) != std::string::npos; at += by.size())
    word.replace(at, mark.size(), by);
  return word;
}

}  // namespace

std::vector<std::string> ImageCase::render_command(const std::filesystem::path& output, int threads,
                                                   std::optional<uint64_t> seed) const {
  const std::string program = current_executable().string();
  std::vector<std::string> out;
  if (!scene.empty()) {
    out = {program, "render", scene.lexically_normal().string(), "-o", output.string(), "--quiet"};
    out.insert(out.end(), {"--threads", std::to_string(threads)});
    out.insert(out.end(), render.begin(), render.end());
    if (seed) out.insert(out.end(), {"--sample-seed", std::to_string(*seed)});
    return out;
  }
  for (std::string word : command) {
    word = replaced(word, "{output}", output.string());
    word = replaced(word, "{seed}", std::to_string(seed.value_or(0)));
    out.push_back(replaced(word, "{vug}", program));
  }
  return out;
}

bool ImageCase::can_be_reseeded() const {
  return !scene.empty() || std::any_of(command.begin(), command.end(), [](const std::string& word) {
    return word.find("{seed}") != std::string::npos;
  });
}

ImageCase read_case(const std::filesystem::path& folder, const std::string& name) {
  ImageCase out;
  out.name = name;
  out.folder = std::filesystem::absolute(folder);
  out.reference = out.folder / "reference.exr";
  out.diff.layers = {image::kBeauty};
  const std::filesystem::path file = folder / "case.json";
  const Json json = read_json<Json>(file, "see docs/guides/image_tests.md");
  if (!json.is_object())
    throw Error(ErrorCode::bad_input, "a case must be a JSON object", {file.string(), 0, 0},
                "write {\"scene\": \"cave.vug\"}");
  std::vector<std::string> known;
  for (const auto& [key, reader] : readers()) known.push_back(key);
  for (const auto& [key, value] : json.items()) {
    const auto reader = readers().find(key);
    if (reader == readers().end())
      throw Error(ErrorCode::bad_input, fmt::format("'{}': unknown key '{}'", file.string(), key),
                  {}, suggestion(key, known));
    try {
      reader->second(out, value);
    } catch (const Error& error) {
      throw Error(error.code(), fmt::format("'{}': {}: {}", file.string(), key, error.what()), {},
                  error.hint());
    }
  }
  if (out.scene.empty() == out.command.empty())
    throw Error(
        ErrorCode::bad_input,
        fmt::format("'{}' names {}", file.string(),
                    out.scene.empty() ? "no scene and no command" : "a scene and a command"),
        {}, "write one of \"scene\" and \"command\"");
  const auto writes = [](const std::string& w) { return w.find("{output}") != std::string::npos; };
  if (!out.command.empty() && std::none_of(out.command.begin(), out.command.end(), writes))
    throw Error(ErrorCode::bad_input,
                fmt::format("the command in '{}' does not contain {{output}}", file.string()), {},
                "write {output} where the program expects the name of its output file");
  return out;
}

std::vector<CaseFolder> find_cases(const std::filesystem::path& root, const std::string& filter) {
  namespace fs = std::filesystem;
  if (!fs::is_directory(root))
    throw Error(ErrorCode::bad_input, fmt::format("'{}' is not a folder", root.string()), {},
                "name the folder that holds the cases");
  std::vector<CaseFolder> out;
  const auto add = [&](const fs::path& folder) {
    if (!fs::is_regular_file(folder / "case.json")) return;
    std::string name = fs::absolute(folder)
                           .lexically_normal()
                           .lexically_relative(fs::absolute(root).lexically_normal())
                           .generic_string();
    if (name == "." || name.empty())
      name = (fs::absolute(root) / "").parent_path().filename().string();
    if (name.find(filter) != std::string::npos) out.push_back({folder, name});
  };
  add(root);
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (entry.is_directory()) add(entry.path());
  std::sort(out.begin(), out.end(),
            [](const CaseFolder& a, const CaseFolder& b) { return a.name < b.name; });
  return out;
}

}  // namespace vug::cli
