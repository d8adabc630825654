// SPDX-License-Identifier: Apache-2.0
// Lines of a grid whose windows may differ: moving a line may only pay off if its cells change
// their kinds with it and the sizes of the kinds adapt.
#include <vug/fit/evidence/grid_gains.h>
#include <vug/fit/model/cells.h>
#include <vug/fit/polish/polish.h>

#include <algorithm>
#include <set>

namespace vug::fit {
namespace {

constexpr double kMinCellGain = 1e-9;

/// The window sizes of a grid and the gains of its cells.
class WindowCells {
 public:
  WindowCells(const Model& model, const Evidence& evidence, const TreeState& state, int grid)
      : min_size_(model.limits().min_size), windows_(model, evidence, state, grid) {
    for (int part = grid + 1; part < state.tree.end(grid); ++part)
      if (const Node& node = state.tree[part]; model.in_grid(node))
        sizes_.push_back({node.width, node.height});
  }

  /// Each cell with its best size.
  SizeChoice chosen(const Node& grid) const { return chosen(grid, sizes_); }

  /// Each cell with its best size, with sizes adapted in small steps until none improves.
  SizeChoice followed(const Node& grid) const {
    constexpr int kReach = 2;
    std::vector<WindowSize> sizes = sizes_;
    for (bool better = true; better;) {
      better = false;
      for (size_t k = 0; k < sizes.size(); ++k) {
        const WindowSize old = sizes[k];
        std::vector<WindowSize> others = sizes;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
        const std::vector<double> beside = gains_of(grid, others);
        double most = total_gain(grid, beside, old) + kMinCellGain;
        for (int height = old.height - kReach; height <= old.height + kReach; ++height)
          for (int width = old.width - kReach; width <= old.width + kReach; ++width) {
            if (width < min_size_ || height < min_size_) continue;
            const double gain = total_gain(grid, beside, {width, height});
            if (gain > most) most = gain, sizes[k] = {width, height}, better = true;
          }
      }
    }
    return chosen(grid, sizes);
  }

  int room(bool along_x) const { return windows_.room(along_x); }
  int min_size() const { return min_size_; }

 private:
  template <class Visit>
  static void each(const Node& grid, const Visit& visit) {
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) visit(column, row);
  }

  std::vector<double> gains_of(const Node& grid, const std::vector<WindowSize>& sizes) const {
    std::vector<double> out;
    each(grid, [&](int column, int row) {
      double best = 0;
      for (const WindowSize& size : sizes)
        best = std::max(best, windows_.gain(grid, column, row, size));
      out.push_back(best);
    });
    return out;
  }

  double total_gain(const Node& grid, const std::vector<double>& beside,
                    const WindowSize& size) const {
    double out = 0;
    size_t cell = 0;
    each(grid, [&](int column, int row) {
      out += std::max(beside[cell++], windows_.gain(grid, column, row, size));
    });
    return out;
  }

  SizeChoice chosen(const Node& grid, const std::vector<WindowSize>& sizes) const {
    const int across = grid.columns;
    return best_of_each(sizes, static_cast<size_t>(grid.rows * across), [&](size_t cell, size_t k) {
      const int at = static_cast<int>(cell);
      return windows_.gain(grid, at % across, at / across, sizes[k]);
    });
  }

  int min_size_;
  GridGains windows_;
  std::vector<WindowSize> sizes_;
};

/// Candidate positions of a line: near its current one, and the best one with unchanged sizes.
std::set<int> places(const WindowCells& cells, const Node& grid, bool along_x, int line) {
  constexpr int kReach = 4;
  const Lines& lines = along_x ? grid.left : grid.top;
  const int count = along_x ? grid.columns : grid.rows, now = lines[static_cast<size_t>(line)];
  const auto at = static_cast<size_t>(line);
  const int begin = line > 0 ? lines[at - 1] + cells.min_size() + 1 : 0;
  const int end = (line + 1 < count ? lines[at + 1] - 1 : cells.room(along_x)) - cells.min_size();
  int best = now;
  double most = 0;
  for (int place = begin; place <= end; ++place) {
    Node moved = grid;
    (along_x ? moved.left : moved.top)[at] = static_cast<int16_t>(place);
    if (const double gain = cells.chosen(moved).gain; gain > most) most = gain, best = place;
  }
  std::set<int> out{best};
  for (int place = std::max(begin, now - kReach); place <= std::min(end, now + kReach); ++place)
    out.insert(place);
  return out;
}

}  // namespace

bool polish_cells(const MoveContext& context, const Evidence& evidence, TreeState& state, int i) {
  const Model& model = context.model;
  const int grid = i + 1;
  if (!has_cells(context, state, grid) || !model.likelihood()) return false;
  if (model.rules().symbol(state.tree[grid].symbol).regular) return false;
  bool better = false;
  WindowCells cells(model, evidence, state, grid);
  for (const bool along_x : {true, false})
    for (int line = 0; line < (along_x ? state.tree[grid].columns : state.tree[grid].rows);
         ++line) {
      const Node now = state.tree[grid];
      Node best = now;
      SizeChoice choice = cells.chosen(now);
      for (const int place : places(cells, now, along_x, line)) {
        Node moved = now;
        (along_x ? moved.left : moved.top)[static_cast<size_t>(line)] = static_cast<int16_t>(place);
        SizeChoice here = cells.followed(moved);
        if (here.gain > choice.gain + kMinCellGain) choice = std::move(here), best = moved;
      }
      TreeState other = state;
      other.tree[grid].left = best.left, other.tree[grid].top = best.top;
      if (!replace_if_cheaper(model, state, with_windows(model, std::move(other), grid, choice)))
        continue;
      cells = WindowCells(model, evidence, state, grid);
      better = true;
    }
  return better;
}

}  // namespace vug::fit
