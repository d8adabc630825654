#include <vug/fit/seeds.h>
#include <vug/fit/segments.h>
#include <vug/inference/bits.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace vug::fit {
namespace {

double gain_of(const Gains& gains, const Sums& sums) {
  double out = 0;
  for (size_t i = 0; i < gains.size(); ++i) out += gains[i] * sums.lane[i];
  return out;
}

/// Columns and rows of windows in a rectangle of the picture, in its own coordinates.
struct Layout {
  std::vector<Segment> columns, rows;
  bool empty() const { return columns.empty() || rows.empty(); }
};

/// What lies before each place along one axis, summed over the segments of the other one; without
/// segments over all, less the mean, which shows where anything may be at all.
std::vector<double> before(const Evidence& evidence, const Gains& gains, const Rect& area,
                           bool along_x, const std::vector<Segment>& across) {
  const int room = along_x ? area.x1 - area.x0 : area.y1 - area.y0;
  std::vector<double> out(static_cast<size_t>(room) + 1, 0);
  const auto strip = [&](int end, int low, int high) {
    return gain_of(gains,
                   along_x ? evidence.sums(area.x0, area.y0 + low, area.x0 + end, area.y0 + high)
                           : evidence.sums(area.x0 + low, area.y0, area.x0 + high, area.y0 + end));
  };
  for (int end = 1; end <= room; ++end)
    for (const Segment& segment : across)
      out[static_cast<size_t>(end)] += strip(end, segment.start, segment.end);
  if (!across.empty()) return out;
  const int other = along_x ? area.y1 - area.y0 : area.x1 - area.x0;
  const double mean = strip(room, 0, other) / room;
  for (int end = 1; end <= room; ++end)
    out[static_cast<size_t>(end)] = strip(end, 0, other) - mean * end;
  return out;
}

Sums in_area(const Evidence& evidence, const Rect& area, const Segment& x, const Segment& y) {
  return evidence.sums(area.x0 + x.start, area.y0 + y.start, area.x0 + x.end, area.y0 + y.end);
}

Layout lay_out(const Workshop& shop, const Evidence& evidence, const Rect& area, Gains& gains,
               bool supervised, int rounds) {
  const Limits& limits = shop.model.limits();
  Layout out;
  const double cost = bits_for(evidence.width()) + bits_for(evidence.height());
  const auto find = [&](bool along_x, const std::vector<Segment>& across) {
    const int room = along_x ? area.x1 - area.x0 : area.y1 - area.y0;
    return best_segments(before(evidence, gains, area, along_x, across),
                         {limits.least, room / 4, limits.most_lines, cost});
  };
  out.columns = find(true, {});
  out.rows = find(false, {});
  for (int round = 0; round < rounds && !out.empty(); ++round) {
    out.columns = find(true, out.rows);
    if (out.empty()) break;
    out.rows = find(false, out.columns);
    if (out.empty() || supervised) continue;
    Sums windows, wall = evidence.sums(area.x0, area.y0, area.x1, area.y1);
    for (const Segment& x : out.columns)
      for (const Segment& y : out.rows) windows += in_area(evidence, area, x, y);
    wall -= windows;
    gains = gains_of_regions(windows, wall, evidence.lanes());
  }
  return out;
}

/// Sizes that are near to each other made equal, and each segment's group.
struct Groups {
  std::vector<int> sizes;  ///< Of the groups.
  std::vector<size_t> of;  ///< The group of each segment.
};

Groups grouped(const std::vector<Segment>& segments, int tolerance) {
  std::vector<size_t> order(segments.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return segments[a].size() < segments[b].size(); });
  Groups out;
  out.of.resize(segments.size());
  for (size_t begin = 0; begin < order.size();) {
    size_t end = begin;
    int sum = 0;
    while (end < order.size() &&
           segments[order[end]].size() - segments[order[begin]].size() <= tolerance)
      sum += segments[order[end++]].size();
    const auto count = static_cast<int>(end - begin);
    for (size_t i = begin; i < end; ++i) out.of[order[i]] = out.sizes.size();
    out.sizes.push_back((sum + count / 2) / count);
    begin = end;
  }
  return out;
}

/// Where segments begin once they have their group's size, centred as before.
Lines starts(const std::vector<Segment>& segments, const Groups& groups) {
  Lines out{};
  for (size_t i = 0; i < segments.size(); ++i)
    out[i] = static_cast<int16_t>(
        std::max(0, segments[i].start + (segments[i].size() - groups.sizes[groups.of[i]]) / 2));
  return out;
}

/// The production of a symbol to a grid whose lines are free, identical or not; -1.
int way_to_grid(const Rules& rules, int symbol, bool identical) {
  for (const int way : rules.productions_of(symbol)) {
    const Production& production = rules.production(way);
    if (production.op != Op::grid) continue;
    const SymbolInfo& grid = rules.symbol(production.parts[0]);
    if (!grid.regular && grid.identical == identical) return way;
  }
  return -1;
}

int way_to_windows(const Rules& rules, int grid) {
  for (const int way : rules.productions_of(grid))
    if (rules.production(way).op == Op::windows && rules.production(way).parts.size() == 1)
      return way;
  return -1;
}

