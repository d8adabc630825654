// Kinds of a grid's windows: one is told apart or two are joined, whichever costs least, step after
// step, also where that costs more at first. Bits of cells grow only where the kinds pass a power
// of two, so that chains, which walk by single steps, are held back by what costs nothing further
// on.
#include <vug/fit/cells.h>
#include <vug/fit/polish.h>

#include <cmath>
#include <limits>
#include <optional>

namespace vug::fit {
namespace {

/// Of one grid whose windows may differ.
class Kinds {
 public:
  Kinds(const Workshop& shop, int grid) : shop_(shop), model_(shop.model), grid_(grid) {}

  /// The best state on a way of that many steps that each do what costs least.
  State walked(const State& from, bool split, int steps) const {
    State here = from, best = from;
    for (int step = 0; step < steps; ++step) {
      std::optional<State> next = split ? split_once(here) : joined_once(here);
      if (!next) break;
      settle(*next);
      here = std::move(*next);
      State copy = here;
      take_cheaper(model_, best, std::move(copy));
    }
    return best;
  }

  /// Sizes and cells as good as they get one after the other.
  void settle(State& state) const {
    for (bool better = true; better;) {
      better = false;
      for (int kind = 1; kind <= count(state); ++kind) better |= resize(state, kind, kReach);
      better |= choose_cells(state);
    }
  }

 private:
  static constexpr int kReach = 3;

  int count(const State& state) const {
    int out = 0;
    for (int part = grid_ + 1; part < state.tree.end(grid_); ++part)
      out += model_.in_grid(state.tree[part]) ? 1 : 0;
    return out;
  }
  double energy(State& state) const {
    state.changed(grid_);
    const bool fits = state.placed ? model_.fits(state, grid_) : true;
    return fits ? model_.energy(state) : std::numeric_limits<double>::infinity();
  }

  /// The best width, then the best height, of a kind near to what they are.
  bool resize(State& state, int kind, int reach) const {
    const double before = energy(state);
    double least = before;
    for (const bool along_x : {true, false}) {
      int16_t& size = along_x ? state.tree[grid_ + kind].width : state.tree[grid_ + kind].height;
      const int16_t old = size;
      int16_t best = old;
      for (int by = -reach; by <= reach; ++by) {
        size = static_cast<int16_t>(old + by);
        if (size < model_.limits().least) continue;
        state.changed(grid_ + kind);
        const double bits = energy(state);
        if (bits < least - kTiny) least = bits, best = size;
      }
      size = best;
      state.changed(grid_ + kind);
    }
    energy(state);
    return least < before;
  }

  bool choose_cells(State& state) const {
    double least = energy(state);
    bool better = false;
    Node& grid = state.tree[grid_];
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        int best = grid.kind(column, row);
        for (int kind = 0; kind <= count(state); ++kind) {
          grid.set_kind(column, row, kind);
          const double bits = energy(state);
          if (bits < least - kTiny) least = bits, best = kind, better = true;
        }
        grid.set_kind(column, row, best);
      }
    energy(state);
    return better;
  }

  void take_out(State& state, int kind, int by) const {
    Node& grid = state.tree[grid_];
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        const int now = grid.kind(column, row), then = now == kind ? by : now;
        grid.set_kind(column, row, then > kind ? then - 1 : then);
      }
    state.erase(grid_, grid_ + kind);
  }

  std::optional<State> joined_once(const State& from) const {
    std::optional<State> best;
    double least = std::numeric_limits<double>::infinity();
    for (int kind = 1; kind <= count(from); ++kind)
      for (int by = 1; by <= count(from); ++by) {
        if (by == kind) continue;
        State other = from;
        take_out(other, kind, by);
        if (!std::isfinite(energy(other))) continue;
        resize(other, by > kind ? by - 1 : by, 1);
        const double bits = energy(other);
        if (bits < least) least = bits, best = std::move(other);
      }
    return best;
  }

  std::optional<State> split_once(const State& from) const {
    const int kinds = count(from);
    if (kinds >= model_.limits().most_kinds) return std::nullopt;
    std::optional<State> best;
    double least = std::numeric_limits<double>::infinity();
    for (const bool along_x : {true, false})
      for (int kind = 1; kind <= kinds; ++kind) {
        const Node& grid = from.tree[grid_];
        for (int line = 0; line < (along_x ? grid.columns : grid.rows); ++line) {
          State other = from;
          if (!split_line(other, along_x, line, kind, kinds + 1)) continue;
          if (!std::isfinite(energy(other))) continue;
          resize(other, kinds + 1, kReach);
          const double bits = energy(other);
          if (bits < least) least = bits, best = std::move(other);
        }
      }
    return best;
  }

  /// Gives windows of the kind in a line a kind of their own; false where none or all are there.
  bool split_line(State& state, bool along_x, int line, int kind, int fresh) const {
    Node& grid = state.tree[grid_];
    int there = 0, elsewhere = 0;
    for (int row = 0; row < grid.rows; ++row)
      for (int column = 0; column < grid.columns; ++column) {
        if (grid.kind(column, row) != kind) continue;
        const bool in = (along_x ? column : row) == line;
        if (in) grid.set_kind(column, row, fresh);
        ++(in ? there : elsewhere);
      }
    if (there == 0 || elsewhere == 0) return false;
    state.insert(grid_, grid_ + fresh, state.tree[grid_ + kind]);
    return true;
  }

  static constexpr double kTiny = 1e-9;

  const Workshop& shop_;
  const Model& model_;
  const int grid_;
};

}  // namespace

bool polish_kinds(const Workshop& shop, State& state, int i) {
  constexpr int kSplits = 4, kJoins = kMostKinds;
  if (!has_cells(shop, state, i + 1)) return false;
  const Kinds kinds(shop, i + 1);
  State best = state;
  kinds.settle(best);
  for (bool better = true; better;) {
    State other = kinds.walked(best, true, kSplits);
    better = take_cheaper(shop.model, best, std::move(other));
    other = kinds.walked(best, false, kJoins);
    better |= take_cheaper(shop.model, best, std::move(other));
  }
  return take_cheaper(shop.model, state, std::move(best));
}

}  // namespace vug::fit
