// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/fit/search/element_rows.h>
#include <vug/fit/search/layout.h>
#include <vug/fit/search/parse.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace vug::fit {
namespace {

Gains scaled(Gains gains, double by) {
  for (double& gain : gains) gain *= by;
  return gains;
}

class Parser {
 public:
  Parser(const MoveContext& context, const Evidence& evidence, const Gains& gains,
         const ParseOptions& options)
      : context_(context),
        model_(context.model),
        rules_(context.model.rules()),
        evidence_(evidence),
        map_(evidence, scaled(gains, context.model.pixel_weight())),
        options_(options),
        line_cost_(bits_for(model_.width())) {}

  TreeState best(TreeState state, int i, int depth) const {
    const Area area = state.area(i);
    const FoldedIntegral integral(map_, state, area);
    BestState found(model_, state);
    if (has(state, i, Op::grid)) {
      for (const auto& layout : layouts(state, i, integral)) {
        for (TreeState& grid :
             grid_candidates(context_, state, i, integral, layout.first, layout.second))
          found.add(std::move(grid));
      }
    }
    if (has(state, i, Op::elements))
      for (TreeState& row : element_row_candidates(context_, evidence_, state, i))
        found.add(std::move(row));
    if (depth == 0) return std::move(found.state);
    std::vector<TreeState> candidates = splits(state, i, integral);
    std::vector<double> bits;
    for (TreeState& plain : all_expanded(candidates, i, 0)) {
      bits.push_back(model_.energy(plain));
      found.add(std::move(plain));
    }
    if (depth == 1) return std::move(found.state);
    std::vector<size_t> order(candidates.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return bits[a] < bits[b]; });
    order.resize(std::min(order.size(), static_cast<size_t>(options_.breadth)));
    std::vector<TreeState> promising;
    for (const size_t best : order) promising.push_back(std::move(candidates[best]));
    for (TreeState& deep : all_expanded(promising, i, depth - 1)) found.add(std::move(deep));
    return std::move(found.state);
  }

 private:
  /// Layouts of windows: plain, with an additional column for the element between the windows, and
  /// next to elements on the ground anywhere.
  std::vector<std::pair<Layout, Rect>> layouts(const TreeState& state, int i,
                                               const FoldedIntegral& integral) const {
    std::vector<std::pair<Layout, Rect>> out;
    const auto add = [&](const Layout& layout, const Rect& door) {
      const std::pair<Layout, Rect> one(layout, door);
      if (std::find(out.begin(), out.end(), one) == out.end()) out.push_back(one);
    };
    const auto lay = [&](const FoldedIntegral& on, bool rows_first) {
      return find_layout(on, model_.limits(), line_cost_, 6, rows_first);
    };
    for (const bool rows_first : {false, true}) {
      const Layout plain = lay(integral, rows_first);
      if (plain.empty()) continue;
      const auto between = ground_elements_between(context_, evidence_, state, i, plain.columns);
      add(plain, between.empty() ? Rect{} : between.front());
      if (between.empty() || static_cast<int>(plain.columns.size()) >= model_.limits().max_lines)
        continue;
      const Rect& door = between.front();
      Layout with = plain;
      const auto at = std::find_if(with.columns.begin(), with.columns.end(),
                                   [&](const Segment& c) { return c.start >= door.x1; });
      with.columns.insert(at, {door.x0, door.x1});
      add(with, door);
    }
    std::vector<Rect> anywhere = ground_elements_between(context_, evidence_, state, i, {});
    if (anywhere.size() > kStanding) anywhere.resize(kStanding);
    for (const Rect& standing : anywhere) {
      const Layout beside = lay(integral.without(standing), true);
      if (!beside.empty()) add(beside, standing);
    }
    return out;
  }

  /// The best state so far.
  struct BestState {
    BestState(const Model& of, const TreeState& start) : model(of), state(start) {
      bits = model.energy(state);
    }
    void add(TreeState other) {
      const double others = model.energy(other);
      if (!(others < bits)) return;
      bits = others;
      state = std::move(other);
    }
    const Model& model;
    TreeState state;
    double bits;
  };

