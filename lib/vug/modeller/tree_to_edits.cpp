// SPDX-License-Identifier: Apache-2.0
#include <vug/base/pluralize.h>
#include <vug/modeller/tree_to_edits.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace vug::modeller {
namespace {

using facade::Node;
using facade::Rect;
using facade::Tree;

/// Size error due to rounding to tenths of millimetres.
constexpr double kRounding = 2e-4;
constexpr double kDisplaced = 0.01;  ///< Metres.

std::vector<double> all_of(const facade::Numbers& numbers, const std::string& name) {
  std::vector<double> out;
  for (const auto& [known, value] : numbers)
    if (known == name) out.push_back(value);
  return out;
}

/// Names of a grid's numbers along one axis.
struct GridAxis {
  const char *count, *first, *steps, *size;
  double Rect::*edge, Rect::*extent;
};
constexpr GridAxis kAcross{"columns", "x", "dx", "width", &Rect::x, &Rect::width},
    kUp{"rows", "y", "dy", "height", &Rect::y, &Rect::height};

/// Largest common size of cells that start at these positions within the room.
double max_cell_size(const std::vector<double>& begins, double room) {
  double out = std::min(room / static_cast<double>(begins.size()), room - begins.back());
  for (size_t i = 1; i < begins.size(); ++i) out = std::min(out, begins[i] - begins[i - 1]);
  return out;
}

/// Removes the number that facade::grammar_text appends to symbols with different parts: "Bay",
/// "Bay2".
std::string without_number(std::string symbol) {
  while (!symbol.empty() && std::isdigit(static_cast<unsigned char>(symbol.back())))
    symbol.pop_back();
  return symbol;
}

size_t nearest(const std::vector<double>& begins, double at) {
  size_t best = 0;
  for (size_t i = 1; i < begins.size(); ++i)
    if (std::abs(begins[i] - at) < std::abs(begins[best] - at)) best = i;
  return best;
}

class TreeTracer {
 public:
  TreeTracer(const FacadeState& start, const Tree& tree) : state_(start), tree_(tree) {}

  TreeEdits run() {
    std::vector<std::string> paths;
    int roots = 0;
    for (size_t i = 0; i < tree_.nodes.size(); ++i) {
      const Node& node = tree_.nodes[i];
      paths.push_back(node.parent < 0
                          ? std::to_string(roots++)
                          : fmt::format("{}.{}", paths[static_cast<size_t>(node.parent)],
                                        number_of(static_cast<int>(i))));
      if (!node.rule.empty()) follow(node, paths.back());
    }
    compare();
    return std::move(out_);
  }

 private:
  const Node& node(int i) const { return tree_.nodes[static_cast<size_t>(i)]; }

  /// Index among its parent's children.
  size_t number_of(int i) const {
    const std::vector<int>& all = node(node(i).parent).children;
    return static_cast<size_t>(std::find(all.begin(), all.end(), i) - all.begin());
  }

  void follow(const Node& from, const std::string& path) {
    const std::optional<int> here = found(path);
    if (!here || state_.node(*here).element) return;  // The edit of an ancestor failed.
    Edit edit{"apply", path, rule_of(from, state_.node(*here).symbol),
              numbers_of(from, state_.node(*here).rect)};
    while (!done(edit)) {
      // The rule does not have this number as a free one, or it does not fit: use its default.
      const std::string number =
          rejected_key_.rfind("numbers/", 0) == 0 ? rejected_key_.substr(8) : "";
      if (!edit.numbers.erase(number)) return;
    }
    if (from.split == "grid") clear_empty_cells(from, path);
  }

  std::optional<int> found(const std::string& path) const {
    try {
      return state_.find(path);
    } catch (const Error&) {
      return std::nullopt;
    }
  }

