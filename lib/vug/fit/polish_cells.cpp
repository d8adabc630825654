// Lines of a grid whose windows may differ: a line that moves may be worth it only if its cells
// become other kinds with it, and sizes of kinds follow.
#include <vug/fit/cells.h>
#include <vug/fit/polish.h>
#include <vug/fit/sheet.h>

#include <algorithm>
#include <set>

namespace vug::fit {
namespace {

constexpr double kTiny = 1e-9;

/// The sizes that a grid's windows have, and what its cells gain by them.
class CellGains {
 public:
  CellGains(const Model& model, const Evidence& evidence, const State& state, int grid)
      : least_(model.limits().least),
        area_(state.area(grid)),
        sheet_(GainMap(evidence, gains_in(model, evidence, state, grid - 1)), state, area_) {
    for (int part = grid + 1; part < state.tree.end(grid); ++part) {
      const Node& node = state.tree[part];
      if (model.in_grid(node))
        sizes_.push_back({node.width, node.height});
      else
        door_ = rect_of(node);
    }
  }

  /// Each cell with what gains most there.
  SizeChoice chosen(const Node& grid) const { return chosen(grid, sizes_); }

  /// The same, and sizes that follow by small steps until none gains.
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
        double most = beside_gain(grid, beside, old) + kTiny;
        for (int height = old.height - kReach; height <= old.height + kReach; ++height)
          for (int width = old.width - kReach; width <= old.width + kReach; ++width) {
            if (width < least_ || height < least_) continue;
            const double gain = beside_gain(grid, beside, {width, height});
            if (gain > most) most = gain, sizes[k] = {width, height}, better = true;
          }
      }
    }
    return chosen(grid, sizes);
  }

  int room(bool along_x) const { return along_x ? columns_room(area_) : area_.height; }
  int least() const { return least_; }

 private:
  template <class Visit>
  static void each(const Node& grid, const Visit& visit) {
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) visit(column, row);
  }

  double gain(const Node& grid, int column, int row, const WindowSize& size) const {
    const auto c = static_cast<size_t>(column), r = static_cast<size_t>(row);
    const int x = grid.left[c], y = grid.top[r];
    const Rect rect{x, y, x + size.width, y + size.height};
    const int right = column + 1 < grid.columns ? grid.left[c + 1] - 1 : room(true);
    const int bottom = row + 1 < grid.rows ? grid.top[r + 1] - 1 : room(false);
    if (rect.x1 > right || rect.y1 > bottom || overlap(rect, door_)) return 0;
    return sheet_.sum(rect.x0, rect.y0, rect.x1, rect.y1);
  }

  std::vector<double> gains_of(const Node& grid, const std::vector<WindowSize>& sizes) const {
    std::vector<double> out;
    each(grid, [&](int column, int row) {
      double best = 0;
      for (const WindowSize& size : sizes) best = std::max(best, gain(grid, column, row, size));
      out.push_back(best);
    });
    return out;
  }

  double beside_gain(const Node& grid, const std::vector<double>& beside,
                     const WindowSize& size) const {
    double out = 0;
    size_t cell = 0;
    each(grid, [&](int column, int row) {
      out += std::max(beside[cell++], gain(grid, column, row, size));
    });
    return out;
  }

  SizeChoice chosen(const Node& grid, const std::vector<WindowSize>& sizes) const {
    SizeChoice out;
    out.sizes = sizes;
    each(grid, [&](int column, int row) {
      double most = 0;
      int best = 0;
      for (size_t k = 0; k < sizes.size(); ++k)
        if (const double here = gain(grid, column, row, sizes[k]); here > most)
          most = here, best = static_cast<int>(k) + 1;
      out.of.push_back(best);
      out.gain += most;
    });
    return out;
  }

  const int least_;
  const Area area_;
  const Sheet sheet_;
  std::vector<WindowSize> sizes_;
  Rect door_{};
};

/// Places for a line: near to where it is, and where most is gained without other sizes.
std::set<int> places(const CellGains& cells, const Node& grid, bool along_x, int line) {
  constexpr int kReach = 4;
  const Lines& lines = along_x ? grid.left : grid.top;
  const int count = along_x ? grid.columns : grid.rows, now = lines[static_cast<size_t>(line)];
  const auto at = static_cast<size_t>(line);
  const int begin = line > 0 ? lines[at - 1] + cells.least() + 1 : 0;
  const int end = (line + 1 < count ? lines[at + 1] - 1 : cells.room(along_x)) - cells.least();
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

bool polish_cells(const Workshop& shop, const Evidence& evidence, State& state, int i) {
  const Model& model = shop.model;
  const int grid = i + 1;
  if (!has_cells(shop, state, grid) || !model.likelihood()) return false;
  if (model.rules().symbol(state.tree[grid].symbol).regular) return false;
  bool better = false;
  for (const bool along_x : {true, false})
    for (int line = 0; line < (along_x ? state.tree[grid].columns : state.tree[grid].rows);
         ++line) {
      const CellGains cells(model, evidence, state, grid);
      const Node now = state.tree[grid];
      Node best = now;
      SizeChoice choice = cells.chosen(now);
      for (const int place : places(cells, now, along_x, line)) {
        Node moved = now;
        (along_x ? moved.left : moved.top)[static_cast<size_t>(line)] = static_cast<int16_t>(place);
        SizeChoice here = cells.followed(moved);
        if (here.gain > choice.gain + kTiny) choice = std::move(here), best = moved;
      }
      State other = state;
      other.tree[grid].left = best.left, other.tree[grid].top = best.top;
      better |= take_cheaper(model, state, with_windows(model, std::move(other), grid, choice));
    }
  return better;
}

}  // namespace vug::fit
