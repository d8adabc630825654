// SPDX-License-Identifier: Apache-2.0
#include <vug/base/json_value.h>
#include <vug/base/pluralize.h>
#include <vug/modeller/session.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace vug::modeller {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "vug facade session";
constexpr int kVersion = 1;

Photo read_photo(const JsonValue& from) {
  from.check_object({"file", "pixels", "scale"});
  Photo out;
  out.file = from.at("file").text();
  if (from.has("pixels")) {
    const JsonValue pixels = from.at("pixels");
    std::vector<uint64_t> sizes;
    for (const JsonValue& each : pixels.items()) sizes.push_back(each.unsigned_integer());
    if (sizes.size() != 2 || std::min(sizes[0], sizes[1]) < 1 ||
        std::max(sizes[0], sizes[1]) > 1000000)
      throw pixels.fault("invalid picture size: expected a width and a height in pixels",
                         "such as [640, 480]");
    out.width = static_cast<int>(sizes[0]);
    out.height = static_cast<int>(sizes[1]);
  }
  if (from.has("scale")) {
    out.scale = from.at("scale").number();
    if (!(out.scale > 0))
      throw from.at("scale").fault("the pixel size must be above 0", "in metres");
    if (out.width == 0)
      throw from.fault("'pixels' is missing", "a scale alone does not determine the size");
  }
  return out;
}

void check_format(const JsonValue& root) {
  root.check_object();
  if (!root.has("format") || root.at("format").json() != kFormat)
    throw root.fault("this is not a facade session", fmt::format("\"format\": \"{}\"", kFormat),
                     "format");
  const uint64_t version = root.at("version").unsigned_integer();
  if (version != kVersion)
    throw root.fault(fmt::format("unsupported session version {}", version),
                     fmt::format("this program reads version {}", kVersion), "version");
  root.check_object({"format", "version", "grammar", "facade", "width", "height", "photo", "least",
                     "seed", "edits", "done", "checkpoints"});
}

SessionHeader read_header(const JsonValue& root) {
  SessionHeader out;
  out.grammar = root.at("grammar").text();
  if (root.has("facade")) out.facade = root.at("facade").text();
  const auto length = [&](const char* name) -> std::optional<double> {
    if (!root.has(name)) return std::nullopt;
    const double value = root.at(name).number();
    if (!(value > 0) || !(value < 1e6))
      throw root.at(name).fault(fmt::format("invalid '{}': {}", name, value),
                                "must be above 0 m and below 1000 km");
    return value;
  };
  out.width = length("width");
  out.height = length("height");
  out.min_size = length("least").value_or(out.min_size);
  if (root.has("photo")) out.photo = read_photo(root.at("photo"));
  if (root.has("seed")) out.seed = root.at("seed").unsigned_integer();
  return out;
}

Edit read_edit(const JsonValue& from) {
  from.check_object({"edit", "node", "rule", "numbers"});
  Edit out;
  out.kind = from.at("edit").text();
  out.node = from.at("node").text();
  if (from.has("rule")) out.rule = from.at("rule").text();
  if (!from.has("numbers")) return out;
  const JsonValue numbers = from.at("numbers");
  numbers.check_object();
  for (const auto& [name, value] : numbers.json().items()) {
    const JsonValue one = numbers.at(name);
    std::vector<double>& list = out.numbers[name];
    if (!value.is_array())
      list = {one.number()};
    else
      for (const JsonValue& each : one.items()) list.push_back(each.number());
  }
  return out;
}

void read_edits(const JsonValue& root, History& history) {
  const std::vector<JsonValue> edits = root.at("edits").items();
  size_t done = edits.size();
  if (root.has("done")) {
    if (root.at("done").unsigned_integer() > done)
      throw root.at("done").fault("the session has " + pluralize(done, "edit"));
    done = root.at("done").unsigned_integer();
  }
  std::map<size_t, std::vector<std::string>> checkpoints;
  if (root.has("checkpoints")) {
    const JsonValue all = root.at("checkpoints");
    all.check_object();
    for (const auto& [name, value] : all.json().items()) {
      const JsonValue one = all.at(name);
      if (name.empty()) throw one.fault("a checkpoint needs a name");
      if (one.unsigned_integer() > edits.size())
        throw one.fault("the session has " + pluralize(edits.size(), "edit"));
      checkpoints[one.unsigned_integer()].push_back(name);
    }
  }
  for (size_t i = 0;; ++i) {
    for (const std::string& name : checkpoints[i]) history.set_checkpoint(name);
    if (i == edits.size()) break;
    const Edit edit = read_edit(edits[i]);
    try {
      history.apply(edit);
    } catch (const RejectedEdit& rejected) {
      throw edits[i].fault(rejected.what(), rejected.hint(), rejected.key());
    }
  }
  history.undo(edits.size() - done);
}