  /// The rule with the same text; in a grammar written from a tree, the only rule of the symbol.
  std::string rule_of(const Node& from, const std::string& symbol) const {
    const Style& style = state_.style();
    for (const int rule : style.rules_of(from.symbol))
      if (to_string(style.rule(rule)) == from.rule) return style.rule_name(rule);
    const auto only = style.rules_of(symbol);
    if (only.size() == 1 && without_number(symbol) == without_number(from.symbol))
      return style.rule_name(only[0]);
    throw Error(ErrorCode::bad_input,
                fmt::format("the grammar '{}' has no rule '{}'", style.name(), from.rule), {},
                fmt::format("the tree is of '{}': name that grammar with --grammar", tree_.name));
  }

  bool done(const Edit& edit) {
    try {
      state_ = perform_edit(state_, edit);
    } catch (const RejectedEdit& rejected) {
      rejected_key_ = rejected.key();
      return false;
    }
    out_.edits.push_back(edit);
    return true;
  }

  /// Sizes of all parts but the last, which takes the rest.
  std::vector<double> sizes(const Node& from, bool upright) const {
    std::vector<double> out;
    for (size_t i = 0; i + 1 < from.children.size(); ++i) {
      const Rect& r = node(from.children[i]).rect;
      out.push_back(upright ? r.height : r.width);
    }
    return out;
  }

  /// Edges of all contents of a grid, from its left or lower edge, ascending.
  std::vector<double> edges(const Node& grid, const GridAxis& axis) const {
    std::vector<double> out;
    for (const int child : grid.children) {
      out.push_back(node(child).rect.*axis.edge - grid.rect.*axis.edge);
      for (const facade::Placement& copy : node(child).copies)
        out.push_back(copy(node(child).rect).*axis.edge - grid.rect.*axis.edge);
    }
    std::sort(out.begin(), out.end());
    return out;
  }

  /// Starts of columns or rows. The tree stores the spacing of a regular grid as that of its first
  /// two lines, which may differ from the mean because of whole pixels.
  std::vector<double> begins(const Node& grid, const GridAxis& axis) const {
    const std::vector<double> count = all_of(grid.numbers, axis.count),
                              first = all_of(grid.numbers, axis.first);
    std::vector<double> steps = all_of(grid.numbers, axis.steps);
    if (count.empty() || first.empty() || !(count[0] >= 1 && count[0] <= 1000)) return {};
    const auto many = static_cast<size_t>(count[0]);
    if (steps.size() == 1 && many > 2 && steps[0] > 0) {
      double at = first[0], number = 0, mean = steps[0];
      for (const double edge : edges(grid, axis)) {
        const double further = std::round((edge - at) / steps[0]);
        if (further < 1) continue;
        number += further, at = edge;
        mean = (at - first[0]) / number;
      }
      steps.assign(many - 1, mean);
    }
    std::vector<double> out = {first[0]};
    while (out.size() < many)
      out.push_back(out.back() + (out.size() > steps.size() ? 0 : steps[out.size() - 1]));
    return out;
  }

  /// The numbers that the node's split may have left free, derived from its parts.
  facade::NumberValues numbers_of(const Node& from, const Rect& room) const {
    facade::NumberValues out;
    if (from.children.empty()) return out;
    const Node& first = node(from.children[0]);
    if (from.split == "rows") out["heights"] = sizes(from, true);
    if (from.split == "columns") out["widths"] = sizes(from, false);
    if (from.split == "mirror" && from.children.size() == 2)
      out["width"] = {node(from.children[1]).rect.width};
    if (from.split == "repeat") {
      out["count"] = {static_cast<double>(std::max(from.children.size(), first.copies.size() + 1))};
      if (from.children.size() > 1) {
        const bool upright = node(from.children[1]).rect.y > first.rect.y;
        out[upright ? "heights" : "widths"] = sizes(from, upright);
      }
    }
    if (from.split == "grid") add_grid_numbers(from, room, out);
    std::erase_if(out, [](const auto& each) { return each.second.empty(); });
    return out;
  }

