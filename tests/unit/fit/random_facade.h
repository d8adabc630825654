// SPDX-License-Identifier: Apache-2.0
// Random facades of the published grammar as pictures with known trees.
#pragma once

#include <vug/facade/derive.h>
#include <vug/fit/fit_facade.h>
#include <vug/fit/model/compile.h>
#include <vug/scene/parser.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace vug::fit {

/// Converts a derivation to a tree of the sampler: metres rounded to pixels, y down.
class PixelTree {
 public:
  PixelTree(const facade::Tree& from, const Rules& rules, double scale)
      : from_(from), rules_(rules), scale_(scale) {}

  /// Empty if it exceeds the model's limits.
  std::optional<Tree> tree(const Model& model) {
    TreeState out = model.axiom_state();
    if (!add(model, out, 0, 0) || !std::isfinite(model.energy(out))) return std::nullopt;
    return out.tree;
  }
  int px(double metres) const { return static_cast<int>(std::lround(metres * scale_)); }

  /// An element in whole pixels, y down.
  struct Painted {
    std::string kind;
    Rect rect;
  };
  std::vector<Painted> painted() const {
    std::vector<Painted> out;
    const int down = px(from_.height);
    for (const facade::ElementInstance& one : facade::element_instances(from_)) {
      const facade::Rect& r = one.rect;
      out.push_back({from_.nodes[static_cast<size_t>(one.node)].element->kind(),
                     {px(r.x), down - px(r.y + r.height), px(r.x + r.width), down - px(r.y)}});
    }
    return out;
  }

  static double number(const facade::Numbers& numbers, const std::string& name) {
    for (const auto& [key, value] : numbers)
      if (key == name) return value;
    return 0;
  }

 private:
  int symbol(const std::string& name) const {
    for (size_t i = 0; i < rules_.symbols.size(); ++i)
      if (rules_.symbols[i].name == name) return static_cast<int>(i);
    return -1;
  }

  /// Symbols of the node's children, without duplicates unless `each`.
  std::vector<int> parts(const facade::Node& node, bool each) const {
    std::vector<int> out;
    for (const int child : node.children) {
      const int s = symbol(from_.nodes[static_cast<size_t>(child)].symbol);
      if (each || std::find(out.begin(), out.end(), s) == out.end()) out.push_back(s);
    }
    return out;
  }

  static Op op_of(const facade::Node& node, const Rules& rules, int part) {
    if (node.split == "rows") return Op::rows;
    if (node.split == "mirror") return Op::mirror;
    if (node.split == "repeat") return node.children.size() > 1 ? Op::elements : Op::repeat;
    if (node.split == "grid") return Op::windows;
    return rules.symbol(part).terminal ? Op::terminal : Op::grid;
  }

  bool add(const Model& model, TreeState& out, int i, int from) {
    if (!out.areas_valid && !model.compute_areas(out)) return false;
    const int room = out.area(i).width;
    const facade::Node& node = from_.nodes[static_cast<size_t>(from)];
    if (node.children.empty()) return true;
    const std::vector<int> symbols = parts(node, false);
    Op op = op_of(node, rules_, symbols[0]);
    if (rules_.symbol(out.tree[i].symbol).name == "FacadeRow" && node.split == "repeat")
      op = Op::elements;
    int id = -1;
    for (const int at : rules_.productions_of(out.tree[i].symbol)) {
      std::vector<int> wanted = symbols, have = rules_.production(at).parts;
      std::sort(wanted.begin(), wanted.end()), std::sort(have.begin(), have.end());
      if (rules_.production(at).op == op && wanted == have) id = at;
    }
    if (id < 0) return false;  // A door alone.
    std::vector<Node> nodes;
    std::vector<int> sources;
    const auto put = [&](int child, Node one) {
      one.symbol = static_cast<int16_t>(symbol(from_.nodes[static_cast<size_t>(child)].symbol));
      one.parent_op = static_cast<int8_t>(op);
      nodes.push_back(one);
      sources.push_back(child);
    };
    const auto to = [&](double metres) { return static_cast<int16_t>(px(metres)); };
    const facade::Rect& area = node.rect;
    if (op == Op::grid) {
      const int child = node.children[0];
      const facade::Node& grid = from_.nodes[static_cast<size_t>(child)];
      const SymbolInfo& info = rules_.symbol(symbols[0]);
      Node one;
      const facade::Rect& cell = from_.nodes[static_cast<size_t>(grid.children[0])].rect;
      one.columns = static_cast<int16_t>(number(grid.numbers, "columns"));
      one.rows = static_cast<int16_t>(number(grid.numbers, "rows"));
      lines(grid.numbers, "x", one.columns, info.regular, one.left);
      if (info.regular)
        one.left = even_lines(
            one.left[0], one.left[static_cast<size_t>(one.columns - 1)] - one.left[0], one.columns);
      lines(grid.numbers, "y", one.rows, info.regular, one.top);
      Lines top{};
      for (size_t row = 0; row < static_cast<size_t>(one.rows); ++row)
        top[row] = static_cast<int16_t>(
            px(area.height) - one.top[static_cast<size_t>(one.rows) - 1 - row] - px(cell.height));
      one.top = info.regular
                    ? even_lines(top[0], top[static_cast<size_t>(one.rows - 1)] - top[0], one.rows)
                    : top;
      put(child, one);
    } else if (op == Op::windows) {
      int window = -1, door = -1;
      for (const int child : node.children)
        (from_.nodes[static_cast<size_t>(child)].symbol == "door" ? door : window) = child;
      const auto rect = [&](int child) {
        const facade::Rect& r = from_.nodes[static_cast<size_t>(child)].rect;
        Node one;
        one.width = to(r.width), one.height = to(r.height);
        return one;
      };
      put(window, rect(window));
      if (door >= 0) {
        Node one = rect(door);
        const facade::Rect& r = from_.nodes[static_cast<size_t>(door)].rect;
        one.x = to(r.x - area.x);
        one.y = static_cast<int16_t>(px(area.height) - px(r.y - area.y) - one.height);
        put(door, one);
      }
      if (!rules_.symbol(out.tree[i].symbol).identical)
        out.tree[i].cells = out.tree[i].full_cells();
      out.grow(i, id, nodes);
      return model.compute_areas(out);
    } else {
      for (const int child : node.children) {
        const facade::Node& part = from_.nodes[static_cast<size_t>(child)];
        Node one;
        const std::string& name = part.symbol;
        if (op == Op::rows && name == "FacadeRow") one.extent = to(part.rect.height);
        if (op == Op::repeat) one.extent = static_cast<int16_t>(number(part.given, "count"));
        if (op == Op::elements && child != node.children.back()) one.extent = to(part.rect.width);
        if (op == Op::mirror && name == "SymmetricFacadeMiddle")
          one.extent = static_cast<int16_t>(room - 2 * ((room - to(part.rect.width)) / 2));
        if (op == Op::terminal) one.width = out.area(i).width, one.height = out.area(i).height;
        put(child, one);
      }
    }
    out.grow(i, id, nodes);
    for (size_t k = sources.size(); k-- > 0;)
      if (!add(model, out, out.tree.child(i, static_cast<int>(k)), sources[k])) return false;
    return true;
  }