  bool has(const TreeState& state, int i, Op op) const {
    for (const int id : rules_.productions_of(state.tree[i].symbol))
      if (rules_.production(id).op == op) return true;
    return false;
  }

  /// Expands all children of node i, the last first, so that the indices of the others stay valid.
  TreeState expanded(TreeState state, int i, int depth) const {
    for (int number = state.tree.child_count(i) - 1; number >= 0; --number) {
      const int child = state.tree.child(i, number);
      state = best(std::move(state), child, depth);
    }
    return state;
  }

  std::vector<TreeState> all_expanded(const std::vector<TreeState>& candidates, int i,
                                      int depth) const {
    std::vector<TreeState> out(candidates.size());
    parallel_for(candidates.size(), [&](size_t k) { out[k] = expanded(candidates[k], i, depth); });
    return out;
  }

  static Node part_of(const Production& production, size_t number, int extent = 0) {
    Node node;
    node.symbol = static_cast<int16_t>(production.parts[number]);
    node.parent_op = static_cast<int8_t>(production.op);
    node.extent = static_cast<int16_t>(extent);
    return node;
  }

  /// Node i split in every way that the picture supports.
  std::vector<TreeState> splits(const TreeState& state, int i,
                                const FoldedIntegral& integral) const {
    std::vector<TreeState> out;
    const Area area = state.area(i);
    const int min_size = model_.limits().min_size;
    const double required = options_.min_potential * integral.potential();
    const auto add = [&](int id, const std::vector<Node>& parts, bool folds) {
      TreeState split = state;
      split.grow(i, id, parts);
      if (!std::isfinite(model_.energy(split))) return;
      double kept = 0;
      for (int number = 0; folds && number < static_cast<int>(parts.size()); ++number)
        kept += FoldedIntegral(map_, split, split.area(split.tree.child(i, number))).potential();
      if (!folds || kept >= required) out.push_back(std::move(split));
    };
    for (const int id : rules_.productions_of(state.tree[i].symbol)) {
      const Production& production = rules_.production(id);
      if (production.op == Op::rows)
        for (const int edge : strongest_edges(evidence_, state, area, false, kRows))
          add(id, {part_of(production, 0, area.height - edge), part_of(production, 1)}, false);
      if (production.op == Op::repeat)
        for (int times = 2;
             times <= std::min<int>(model_.limits().max_repeats, area.width / (2 * min_size));
             ++times)
          add(id, {part_of(production, 0, times)}, true);
      if (production.op == Op::mirror && production.parts.size() == 1)
        add(id, {part_of(production, 0)}, true);
      if (production.op == Op::mirror && production.parts.size() == 2)
        for (const int middle : middles(state, area)) {
          if (middle >= min_size)
            add(id, {part_of(production, 0), part_of(production, 1, middle)}, true);
        }
    }
    return out;
  }

  /// Widths of middles that end halfway between two edges of the picture, as elements and gaps
  /// alternate there.
  std::set<int> middles(const TreeState& state, const Area& area) const {
    const std::vector<int> places = strongest_edges(evidence_, state, area, true, kMiddles);
    std::set<int> out;
    for (size_t i = 0; i + 1 < places.size(); ++i)
      out.insert(std::abs(area.width - (places[i] + places[i + 1]) / 2 * 2));
    return out;
  }

  static constexpr int kRows = 12, kMiddles = 24;
  static constexpr size_t kStanding = 4;

  const MoveContext& context_;
  const Model& model_;
  const Rules& rules_;
  const Evidence& evidence_;
  const GainMap map_;
  const ParseOptions options_;
  const double line_cost_;
};

}  // namespace

TreeState parse(const MoveContext& context, const Evidence& evidence, const Gains& gains,
                TreeState state, int i, const ParseOptions& options) {
  context.model.energy(state);
  return Parser(context, evidence, gains, options).best(std::move(state), i, options.depth);
}

}  // namespace vug::fit
