// SPDX-License-Identifier: Apache-2.0
// Enumeration of all trees of tiny grammars.
#pragma once

#include <vug/fit/model/model.h>

#include <functional>
#include <map>
#include <sstream>
#include <string>

namespace vug::fit {

inline int find_or_add(Rules& rules, const std::string& name) {
  for (size_t i = 0; i < rules.symbols.size(); ++i)
    if (rules.symbols[i].name == name) return static_cast<int>(i);
  SymbolInfo info;
  info.name = name;
  info.terminal = name == "Window" || name == "Door" || name == "Shop" || name == "Doorway";
  info.type = name == "Window" ? RegionType::window
              : name == "Shop" ? RegionType::shop
              : info.terminal  ? RegionType::door
                               : RegionType::wall;
  info.grid = name.find("Grid") != std::string::npos;
  info.regular = name.find("Regular") != std::string::npos;
  info.identical = name.find("Identical") != std::string::npos;
  rules.symbols.push_back(info);
  return static_cast<int>(rules.symbols.size()) - 1;
}

/// "Facade grid RegularIdenticalGrid": head, operation, parts; the first head is the axiom.
inline Rules rules_of(const std::vector<std::string>& lines) {
  static const std::map<std::string, Op> ops = {
      {"rows", Op::rows},        {"repeat", Op::repeat},     {"mirror", Op::mirror},
      {"grid", Op::grid},        {"elements", Op::elements}, {"windows", Op::windows},
      {"terminal", Op::terminal}};
  Rules rules;
  for (const std::string& line : lines) {
    std::istringstream words(line);
    std::string head, op, part;
    words >> head >> op;
    Production production;
    production.head = find_or_add(rules, head);
    production.op = ops.at(op);
    while (words >> part) production.parts.push_back(find_or_add(rules, part));
    rules.productions.push_back(production);
  }
  return with_index(rules);
}

/// Calls emit(tree) for every tree of the model by exhaustive enumeration of the parameters.
class Enumeration {
 public:
  Enumeration(const Model& model, std::function<void(const Tree&)> emit)
      : model_(model), emit_(std::move(emit)) {}
  void run() { decide(model_.axiom_state().tree, 0); }

 private:
  bool sound(const Tree& tree) const {
    TreeState state = model_.make_state(tree);
    return model_.compute_areas(state);
  }

  void decide(const Tree& tree, int i) {
    if (i == tree.size()) return emit_(tree);
    decide(tree, i + 1);
    for (const int id : model_.rules().productions_of(tree[i].symbol)) expand(tree, i, id);
  }

  Node part(const Production& production, size_t number) const {
    Node node;
    node.symbol = static_cast<int16_t>(production.parts[number]);
    node.parent_op = static_cast<int8_t>(production.op);
    return node;
  }

  void put(const Tree& tree, int i, int id, const std::vector<Node>& parts) {
    Tree grown = tree;
    grown.grow(i, id, parts);
    if (sound(grown)) decide(grown, i + 1);
  }

  void expand(const Tree& tree, int i, int id) {
    const Production& production = model_.rules().production(id);
    const int w = model_.width(), h = model_.height();
    const Limits& limits = model_.limits();
    switch (production.op) {
      case Op::rows:
        for (int row = 1; row < h; ++row) {
          Node low = part(production, 0);
          low.extent = static_cast<int16_t>(row);
          put(tree, i, id, {low, part(production, 1)});
        }
        return;
      case Op::repeat:
        for (int times = 2; times <= limits.max_repeats; ++times) {
          Node node = part(production, 0);
          node.extent = static_cast<int16_t>(times);
          put(tree, i, id, {node});
        }
        return;
      case Op::mirror:
        if (production.parts.size() == 1) return put(tree, i, id, {part(production, 0)});
        for (int width = 1; width < w; ++width) {
          Node middle = part(production, 1);
          middle.extent = static_cast<int16_t>(width);
          put(tree, i, id, {part(production, 0), middle});
        }
        return;
      case Op::grid:
        each_lines(w, [&](int columns, const Lines& left) {
          each_lines(h, [&](int rows, const Lines& top) {
            Node node = part(production, 0);
            node.columns = static_cast<int16_t>(columns), node.rows = static_cast<int16_t>(rows);
            node.left = left, node.top = top;
            put(tree, i, id, {node});
          });
        });
        return;
      case Op::elements:
        each_widths({}, w, production,
                    [&](const std::vector<Node>& parts) { put(tree, i, id, parts); });
        return;
      case Op::windows:
        each_kinds({}, tree, i, id, production);
        return;
      case Op::terminal:
        each_rect([&](const Node& rect) {
          Node node = rect;
          node.symbol = static_cast<int16_t>(production.parts[0]);
          node.parent_op = static_cast<int8_t>(Op::terminal);
          put(tree, i, id, {node});
        });
        return;
    }
  }