  void lines(const facade::Numbers& numbers, const std::string& axis, int count, bool regular,
             Lines& out) const {
    std::vector<double> steps;
    for (const auto& [key, value] : numbers)
      if (key == "d" + axis) steps.push_back(value);
    double at = number(numbers, axis);
    for (int i = 0; i < count; ++i) {
      out[static_cast<size_t>(i)] = static_cast<int16_t>(px(at));
      at += steps[regular ? 0 : std::min(static_cast<size_t>(i), steps.size() - 1)];
    }
  }

  const facade::Tree& from_;
  const Rules& rules_;
  const double scale_;
};

inline void paint(std::vector<uint8_t>& picture, int width, const Rect& r, int value) {
  for (int y = r.y0; y < r.y1; ++y)
    for (int x = r.x0; x < r.x1; ++x)
      picture[static_cast<size_t>(y * width + x)] = static_cast<uint8_t>(value);
}

/// A facade of the published grammar and its picture: 0 wall, 1 windows, 2 doors and shops.
struct RandomFacade {
  static constexpr int kClasses = 3;
  int width = 0, height = 0;
  std::vector<uint8_t> classes;
  Tree tree;
  facade::Tree derived;

  std::vector<uint8_t> noisy(double noise, RandomKey key) const {
    RandomStream stream(key);
    std::vector<uint8_t> out = classes;
    for (uint8_t& one : out)
      if (stream.uniform() < noise) one = static_cast<uint8_t>(stream.below(kClasses));
    return out;
  }
};

inline const Rules& ripperda() {
  static const Rules all = compile(facade::load_rules(VUG_DATA "/facades/ripperda.vug"));
  return all;
}

/// Empty if a part is too small to be visible, or a grid has more lines than the sampler allows.
inline std::optional<RandomFacade> random_facade(uint64_t seed, double scale = 20,
                                                 double width = 12, double height = 9,
                                                 int least = 6) {
  std::ifstream file(VUG_DATA "/facades/ripperda.vug");
  std::stringstream text;
  text << file.rdbuf();
  Diagnostics diagnostics;
  const scene::Document document = scene::parse(text.str(), "ripperda.vug", diagnostics);
  scene::Resolver resolver;
  scene::Evaluator evaluator(document, resolver, diagnostics);
  const facade::Rules rules = facade::read_rules(document, document.grammars.back(), diagnostics);
  const auto made =
      facade::derive(rules, evaluator, {.width = width, .height = height, .key = RandomKey(seed)});
  if (!made) return std::nullopt;
  RandomFacade out;
  out.derived = made->tree;
  out.width = static_cast<int>(std::lround(width * scale));
  out.height = static_cast<int>(std::lround(height * scale));
  for (const facade::Node& node : made->tree.nodes)
    for (const auto& [name, value] : node.numbers)
      if ((name == "columns" || name == "rows") && value > kMaxLines) return std::nullopt;
  PixelTree pixels(made->tree, ripperda(), scale);
  out.classes.assign(static_cast<size_t>(out.width * out.height), 0);
  for (const PixelTree::Painted& one : pixels.painted()) {
    if (one.rect.x1 - one.rect.x0 < least || one.rect.y1 - one.rect.y0 < least) return std::nullopt;
    paint(out.classes, out.width, one.rect, one.kind == "window" ? 1 : 2);
  }
  const Model model(ripperda(), {}, out.width, out.height);
  std::optional<Tree> tree = pixels.tree(model);
  if (!tree) return std::nullopt;
  out.tree = std::move(*tree);
  return out;
}

}  // namespace vug::fit
