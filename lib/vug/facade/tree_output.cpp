// SPDX-License-Identifier: Apache-2.0
#include <vug/base/xml.h>
#include <vug/facade/tree_output.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>

namespace vug::facade {

namespace {

using Json = nlohmann::ordered_json;

/// Rounds to a tenth of a millimetre to hide rounding errors of sums.
double rounded(double value) { return std::round(value * 1e4) / 1e4 + 0.0; }

Json json_of(const Rect& r) {
  return Json{rounded(r.x), rounded(r.y), rounded(r.width), rounded(r.height)};
}

Json json_of(const Numbers& numbers) {
  Json out = Json::object();
  for (const auto& [name, value] : numbers) {
    if (!out.contains(name))
      out[name] = rounded(value);
    else if (out[name].is_array())
      out[name].push_back(rounded(value));
    else
      out[name] = Json{out[name], rounded(value)};
  }
  return out;
}

Json json_of(const Tree& tree, size_t id) {
  const Node& node = tree.nodes[id];
  Json out;
  out["id"] = id;
  out["parent"] = node.parent;
  out["symbol"] = node.symbol;
  if (node.text != node.symbol) out["text"] = node.text;
  if (node.element) out["element"] = node.element->kind();
  out["rect"] = json_of(node.rect);
  if (node.mirrored) out["mirrored"] = true;
  if (node.depth != 0) out["depth"] = rounded(node.depth);
  if (!node.copies.empty()) {
    out["copies"] = Json::array();
    for (const Placement& copy : node.copies)
      out["copies"].push_back(
          {{"x", rounded(copy.x)}, {"y", rounded(copy.y)}, {"mirrored", copy.mirrored}});
  }
  if (!node.rule.empty()) out["rule"] = node.rule;
  if (node.stuck) out["stuck"] = true;
  if (!node.split.empty()) out["split"] = node.split;
  if (!node.given.empty()) out["given"] = json_of(node.given);
  if (!node.numbers.empty()) out["numbers"] = json_of(node.numbers);
  out["children"] = node.children;
  return out;
}

std::string number_text(double value) { return fmt::format("{}", rounded(value)); }

void append(const Numbers& numbers, std::string& out) {
  for (const auto& [name, value] : numbers) out += number_text(value) + ", ";
}

/// The text of a node without its parts and the closing bracket.
std::string theta_head(const Tree& tree, const Node& node) {
  std::string out = node.symbol + '(';
  if (node.parent < 0)
    append({{"x", node.rect.x}, {"y", node.rect.y}, {"w", tree.width}, {"h", tree.height}}, out);
  append(node.given, out);
  append(node.numbers, out);
  if (node.element)
    append(
        {{"w", node.rect.width}, {"h", node.rect.height}, {"x", node.rect.x}, {"y", node.rect.y}},
        out);
  return out;
}

/// Tooltip: symbol and size, and the rule in a second line.
std::string title_of(const Node& node, const Rect& r) {
  const std::string rule = node.stuck ? "open" : xml_text(node.rule);
  return fmt::format("{} {} x {} m{}{}", xml_text(node.text), number_text(r.width),
                     number_text(r.height), rule.empty() ? "" : "\n", rule);
}

/// The colour of a kind of element; it depends only on the name.
std::string color_of(const std::string& name) {
  unsigned hash = 2166136261u;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return fmt::format("hsl({}, 65%, {}%)", (hash >> 8) % 360, 40 + hash % 20);
}

}  // namespace

std::string tree_json(const Tree& tree) {
  Json out;
  out["name"] = tree.name;
  out["width"] = rounded(tree.width);
  out["height"] = rounded(tree.height);
  out["theta"] = theta(tree);
  out["nodes"] = Json::array();
  for (size_t i = 0; i < tree.nodes.size(); ++i) out["nodes"].push_back(json_of(tree, i));
  out["elements"] = Json::array();
  for (const ElementInstance& one : element_instances(tree)) {
    Json element{{"kind", tree.nodes[static_cast<size_t>(one.node)].element->kind()},
                 {"node", one.node},
                 {"rect", json_of(one.rect)}};
    if (one.mirrored) element["mirrored"] = true;
    out["elements"].push_back(std::move(element));
  }
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string theta(const Tree& tree) {
  std::string out;
  struct Entry {
    int node;  ///< -1: a closing bracket.
    std::string text;
  };
  std::vector<Entry> stack;
  const auto push = [&](const std::vector<int>& nodes) {
    for (size_t i = nodes.size(); i-- > 0;)
      stack.push_back({nodes[i], i + 1 < nodes.size() ? ", " : ""});
  };
  std::vector<int> roots;
  for (size_t i = 0; i < tree.nodes.size(); ++i)
    if (tree.nodes[i].parent < 0) roots.push_back(static_cast<int>(i));
  push(roots);
  while (!stack.empty()) {
    const Entry entry = stack.back();
    stack.pop_back();
    if (entry.node < 0) {
      out += entry.text;
      continue;
    }
    const Node& node = tree.nodes[static_cast<size_t>(entry.node)];
    out += theta_head(tree, node);
    const bool group = node.children.size() > 1;
    if (node.children.empty() && out.size() > 2 && out.substr(out.size() - 2) == ", ")
      out.resize(out.size() - 2);
    if (group) out += '(';
    stack.push_back({-1, (group ? "))" : ")") + entry.text});
    push(node.children);
  }
  return out;
}

std::string elements_csv(const Tree& tree) {
  std::string out = "kind,x,y,width,height,mirrored\n";
  for (const ElementInstance& one : element_instances(tree))
    out += fmt::format(
        "{},{},{},{},{},{}\n", tree.nodes[static_cast<size_t>(one.node)].element->kind(),
        number_text(one.rect.x), number_text(one.rect.y), number_text(one.rect.width),
        number_text(one.rect.height), one.mirrored ? 1 : 0);
  return out;
}

std::string elevation_svg(const Tree& tree, const SvgOptions& options) {
  const double scale = options.pixels / tree.width;
  const auto number = [&](double metres) { return number_text(metres * scale); };
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} "
      "{1}\">\n",
      number(tree.width), number(tree.height));
  const Rect& part = options.part;
  const double wide = tree.width / part.width, high = tree.height / part.height;
  const std::string offset =
      part.x == 0 && part.y == 0
          ? ""
          : fmt::format(" x=\"{}\" y=\"{}\"", number(-part.x * wide), number(-part.y * high));
  if (!options.picture.empty())
    out += fmt::format(
        "<image href=\"{}\"{} width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\"/>\n",
        xml_text(options.picture), offset, number(wide), number(high));
  const auto rect = [&](const Rect& r, const std::string& style, const Node& node) {
    out += fmt::format(
        "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}><title>{}</title></rect>\n",
        number(r.x), number(tree.height - r.top()), number(r.width), number(r.height), style,
        title_of(node, r));
  };
  for (const ElementInstance& one : element_instances(tree)) {
    const Node& node = tree.nodes[static_cast<size_t>(one.node)];
    const std::string color = color_of(node.element->kind());
    rect(one.rect,
         fmt::format("fill=\"{}\" fill-opacity=\"{}\" stroke=\"{}\"", color,
                     node.element->kind() == "wall" ? "0.1" : "0.45", color),
         node);
  }
  for (size_t i = 0; i < tree.nodes.size(); ++i) {
    const Node& node = tree.nodes[i];
    if (node.element) continue;
    // Mark nodes that no rule has divided yet.
    const char* style =
        node.stuck
            ? "fill=\"#ff9000\" fill-opacity=\"0.25\" stroke=\"#ff9000\" stroke-width=\"2\""
            : "fill=\"none\" stroke=\"#202020\" stroke-width=\"0.7\" stroke-dasharray=\"4 3\"";
    for (const Placement& place : placements(tree, static_cast<int>(i)))
      rect(place(node.rect), style, node);
  }
  return out + "</svg>\n";
}

}  // namespace vug::facade