  template <class Visit>
  void each_lines(int room, const Visit& visit) const {
    const std::function<void(Lines, int)> more = [&](Lines lines, int count) {
      if (count > 0) visit(count, lines);
      if (count == model_.limits().max_lines) return;
      const int first = count == 0 ? 0 : lines[static_cast<size_t>(count - 1)] + 1;
      for (int at = first; at < room; ++at) {
        lines[static_cast<size_t>(count)] = static_cast<int16_t>(at);
        more(lines, count + 1);
      }
    };
    more({}, 0);
  }

  template <class Visit>
  void each_widths(const std::vector<Node>& parts, int room, const Production& production,
                   const Visit& visit) const {
    std::vector<Node> longer = parts;
    longer.push_back(part(production, 0));
    visit(longer);
    if (static_cast<int>(longer.size()) == model_.limits().max_elements) return;
    for (int width = 1; width < room; ++width) {
      longer.back().extent = static_cast<int16_t>(width);
      each_widths(longer, room - width, production, visit);
    }
  }

  template <class Visit>
  void each_rect(const Visit& visit) const {
    const int w = model_.width(), h = model_.height();
    for (int x = 0; x < w; ++x)
      for (int y = 0; y < h; ++y)
        for (int width = 1; x + width <= w; ++width)
          for (int height = 1; y + height <= h; ++height) {
            Node node;
            node.x = static_cast<int16_t>(x), node.y = static_cast<int16_t>(y);
            node.width = static_cast<int16_t>(width), node.height = static_cast<int16_t>(height);
            visit(node);
          }
  }

  void each_kinds(const std::vector<Node>& kinds, const Tree& tree, int i, int id,
                  const Production& production) {
    const bool identical = model_.rules().symbol(tree[i].symbol).identical;
    const auto count = static_cast<int>(kinds.size());
    if (count > 0) {
      if (identical)
        with_door(kinds, tree, i, id, production);
      else
        each_cells(kinds, tree, i, id, production, 0);
    }
    if (count == (identical ? 1 : model_.limits().max_kinds)) return;
    for (int width = 1; width <= model_.width(); ++width)
      for (int height = 1; height <= model_.height(); ++height) {
        std::vector<Node> more = kinds;
        more.push_back(part(production, 0));
        more.back().width = static_cast<int16_t>(width);
        more.back().height = static_cast<int16_t>(height);
        each_kinds(more, tree, i, id, production);
      }
  }

  void each_cells(const std::vector<Node>& kinds, const Tree& tree, int i, int id,
                  const Production& production, int cell) {
    const int columns = tree[i].columns;
    if (cell == columns * tree[i].rows) return with_door(kinds, tree, i, id, production);
    Tree next = tree;
    for (int kind = 0; kind <= static_cast<int>(kinds.size()); ++kind) {
      next[i].set_kind(cell % columns, cell / columns, kind);
      each_cells(kinds, next, i, id, production, cell + 1);
    }
  }

  void with_door(const std::vector<Node>& kinds, const Tree& tree, int i, int id,
                 const Production& production) {
    if (production.parts.size() == 1) return put(tree, i, id, kinds);
    each_rect([&](const Node& rect) {
      std::vector<Node> all = kinds;
      all.push_back(rect);
      all.back().symbol = static_cast<int16_t>(production.parts[1]);
      all.back().parent_op = static_cast<int8_t>(Op::windows);
      put(tree, i, id, all);
    });
  }

  const Model& model_;
  std::function<void(const Tree&)> emit_;
};

/// A tree's nodes as bytes, used as a key.
inline std::string name_of(const Tree& tree) {
  std::string out;
  const auto add = [&](auto number) {
    out.append(reinterpret_cast<const char*>(&number), sizeof number);
  };
  for (const Node& n : tree.nodes) {
    for (const int16_t number :
         {n.symbol, n.production, n.size, n.extent, n.x, n.y, n.width, n.height, n.columns, n.rows})
      add(number);
    for (const int16_t at : n.left) add(at);
    for (const int16_t at : n.top) add(at);
    for (const uint64_t row : n.cells) add(row);
  }
  return out;
}

}  // namespace vug::fit
