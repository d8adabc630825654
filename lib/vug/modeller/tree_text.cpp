// SPDX-License-Identifier: Apache-2.0
// Facade trees as JSON text, with checks of what is read.
#include <vug/base/json_value.h>
#include <vug/modeller/tree_to_edits.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vug::modeller {
namespace {

using Json = nlohmann::ordered_json;

using facade::Node;
using facade::Tree;

double length(const JsonValue& from) {
  const double value = from.number();
  if (!(std::abs(value) < 1e6)) throw from.fault("expected a length in metres");
  return value;
}

facade::Rect read_rect(const JsonValue& from) {
  const std::vector<JsonValue> numbers = from.items();
  if (numbers.size() != 4)
    throw from.fault("expected a rectangle of four numbers", "x, y, width and height");
  const facade::Rect out{length(numbers[0]), length(numbers[1]), length(numbers[2]),
                         length(numbers[3])};
  if (out.width < 0 || out.height < 0)
    throw from.fault("a rectangle must not have a negative size");
  return out;
}

facade::Placement read_copy(const JsonValue& from) {
  from.check_object({"x", "y", "mirrored"});
  const Json& mirrored = from.at("mirrored").json();
  if (!mirrored.is_boolean()) throw from.at("mirrored").fault("expected true or false");
  return {length(from.at("x")), length(from.at("y")), mirrored.get<bool>()};
}

facade::Numbers read_numbers(const JsonValue& from) {
  from.check_object();
  facade::Numbers out;
  for (const auto& [name, value] : from.json().items()) {
    const JsonValue one = from.at(name);
    if (!value.is_array())
      out.emplace_back(name, one.number());
    else
      for (const JsonValue& each : one.items()) out.emplace_back(name, each.number());
  }
  return out;
}

Node read_node(const JsonValue& from) {
  Node out;
  out.symbol = from.at("symbol").text();
  out.text = from.has("text") ? from.at("text").text() : out.symbol;
  out.rect = read_rect(from.at("rect"));
  if (from.has("copies"))
    for (const JsonValue& copy : from.at("copies").items()) out.copies.push_back(read_copy(copy));
  if (from.has("rule")) out.rule = from.at("rule").text();
  if (from.has("split")) out.split = from.at("split").text();
  if (from.has("numbers")) out.numbers = read_numbers(from.at("numbers"));
  if (!from.has("element")) return out;
  const JsonValue element = from.at("element");
  try {
    out.element = make_product(facade::elements(), element.text());
  } catch (const Error& error) {
    if (error.where().known()) throw;
    throw element.fault(error.what(), error.hint());
  }
  return out;
}

}  // namespace

Tree read_tree(const std::string& text, const std::string& file) {
  const Json json = JsonValue::parse(text, file);
  const JsonValue root(json, text, file);
  root.check_object();
  if (!root.has("nodes"))
    throw root.fault("this is not a facade tree",
                     "use a file written by 'vug facade fit' or 'vug tree --json'");
  Tree out;
  out.name = root.at("name").text();
  out.width = length(root.at("width"));
  out.height = length(root.at("height"));
  for (const JsonValue& from : root.at("nodes").items()) {
    Node node = read_node(from);
    const JsonValue parent = from.at("parent");
    node.parent = static_cast<int>(std::max(-1.0, length(parent)));
    const int here = static_cast<int>(out.nodes.size());
    if (node.parent >= here || node.parent != parent.number())
      throw parent.fault(fmt::format("node {} has an invalid parent", here),
                         "must be the index of an earlier node, or -1");
    if (node.parent >= 0) out.nodes[static_cast<size_t>(node.parent)].children.push_back(here);
    out.nodes.push_back(std::move(node));
  }
  return out;
}

}  // namespace vug::modeller
