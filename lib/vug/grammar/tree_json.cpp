// SPDX-License-Identifier: Apache-2.0
// JSON output of derivation trees; ordered_json keeps the order of the members.
#include <vug/grammar/tree_output.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace vug::grammar {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Value& value) {
  if (const Number* n = value.get<Number>()) return n->value;
  if (const bool* b = value.get<bool>()) return *b;
  if (const std::string* s = value.get<std::string>()) return *s;
  if (const auto* v = value.get<Value::Vector>()) return {v->value.x, v->value.y, v->value.z};
  return vug::to_string(value);
}

Json json_of(const SourceLocation& where) {
  Json out;
  out["file"] = where.file;
  out["line"] = where.line;
  out["column"] = where.column;
  out["end_line"] = where.end_line;
  out["end_column"] = where.end_column;
  return out;
}

Json json_of(const Tree& tree, int id) {
  const Node& node = tree.nodes[static_cast<size_t>(id)];
  Json out;
  out["id"] = id;
  out["parent"] = node.parent;
  out["symbol"] = node.symbol.name;
  out["text"] = to_string(node.symbol);
  out["params"] = Json::array();
  for (const Value& value : node.symbol.content.params) out["params"].push_back(json_of(value));
  out["path"] = tree.path(id);
  out["key"] = fmt::format("{:016x}", node.key.state());
  out["production"] = node.production;
  if (node.terminal) out["terminal"] = true;
  if (node.stuck) out["stuck"] = true;
  out["children"] = node.children;
  return out;
}

}  // namespace

std::string tree_json(const Tree& tree) {
  Json out;
  out["applied"] = tree.applied;
  out["productions"] = Json::array();
  for (const ProductionInfo& p : tree.productions) {
    Json info;
    info["name"] = p.name;
    info["symbol"] = p.symbol;
    if (p.where.known()) info["where"] = json_of(p.where);
    out["productions"].push_back(std::move(info));
  }
  out["nodes"] = Json::array();
  for (size_t i = 0; i < tree.nodes.size(); ++i)
    out["nodes"].push_back(json_of(tree, static_cast<int>(i)));
  // Invalid UTF-8 from a scene is replaced by replacement characters instead of throwing.
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace vug::grammar