  void add_grid_numbers(const Node& from, const Rect& room, facade::NumberValues& out) const {
    // A single size for all cells: the most frequent one.
    const Node* most = nullptr;
    const std::string& cell = node(from.children[0]).symbol;
    for (const int child : from.children) {
      const Node& each = node(child);
      if (each.symbol != cell)
        out["door"] = {
            static_cast<double>(nearest(begins(from, kAcross), each.rect.x - from.rect.x))};
      else if (!most || each.copies.size() > most->copies.size())
        most = &each;
    }
    for (const GridAxis& axis : {kAcross, kUp}) {
      out[axis.size] = {most->rect.*axis.extent - kRounding};
      const std::vector<double> at = begins(from, axis);
      if (at.empty()) continue;
      out[axis.count] = {static_cast<double>(at.size())};
      out[axis.first] = {at[0]};
      const size_t numbers_of = std::min(all_of(from.numbers, axis.steps).size(), at.size() - 1);
      for (size_t k = 0; k < numbers_of; ++k) out[axis.steps].push_back(at[k + 1] - at[k]);
      // Sizes give way if they do not fit everywhere, because positions are more significant.
      const double fits = max_cell_size(at, room.*axis.extent) - kRounding;
      if (fits > 0) out[axis.size][0] = std::min(out[axis.size][0], fits);
    }
  }

  /// Toggles cells of a grid that are empty in the tree.
  void clear_empty_cells(const Node& from, const std::string& path) {
    const std::vector<double> x = begins(from, kAcross), y = begins(from, kUp);
    if (x.empty() || y.empty()) return;
    std::set<std::pair<size_t, size_t>> stands;
    for (const int child : from.children) {
      const Rect first = node(child).rect;
      const auto mark = [&](const Rect& r) {
        stands.insert({nearest(x, r.x - from.rect.x), nearest(y, r.y - from.rect.y)});
      };
      mark(first);
      for (const facade::Placement& copy : node(child).copies) mark(copy(first));
    }
    for (size_t row = 0; row < y.size(); ++row)
      for (size_t column = 0; column < x.size(); ++column)
        if (!stands.count({column, row}))
          done({"toggle",
                path,
                "",
                {{"column", {static_cast<double>(column)}}, {"row", {static_cast<double>(row)}}}});
  }

  /// Compares the positions of all elements with the nearest counterpart of the same kind.
  void compare() {
    std::map<std::string, std::vector<Rect>> now;
    for (const facade::ElementInstance& one : facade::element_instances(state_.tree()))
      now[state_.node(one.node).element->kind()].push_back(one.rect);
    for (const facade::ElementInstance& one : facade::element_instances(tree_)) {
      ++out_.elements;
      double distance = INFINITY;
      for (const Rect& r : now[node(one.node).element->kind()])
        distance = std::min(
            distance,
            std::max({std::abs(r.x - one.rect.x), std::abs(r.y - one.rect.y),
                      std::abs(r.right() - one.rect.right()), std::abs(r.top() - one.rect.top())}));
      if (std::isinf(distance)) {
        ++out_.missing;
      } else if (distance >= kDisplaced) {
        ++out_.displaced;
        out_.max_distance = std::max(out_.max_distance, distance);
      }
    }
  }

  FacadeState state_;
  const Tree& tree_;
  TreeEdits out_;
  std::string rejected_key_;
};

}  // namespace

TreeEdits tree_to_edits(const FacadeState& start, const Tree& tree) {
  return TreeTracer(start, tree).run();
}

std::string deviation_text(const TreeEdits& edits) {
  if (edits.missing + edits.displaced == 0) return "";
  return fmt::format(
      "the rules approximate the tree, because they have fewer free values: of {}, {} are up to "
      "{:.2f} m off and {} are missing",
      pluralize(edits.elements, "element"), edits.displaced, edits.max_distance, edits.missing);
}

}  // namespace vug::modeller
