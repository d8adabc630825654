// SPDX-License-Identifier: Apache-2.0
// Refinement of grids with a table of each line's gain per position: lines that must not touch are
// placed by dynamic programming, lines of a regular grid by searching first lines and spans.
#include <vug/fit/evidence/folded_integral.h>
#include <vug/fit/polish/polish.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace vug::fit {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();

/// A grid's windows along x or y, with tables of the gain of each line at each position.
class Axis {
 public:
  /// Sizes of the kinds along the axis; the first entry is that of kind 1.
  using Sizes = std::vector<int>;

  Axis(const Rules& rules, const Tree& tree, int grid, const FoldedIntegral& integral, int room,
       bool along_x)
      : tree_(tree),
        grid_(grid),
        integral_(integral),
        along_x_(along_x),
        regular_(rules.symbol(tree[grid].symbol).regular),
        identical_(rules.symbol(tree[grid].symbol).identical),
        room_(room),
        count_(along_x ? tree[grid].columns : tree[grid].rows) {}

  /// The current sizes.
  Sizes sizes(int kinds) const {
    Sizes out;
    for (int kind = 1; kind <= kinds; ++kind)
      out.push_back(along_x_ ? tree_[grid_ + kind].width : tree_[grid_ + kind].height);
    return out;
  }

  /// Groups of kinds whose sizes may change together, as indices into `sizes`: single kinds, kinds
  /// that share a line, and all kinds.
  std::set<std::vector<size_t>> groups(size_t kinds) const {
    std::set<std::vector<size_t>> out;
    std::vector<size_t> all(kinds);
    std::iota(all.begin(), all.end(), 0);
    out.insert(all);
    for (const size_t kind : all) out.insert({kind});
    for (int line = 0; line < count_; ++line) {
      std::set<size_t> there;
      for (int other = 0; other < across(); ++other)
        if (const int kind = kind_of(line, other)) there.insert(static_cast<size_t>(kind) - 1);
      if (!there.empty()) out.insert({there.begin(), there.end()});
    }
    return out;
  }

  /// The best lines for windows of these sizes; `gain` receives their gain.
  Lines best(const Sizes& sizes, int min_size, double& gain) const {
    std::vector<std::vector<double>> gains;
    std::vector<int> widest;
    for (int line = 0; line < count_; ++line) {
      widest.push_back(size_of(line, sizes, min_size));
      gains.push_back(table(line, sizes, widest.back()));
    }
    return regular_ ? even(gains, widest, gain) : free(gains, widest, gain);
  }

 private:
  int kind_of(int line, int other) const {
    if (identical_) return 1;
    return along_x_ ? tree_[grid_].kind(line, other) : tree_[grid_].kind(other, line);
  }
  int across() const { return along_x_ ? tree_[grid_].rows : tree_[grid_].columns; }
  static int size_of_kind(const Sizes& sizes, int kind) {
    return sizes[static_cast<size_t>(kind) - 1];
  }
  /// Size of the line's largest window.
  int size_of(int line, const Sizes& sizes, int min_size) const {
    int out = min_size;
    for (int other = 0; other < across(); ++other)
      if (const int kind = kind_of(line, other)) out = std::max(out, size_of_kind(sizes, kind));
    return out;
  }

  std::vector<double> table(int line, const Sizes& sizes, int widest) const {
    std::vector<double> out;
    const Node& grid = tree_[grid_];
    for (int at = 0; at + widest <= room_; ++at) {
      double sum = 0;
      for (int other = 0; other < across(); ++other) {
        const int kind = kind_of(line, other);
        if (kind == 0) continue;
        const int end = at + size_of_kind(sizes, kind);
        const Node& window = tree_[grid_ + kind];
        const auto o = static_cast<size_t>(other);
        sum += along_x_ ? integral_.sum(at, grid.top[o], end, grid.top[o] + window.height)
                        : integral_.sum(grid.left[o], at, grid.left[o] + window.width, end);
      }
      out.push_back(sum);
    }
    return out;
  }

  Lines free(const std::vector<std::vector<double>>& gains, const std::vector<int>& sizes,
             double& gain) const {
    const auto count = static_cast<size_t>(count_);
    // upto[line][at]: largest gain of the lines up to this one if it starts at `at` or before.
    std::vector<std::vector<double>> upto(count);
    std::vector<std::vector<int>> where(count);
    for (size_t line = 0; line < count; ++line) {
      double most = kNever;
      int best = -1;
      for (int at = 0; at < static_cast<int>(gains[line].size()); ++at) {
        double before = 0;
        if (line > 0) {
          const int last =
              std::min(at - sizes[line - 1] - 1, static_cast<int>(upto[line - 1].size()) - 1);
          before = last >= 0 ? upto[line - 1][static_cast<size_t>(last)] : kNever;
        }
        const double sum = before + gains[line][static_cast<size_t>(at)];
        if (sum > most) most = sum, best = at;
        upto[line].push_back(most);
        where[line].push_back(best);
      }
    }
    Lines out{};
    gain = upto.back().empty() ? kNever : upto.back().back();
    if (gain == kNever) return out;
    int last = static_cast<int>(upto.back().size()) - 1;
    for (size_t line = count; line-- > 0;) {
      out[line] = static_cast<int16_t>(where[line][static_cast<size_t>(last)]);
      if (line > 0)
        last =
            std::min(out[line] - sizes[line - 1] - 1, static_cast<int>(upto[line - 1].size()) - 1);
    }
    return out;
  }

