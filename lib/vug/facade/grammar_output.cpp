// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/cell_columns.h>
#include <vug/facade/grammar_output.h>
#include <vug/facade/wrap_rule.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

namespace vug::facade {
namespace {

constexpr double kSame = 1e-6;  ///< Metres.

bool same(double a, double b) { return std::abs(a - b) < kSame; }

std::string length(double metres) { return fmt::format("{}m", std::round(metres * 1e4) / 1e4); }

/// An arithmetic progression of positions: start, number and distance.
struct Series {
  size_t count = 0;
  double first = 0, step = 0;
};

/// The gap between two cells of that size.
std::string gap(const Series& line, double size) {
  return length(line.count > 1 ? std::max(0.0, line.step - size) : 0);
}

/// The progression of the sorted positions without duplicates; nothing if the distances differ.
std::optional<Series> series(std::vector<double> at) {
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end(), same), at.end());
  const double step = at.size() > 1 ? at[1] - at[0] : 0;
  for (size_t i = 1; i < at.size(); ++i)
    if (!same(at[i] - at[i - 1], step)) return std::nullopt;
  return Series{at.size(), at[0], step};
}

class Writer {
 public:
  Writer(const Tree& tree, const GrammarTextOptions& options) : tree_(tree), options_(options) {}

  std::string run() {
    std::string axiom;
    for (size_t i = 0; i < tree_.nodes.size(); ++i)
      if (tree_.nodes[i].parent < 0) axiom += fmt::format(" {}", part(static_cast<int>(i)));
    if (axiom.empty()) axiom = " wall";
    std::string out = fmt::format("grammar {}: facade {{\n  width {}\n  height {}\n",
                                  options_.name.empty() ? tree_.name : options_.name,
                                  length(tree_.width), length(tree_.height));
    if (options_.thickness > 0) out += fmt::format("  thickness {}\n", length(options_.thickness));
    out += fmt::format("  axiom{}\n", axiom);
    // Written from the leaves to the root, printed from the axiom down.
    for (size_t i = rules_.size(); i-- > 0;) out += fmt::format("\n{}\n", wrap_rule(rules_[i]));
    return out + "}\n";
  }

 private:
  const Node& node(int i) const { return tree_.nodes[static_cast<size_t>(i)]; }