/// Rewrites node i into a grid of that layout and its windows; sizes that differ by no more than
/// the tolerance become one. False where the rules cannot, or kinds are too many.
bool put_grid(const Workshop& shop, State& state, int i, const Layout& layout, bool identical,
              int tolerance, const Evidence& evidence, const Rect& area, const Gains& gains) {
  const Rules& rules = shop.model.rules();
  const int way = way_to_grid(rules, state.tree[i].symbol, identical);
  if (way < 0) return false;
  const int symbol = rules.production(way).parts[0], windows = way_to_windows(rules, symbol);
  if (windows < 0) return false;
  const Groups widths = grouped(layout.columns, tolerance),
               heights = grouped(layout.rows, tolerance);
  const size_t kinds = widths.sizes.size() * heights.sizes.size();
  if (kinds > (identical ? 1 : static_cast<size_t>(shop.model.limits().most_kinds))) return false;
  Node grid;
  grid.symbol = static_cast<int16_t>(symbol);
  grid.made_by = static_cast<int8_t>(Op::grid);
  grid.columns = static_cast<int16_t>(layout.columns.size());
  grid.rows = static_cast<int16_t>(layout.rows.size());
  grid.left = starts(layout.columns, widths);
  grid.top = starts(layout.rows, heights);
  std::vector<Node> parts;
  for (const int height : heights.sizes)
    for (const int width : widths.sizes) {
      Node window;
      window.symbol = static_cast<int16_t>(rules.production(windows).parts[0]);
      window.made_by = static_cast<int8_t>(Op::windows);
      window.width = static_cast<int16_t>(width);
      window.height = static_cast<int16_t>(height);
      parts.push_back(window);
    }
  for (size_t row = 0; !identical && row < layout.rows.size(); ++row)
    for (size_t column = 0; column < layout.columns.size(); ++column) {
      const Sums cell = in_area(evidence, area, layout.columns[column], layout.rows[row]);
      const size_t kind = heights.of[row] * widths.sizes.size() + widths.of[column] + 1;
      if (gain_of(gains, cell) > 0)
        grid.set_kind(static_cast<int>(column), static_cast<int>(row), static_cast<int>(kind));
    }
  state.grow(i, way, {grid});
  state.grow(i + 1, windows, parts);
  return true;
}

/// The axiom divided into a ground floor of that height and the rest, if the rules can.
std::optional<State> divided(const Workshop& shop, int floor) {
  const Rules& rules = shop.model.rules();
  State state = shop.model.start();
  if (floor == 0) return state;
  for (const int way : rules.productions_of(rules.axiom)) {
    const Production& production = rules.production(way);
    if (production.op != Op::rows) continue;
    Node row, part;
    row.symbol = static_cast<int16_t>(production.parts[0]);
    part.symbol = static_cast<int16_t>(production.parts[1]);
    row.made_by = part.made_by = static_cast<int8_t>(Op::rows);
    row.extent = static_cast<int16_t>(floor);
    state.grow(0, way, {row, part});
    return state;
  }
  return std::nullopt;
}

/// Where to begin with clusters: each may be what windows are made of.
std::vector<Gains> first_gains(const Evidence& evidence, bool supervised) {
  if (supervised) return {gains_of_looks()};
  std::vector<Gains> out;
  const Sums all = evidence.sums(0, 0, evidence.width(), evidence.height());
  const double pixels = static_cast<double>(evidence.width()) * evidence.height();
  // By day windows are among what is darker.
  for (int cluster = 0; 2 * cluster < evidence.lanes(); ++cluster) {
    Sums windows = all;
    // As if a quarter of the picture were windows, and six in ten of their pixels were of it.
    for (uint32_t& n : windows.lane) n = static_cast<uint32_t>(0.1 * n);
    windows.lane[static_cast<size_t>(cluster)] += static_cast<uint32_t>(0.15 * pixels);
    out.push_back(gains_of_regions(windows, all, evidence.lanes()));
  }
  return out;
}

}  // namespace

Gains gains_of_looks() {
  Gains out{};
  out[static_cast<size_t>(Look::wall)] = kBitStep;
  out[static_cast<size_t>(Look::window)] = -kBitStep;
  return out;
}

Gains gains_of_regions(const Sums& windows, const Sums& wall, int lanes) {
  Gains out{};
  double all_windows = 0, all_wall = 0;
  for (size_t i = 0; i < static_cast<size_t>(lanes); ++i) {
    all_windows += windows.lane[i] + 0.5;
    all_wall += wall.lane[i] + 0.5;
  }
  for (size_t i = 0; i < static_cast<size_t>(lanes); ++i)
    out[i] =
        inference::log2((windows.lane[i] + 0.5) / all_windows * all_wall / (wall.lane[i] + 0.5));
  return out;
}

std::vector<State> seeds(const Workshop& shop, const Evidence& evidence, bool supervised,
                         const SeedOptions& options) {
  const int height = evidence.height();
  std::vector<std::pair<double, State>> found;
  for (int step = 0; step <= options.floors; ++step) {
    const int floor = step == 0 ? 0 : height * (step + 1) / (2 * options.floors + 2);
    for (Gains gains : first_gains(evidence, supervised)) {
      const Rect area{0, 0, evidence.width(), height - floor};
      const Layout layout = lay_out(shop, evidence, area, gains, supervised, options.rounds);
      if (layout.empty()) continue;
      const auto add = [&](bool identical, int tolerance) {
        std::optional<State> state = divided(shop, floor);
        if (!state) return;
        const int part = floor > 0 ? state->tree.size() - 1 : 0;
        if (!put_grid(shop, *state, part, layout, identical, tolerance, evidence, area, gains))
          return;
        const double energy = shop.model.energy(*state);
        if (std::isfinite(energy)) found.emplace_back(energy, std::move(*state));
      };
      add(true, std::max(evidence.width(), height));
      for (const int tolerance : {0, 1, 2, 3, 5, 8, 12, 20}) add(false, tolerance);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<State> out;
  for (auto& [energy, state] : found) out.push_back(std::move(state));
  return out;
}

}  // namespace vug::fit