  Lines even(const std::vector<std::vector<double>>& gains, const std::vector<int>& sizes,
             double& gain) const {
    const Lines& now = along_x_ ? tree_[grid_].left : tree_[grid_].top;
    const int span = now[static_cast<size_t>(count_ - 1)] - now[0];
    Lines out = now;
    gain = kNever;
    const int widest = *std::max_element(sizes.begin(), sizes.end());
    for (int first = std::max(0, now[0] - kReach); first <= now[0] + kReach; ++first)
      for (int wide = count_ > 1 ? span - kReach : 0; wide <= (count_ > 1 ? span + kReach : 0);
           ++wide) {
        if (count_ > 1 && wide < (widest + 1) * (count_ - 1)) continue;
        if (first + wide + sizes.back() > room_) break;
        const Lines lines = even_lines(first, wide, count_);
        double sum = 0;
        for (size_t line = 0; line < gains.size(); ++line)
          sum += gains[line][static_cast<size_t>(
              std::min<int>(lines[line], static_cast<int>(gains[line].size()) - 1))];
        if (sum > gain) gain = sum, out = lines;
      }
    return out;
  }

  static constexpr int kReach = 24;

  const Tree& tree_;
  const int grid_;
  const FoldedIntegral& integral_;
  const bool along_x_, regular_, identical_;
  const int room_, count_;
};

}  // namespace

bool polish_grid(const MoveContext& context, const Evidence& evidence, TreeState& state, int i) {
  constexpr int kReach = 12;
  const Model& model = context.model;
  const int grid = i + 1;
  if (state.tree[grid].production < 0 || !model.likelihood()) return false;
  const int min_size = model.limits().min_size;
  bool better = false;
  const Gains gains = gains_from_grid(model, evidence, state, i);
  const FoldedIntegral integral(GainMap(evidence, gains), state, state.area(i));
  for (const bool along_x : {true, false}) {
    int kinds = 0;
    while (grid + kinds + 1 < state.tree.end(grid) && model.in_grid(state.tree[grid + kinds + 1]))
      ++kinds;
    const auto axis = [&] {
      return Axis(model.rules(), state.tree, grid, integral,
                  along_x ? usable_width(state.area(i)) : integral.height(), along_x);
    };
    for (const std::vector<size_t>& group : axis().groups(static_cast<size_t>(kinds))) {
      const Axis lines = axis();
      TreeState other = state;
      double most = kNever;
      for (int by = -kReach; by <= kReach; ++by) {
        Axis::Sizes sizes = lines.sizes(kinds);
        for (const size_t kind : group) sizes[kind] += by;
        if (*std::min_element(sizes.begin(), sizes.end()) < min_size) continue;
        double gain = 0;
        const Lines found = lines.best(sizes, min_size, gain);
        if (!(gain > most)) continue;
        most = gain;
        (along_x ? other.tree[grid].left : other.tree[grid].top) = found;
        for (const size_t kind : group) {
          Node& window = other.tree[grid + 1 + static_cast<int>(kind)];
          (along_x ? window.width : window.height) = static_cast<int16_t>(sizes[kind]);
        }
      }
      bool fits = true;
      for (int node = grid; node <= grid + kinds; ++node) {
        other.invalidate_bits(node);
        fits = fits && model.fits(other, node);
      }
      if (fits) better |= replace_if_cheaper(model, state, std::move(other));
    }
  }
  return better;
}

bool polish_type(const MoveContext& context, TreeState& state, int i) {
  const Model& model = context.model;
  const Rules& rules = model.rules();
  bool better = false;
  const TreeState from = state;
  const Node& old = from.tree[i + 1];
  if (old.production < 0) return false;
  const SymbolInfo& was = rules.symbol(old.symbol);
  for (const int id : rules.productions_of(from.tree[i].symbol)) {
    if (rules.production(id).op != Op::grid) continue;
    TreeState other = from;
    Node& grid = other.tree[i + 1];
    const int symbol = rules.production(id).parts[0];
    const SymbolInfo& is = rules.symbol(symbol);
    int windows = -1;
    for (const int at : rules.productions_of(symbol))
      if (rules.production(at).op == Op::windows &&
          rules.production(at).parts == rules.production(old.production).parts)
        windows = at;
    if (windows < 0 || symbol == old.symbol) continue;
    if (was.identical && !is.identical) grid.cells = grid.full_cells();
    if (!was.identical && is.identical) {
      if (grid.cells != grid.full_cells()) continue;
      grid.cells = {};
    }
    if (!was.regular && is.regular) {
      grid.left = nearest_even(grid.left, grid.columns);
      grid.top = nearest_even(grid.top, grid.rows);
    }
    other.tree[i].production = static_cast<int16_t>(id);
    grid.symbol = static_cast<int16_t>(symbol);
    grid.production = static_cast<int16_t>(windows);
    other.invalidate_bits(i), other.invalidate_bits(i + 1);
    if (model.fits(other, i + 1)) better |= replace_if_cheaper(model, state, std::move(other));
  }
  return better;
}

}  // namespace vug::fit