Canvas canvas_of(const SessionHeader& header, const Style& style) {
  Canvas out;
  const std::optional<Photo>& photo = header.photo;
  const bool scaled = photo && photo->scale > 0 && photo->width > 0;
  const auto size = [&](const char* name, const std::optional<double>& given, int pixels,
                        const std::optional<double>& usual) {
    if (given) return *given;
    if (scaled) return pixels * photo->scale;
    if (!usual)
      throw Error(ErrorCode::bad_input, fmt::format("the facade's {} is unknown", name), {},
                  fmt::format("give '{}' in metres, or a photo's pixels and scale", name));
    return *usual;
  };
  out.width = size("width", header.width, scaled ? photo->width : 0, style.usual_width());
  out.height = size("height", header.height, scaled ? photo->height : 0, style.usual_height());
  out.min_size = header.min_size;
  out.seed = header.seed;
  return out;
}

/// Integers are written without a decimal point.
Json json_of(double number) {
  if (number == std::floor(number) && std::abs(number) < 1e15)
    return Json(static_cast<int64_t>(number));
  return Json(number);
}

Json json_of(const Edit& edit) {
  Json out = {{"edit", edit.kind}, {"node", edit.node}};
  if (!edit.rule.empty()) out["rule"] = edit.rule;
  for (const auto& [name, values] : edit.numbers) {
    Json list = Json::array();
    for (const double value : values) list.push_back(json_of(value));
    out["numbers"][name] = values.size() == 1 ? list[0] : list;
  }
  return out;
}

}  // namespace

double Session::metres_per_pixel() const {
  if (!header.photo) return 0;
  if (header.photo->scale > 0) return header.photo->scale;
  return header.photo->width > 0 ? current().canvas().width / header.photo->width : 0;
}

Session new_session(SessionHeader header, const StyleLoader& load) {
  const StylePtr style = load(header.grammar, header.facade);
  const Canvas canvas = canvas_of(header, *style);
  return {std::move(header), History(FacadeState(style, canvas))};
}

Session read_session(const std::string& text, const std::string& file, const StyleLoader& load) {
  const Json json = JsonValue::parse(text, file);
  const JsonValue root(json, text, file);
  check_format(root);
  const SessionHeader header = read_header(root);
  const StylePtr style = [&] {
    try {
      return load(header.grammar, header.facade);
    } catch (const Error& error) {
      if (error.where().known()) throw;
      throw root.fault(error.what(), error.hint(), header.facade.empty() ? "grammar" : "facade");
    }
  }();
  try {
    Session out{header, History(FacadeState(style, canvas_of(header, *style)))};
    read_edits(root, out.history);
    return out;
  } catch (const Error& error) {
    if (error.where().known()) throw;
    throw root.fault(error.what(), error.hint());
  }
}

std::string session_text(const Session& session) {
  const SessionHeader& header = session.header;
  Json head = {{"format", kFormat}, {"version", kVersion}, {"grammar", header.grammar}};
  if (!header.facade.empty()) head["facade"] = header.facade;
  if (header.width) head["width"] = json_of(*header.width);
  if (header.height) head["height"] = json_of(*header.height);
  if (header.photo) {
    Json photo = {{"file", header.photo->file}};
    if (header.photo->width > 0) photo["pixels"] = {header.photo->width, header.photo->height};
    if (header.photo->scale > 0) photo["scale"] = header.photo->scale;
    head["photo"] = photo;
  }
  if (header.min_size != SessionHeader().min_size) head["least"] = header.min_size;
  if (header.seed != 0) head["seed"] = header.seed;
  // One line per member and per edit, so that texts can be compared.
  const auto dump = [](const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  std::string out = "{\n";
  for (const auto& [key, value] : head.items())
    out += fmt::format("  {}: {},\n", dump(key), dump(value));
  const History& history = session.history;
  if (history.done() < history.edits().size())
    out += fmt::format("  \"done\": {},\n", history.done());
  if (!history.checkpoints().empty())
    out += fmt::format("  \"checkpoints\": {},\n", dump(Json(history.checkpoints())));
  out += "  \"edits\": [";
  for (size_t i = 0; i < history.edits().size(); ++i)
    out += fmt::format("{}\n    {}", i ? "," : "", dump(json_of(history.edits()[i])));
  return out + (history.edits().empty() ? "]\n}\n" : "\n  ]\n}\n");
}

}  // namespace vug::modeller