  /// The text of the node in a rule: an element, or a symbol whose rule is written as well.
  std::string part(int i) {
    const Node& it = node(i);
    if (it.element) return it.element->text();
    if (it.children.empty()) return "wall";
    const std::string items = body(i);
    std::string base = it.symbol;
    base[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(base[0])));
    return symbol(base, items);
  }

  /// A symbol with that rule: the known one, or a new one named `base`.
  std::string symbol(const std::string& base, const std::string& items) {
    std::string& name = names_[{base, items}];
    if (!name.empty()) return name;
    const int number = ++counts_[base];
    name = number == 1 ? base : fmt::format("{}{}", base, number);
    rules_.push_back(fmt::format("{} -> {}", name, items));
    return name;
  }

  /// The child as a part, with the offset of its plane, if any.
  std::string part_in_plane(int parent, int child) {
    const double depth = node(child).depth - node(parent).depth;
    if (same(depth, 0)) return part(child);
    return fmt::format("{}({}, {})", depth < 0 ? "recess" : "project", length(std::abs(depth)),
                       part(child));
  }

  std::string body(int i) {
    for (const auto form : {&Writer::rows_or_columns, &Writer::repeated, &Writer::mirrored}) {
      std::string text = (this->*form)(i);
      if (!text.empty()) return text;
    }
    if (options_.columns)
      if (std::string text = in_columns(i); !text.empty()) return text;
    return free_items(i, node(i).children);
  }

  std::string free_items(int i, const std::vector<int>& children) {
    std::string items;
    for (const int child : children)
      items += fmt::format("{}{}", items.empty() ? "" : " ", free(i, child));
    return items;
  }

  /// rows(...) or columns(...) if the children fill their parent in that way.
  std::string rows_or_columns(int i) {
    const std::vector<int>& children = node(i).children;
    if (children.size() < 2) return "";
    for (const bool upright : {true, false}) {
      const Rect& all = node(i).rect;
      double at = upright ? all.y : all.x;
      bool filled = true;
      for (const int child : children) {
        const Rect& r = node(child).rect;
        filled = filled && node(child).copies.empty() && same(upright ? r.y : r.x, at) &&
                 same(upright ? r.x : r.y, upright ? all.x : all.y) &&
                 same(upright ? r.width : r.height, upright ? all.width : all.height);
        at += upright ? r.height : r.width;
      }
      if (!filled || !same(at, upright ? all.top() : all.right())) continue;
      std::string parts;
      for (const int child : children) {
        const Rect& r = node(child).rect;
        const bool last = child == children.back();  // absorbs rounding errors
        parts +=
            fmt::format("{}{}, {}", parts.empty() ? "" : ", ",
                        last ? "1" : length(upright ? r.height : r.width), part_in_plane(i, child));
      }
      return fmt::format("{}({})", upright ? "rows" : "columns", parts);
    }
    return "";
  }

  /// repeat(...) if one child and its copies fill the parent along x or y.
  std::string repeated(int i) {
    if (node(i).children.size() != 1 || node(node(i).children[0]).copies.empty()) return "";
    const int child = node(i).children[0];
    const Rect &all = node(i).rect, &r = node(child).rect;
    for (const bool along_x : {true, false}) {
      std::vector<double> at = {0};
      bool shifted = true;
      for (const Placement& copy : node(child).copies) {
        shifted = shifted && !copy.mirrored && same(along_x ? copy.y : copy.x, 0);
        at.push_back(along_x ? copy.x : copy.y);
      }
      const double size = along_x ? r.width : r.height;
      const auto found = series(at);
      if (!shifted || !found || found->count != at.size() || !same(found->step, size) ||
          !same(found->first, 0) || !same(r.x, all.x) || !same(r.y, all.y) ||
          !same(static_cast<double>(at.size()) * size, along_x ? all.width : all.height) ||
          !same(along_x ? r.height : r.width, along_x ? all.height : all.width))
        continue;
      return fmt::format("repeat({}, {}, count: {})", along_x ? "x" : "y", part_in_plane(i, child),
                         at.size());
    }
    return "";
  }

  /// mirror(...): a side at both borders, one of them mirrored, and the middle.
  std::string mirrored(int i) {
    const std::vector<int>& children = node(i).children;
    if (children.empty() || children.size() > 2) return "";
    const Rect &all = node(i).rect, &side = node(children[0]).rect;
    const std::vector<Placement>& copies = node(children[0]).copies;
    if (copies.size() != 1 || !copies[0].mirrored ||
        !same(copies[0].x, 2 * (all.x + all.width / 2)) || !same(copies[0].y, 0) ||
        !same(side.x, all.x) || !same(side.y, all.y) || !same(side.height, all.height))
      return "";
    const double rest = all.width - 2 * side.width;
    const std::string text = part_in_plane(i, children[0]);
    if (children.size() == 1)
      return same(rest, 0) ? fmt::format("mirror({})", text)
                           : fmt::format("mirror({}, {}, wall)", text, length(rest));
    const Rect& middle = node(children[1]).rect;
    if (!same(middle.x, side.right()) || !same(middle.width, rest) || !same(middle.y, all.y) ||
        !same(middle.height, all.height) || !node(children[1]).copies.empty())
      return "";
    return fmt::format("mirror({}, {}, {})", text, length(rest), part_in_plane(i, children[1]));
  }

  /// A single child: a grid if its placements form one, else each with its margins.
  std::string free(int i, int child) {
    std::vector<Rect> rects = {node(child).rect};
    std::vector<double> x = {rects[0].x}, y = {rects[0].y};
    for (const Placement& copy : node(child).copies) {
      // Only copies of a mirror and symmetric elements are mirrored.
      rects.push_back(copy(rects[0]));
      x.push_back(rects.back().x), y.push_back(rects.back().y);
    }
    const auto columns = series(x), rows = series(y);
    const std::string text = part_in_plane(i, child);
    if (rects.size() > 1 && columns && rows && columns->count * rows->count == rects.size()) {
      const Rect& r = rects[0];
      const double right = columns->first + columns->step * static_cast<double>(columns->count - 1);
      const double top = rows->first + rows->step * static_cast<double>(rows->count - 1);
      return fmt::format("grid({}, columns: {}, rows: {}, gap: [{}, {}], margin: [{}])", text,
                         columns->count, rows->count, gap(*columns, r.width), gap(*rows, r.height),
                         margins(i, {columns->first, rows->first, right + r.width - columns->first,
                                     top + r.height - rows->first}));
    }
    std::string items;
    if (rects.size() == 1 && whole(node(i).rect, rects[0])) return text;
    for (const Rect& r : rects)
      items += fmt::format("{}inset({}, {})", items.empty() ? "" : " ", margins(i, r), text);
    return items;
  }

  /// columns(...) of symbols named Column, if a grid has unequal cells; the last children, such as
  /// a door over several columns, may be margins instead.
  std::string in_columns(int i) {
    constexpr size_t kMinCells = 3;
    const std::vector<int>& children = node(i).children;
    for (size_t count = children.size(); count > 0; --count) {
      std::vector<RuleCell> cells;
      for (size_t k = 0; k < count; ++k) {
        const int child = children[k];
        const std::string text = part_in_plane(i, child);
        cells.push_back({node(child).rect, text});
        for (const Placement& copy : node(child).copies)
          cells.push_back({copy(node(child).rect), text});
      }
      if (cells.size() < kMinCells || (count == 1 && is_grid(children[0]))) return "";
      const auto columns = cell_columns(std::move(cells));
      if (!columns) continue;
      std::string text = columns_text(node(i).rect, *columns);
      if (count == children.size()) return text;
      return text + " " +
             free_items(i, {children.begin() + static_cast<std::ptrdiff_t>(count), children.end()});
    }
    return "";
  }

  std::string columns_text(const Rect& all, const std::vector<CellColumn>& columns) {
    std::vector<Strip> strips;
    for (const CellColumn& column : columns) {
      std::vector<Strip> rows;
      for (const RuleCell& cell : column.cells) {
        const Rect& r = cell.rect;
        const bool full = same(r.x, column.left) && same(r.right(), column.right);
        rows.push_back({r.y, r.top(),
                        full ? cell.part
                             : fmt::format("inset({}, {}, 0m, 0m, {})", length(r.x - column.left),
                                           length(column.right - r.right()), cell.part)});
      }
      strips.push_back({column.left, column.right,
                        symbol("Column", strips_text("rows", all.y, all.top(), rows))});
    }
    return strips_text("columns", all.x, all.right(), strips);
  }

  /// A part between two positions along an axis.
  struct Strip {
    double begin = 0, end = 0;
    std::string part;
  };

  /// The split into the strips, with wall between them. Positions are rounded, not sizes, so that
  /// errors do not add up; the last part takes the rest.
  static std::string strips_text(const char* split, double begin, double end,
                                 const std::vector<Strip>& strips) {
    const auto rounded = [](double metres) { return std::round(metres * 1e4) / 1e4; };
    std::vector<std::pair<double, std::string>> parts;
    double at = rounded(begin);
    const auto put = [&](double to, const std::string& part) {
      if (rounded(to) > at) parts.emplace_back(rounded(to) - at, part);
      at = std::max(at, rounded(to));
    };
    for (const Strip& strip : strips) put(strip.begin, "wall"), put(strip.end, strip.part);
    put(end, "wall");
    if (parts.size() == 1) return parts[0].second;
    std::string text;
    for (size_t i = 0; i < parts.size(); ++i)
      text += fmt::format("{}{}, {}", i == 0 ? "" : ", ",
                          i + 1 < parts.size() ? length(parts[i].first) : "1", parts[i].second);
    return fmt::format("{}({})", split, text);
  }

  /// Whether the placements of a child form a grid of even spacing.
  bool is_grid(int child) const {
    std::vector<double> x = {node(child).rect.x}, y = {node(child).rect.y};
    for (const Placement& copy : node(child).copies) {
      const Rect r = copy(node(child).rect);
      x.push_back(r.x), y.push_back(r.y);
    }
    const size_t count = x.size();
    const auto columns = series(std::move(x)), rows = series(std::move(y));
    return columns && rows && columns->count * rows->count == count;
  }

  static bool whole(const Rect& all, const Rect& r) {
    return same(r.x, all.x) && same(r.y, all.y) && same(r.width, all.width) &&
           same(r.height, all.height);
  }

  /// The margins left, right, below and above.
  std::string margins(int i, const Rect& r) const {
    const Rect& all = node(i).rect;
    const auto margin = [](double size) { return length(std::max(0.0, size)); };
    return fmt::format("{}, {}, {}, {}", margin(r.x - all.x), margin(all.right() - r.right()),
                       margin(r.y - all.y), margin(all.top() - r.top()));
  }

  const Tree& tree_;
  const GrammarTextOptions& options_;
  std::map<std::pair<std::string, std::string>, std::string> names_;
  std::map<std::string, int> counts_;
  std::vector<std::string> rules_;
};

}  // namespace

std::string grammar_text(const Tree& tree, const GrammarTextOptions& options) {
  return Writer(tree, options).run();
}

}  // namespace vug::facade
