// SPDX-License-Identifier: Apache-2.0
// Cells in columns and rows with margins and gaps. Of the four grids of ripperda2009, a regular
// grid has equal distances between cells, and an identical grid has identical cells.
#include <vug/facade/sequence.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vug::facade {
namespace {

/// Default distances between columns and between storeys, metres.
constexpr double kUsual[] = {2.5, 3};

/// Cells along one axis.
struct Line {
  std::vector<double> at;  ///< Start positions.
  double size = 0;         ///< Size of each cell.
};

struct Grid {
  PartRef cell;
  std::optional<PartRef> door;
  std::optional<int> columns, rows, at;
  std::vector<Size> size, spacing, margin, gap;
  bool regular = true;
  bool identical = true;

  static void describe(Schema<Grid>& s) {
    s.doc(
         "Cells in columns and rows: grid(Bay, columns: 5, rows: 3, gap: 60cm). Counts that are "
         "not given by 'columns', 'rows' or 'spacing' are free, and then sizes and margins, too.")
        .cite("ripperda2009")
        .param("cell", &Grid::cell, {.doc = "the part in the cells", .required = true})
        .param("door", &Grid::door,
               {.doc = "a part in one cell of the lowest row, extended to the ground"})
        .param("columns", &Grid::columns, {.doc = "number of them", .min = 1, .max = 1000})
        .param("rows", &Grid::rows, {.doc = "number of them", .min = 1, .max = 1000})
        .param("at", &Grid::at, {.doc = "0-based column of the door; default: free", .min = 0})
        .param("size", &Grid::size, {.doc = "width and height of a cell, or one number for both"})
        .param("spacing", &Grid::spacing,
               {.doc = "distance between cells in x and y, or one number for both: as many as fit, "
                       "stretched"})
        .param(
            "margin", &Grid::margin,
            {.doc =
                 "left, right, below and above; or two numbers: at the sides, below and above; or "
                 "one number for all"})
        .param("gap", &Grid::gap, {.doc = "gap between cells in x and y, or one number for both"})
        .param("regular", &Grid::regular,
               {.doc = "true: equal distances between cells; false: free distances"})
        .param("identical", &Grid::identical, {.doc = "all cells are identical and derived once"});
  }
  std::string fault() const {
    const auto pair = [](const std::vector<Size>& list) { return list.size() <= 2; };
    if (!pair(size) || !pair(spacing) || !pair(gap))
      return "'size', 'spacing' and 'gap' must be one or two numbers";
    if (margin.size() == 3 || margin.size() > 4) return "'margin' must be one, two or four numbers";
    if (!size.empty() && !gap.empty()) return "'size' and 'gap' cannot be combined";
    for (const auto* list : {&size, &spacing})
      for (const Size& one : *list)
        if (!(one.number.value > 0)) return "sizes and spacings must be above 0";
    for (const auto* list : {&margin, &gap})
      for (const Size& one : *list)
        if (!(one.number.value >= 0)) return "margins and gaps must be 0 or more";
    if (at && !door) return "'at' is the door's column, but no door is given";
    return "";
  }

  /// The element of a list for one axis (0 or 1), or nothing.
  static std::optional<double> given(const std::vector<Size>& list, size_t axis, double extent) {
    if (list.empty()) return std::nullopt;
    return resolve_size(list[std::min(axis, list.size() - 1)].number, extent);
  }
  double margin_of(size_t side, double extent) const {
    if (margin.empty()) return 0;
    return resolve_size(margin[margin.size() == 4   ? side
                               : margin.size() == 2 ? side / 2
                                                    : 0]
                            .number,
                        extent);
  }

  Line line(size_t axis, double extent, FreeNumbers& free) const {
    const std::optional<int>& asked = axis == 0 ? columns : rows;
    double before = margin_of(2 * axis, extent), behind = margin_of(2 * axis + 1, extent);
    const RandomKey key = free.key().at(axis == 0 ? "columns" : "rows");
    const std::optional<double> pitch = given(spacing, axis, extent);
    std::optional<double> cell_size = given(size, axis, extent);
    const double between = given(gap, axis, extent).value_or(0);
    RandomStream random(key);
    int n = asked.value_or(1);
    const bool open = !asked && !pitch;
    if (open) {
      n = free.count(names(axis).count, 1, 1000, std::clamp(extent / kUsual[axis], 1.0, 20.0), [&] {
        const int most = std::clamp(static_cast<int>(extent / 2), 1, 20);
        return 1 + static_cast<int>(random.below(static_cast<uint32_t>(most)));
      });
      if (!free.is_random()) return told_line(axis, extent, n, free);
      if (margin.empty()) before = behind = random.uniform(0.05, 0.5) * extent / n;
    }
    const double inner = extent - before - behind;
    if (!asked && pitch) n = std::clamp(static_cast<int>(inner / *pitch + 1e-9), 1, 1000);
    if (open && !cell_size && gap.empty()) cell_size = random.uniform(0.3, 0.8) * inner / n;
    const double width = cell_size ? *cell_size : (inner - (n - 1) * between) / n;
    if (!(width > 0) || n * width > inner * (1 + 1e-9))
      throw Error(ErrorCode::bad_input,
                  fmt::format("{} {} do not fit into {}", n, axis == 0 ? "columns" : "rows",
                              quantity_text(inner, Dimension::length)));
    // Cells with a given size are centred in equal strips if they have a spacing or a count, and
    // extend from margin to margin if they have margins or are free.
    const double left_over = inner - n * width;
    const bool justified = !cell_size || open || !margin.empty();
    const double gaps = justified ? n - 1 : n;
    Line out;
    out.size = width;
    std::vector<double> spaces(static_cast<size_t>(std::max(1, n - 1)),
                               gaps > 0 ? left_over / gaps : 0);
    if (!regular && n > 1) {
      const double total = justified ? left_over : left_over * (n - 1) / n;
      const double walked = total + width * (n - 1);
      spaces = free.is_random() ? free.shares("", "", spaces.size(), total, key.at("spaces"))
                                : free.shares(names(axis).pitch, "", spaces.size(), walked, key);
      if (!free.is_random())
        for (double& space : spaces) space = gap_of(space, width, axis);
    }
    double start = before + (justified ? (n == 1 ? left_over / 2 : 0) : left_over / n / 2);
    for (int i = 0; i < n; ++i) {
      out.at.push_back(start);
      if (i + 1 < n) start += width + spaces[static_cast<size_t>(i)];
    }
    return out;
  }

  /// Names of the free numbers along an axis.
  struct Names {
    const char *count, *start, *size, *pitch;
  };
  static const Names& names(size_t axis) {
    static const Names all[] = {{"columns", "x", "width", "dx"}, {"rows", "y", "height", "dy"}};
    return all[axis];
  }

  /// The gap between two cells at that distance. Throws InfeasiblePlan if they would overlap.
  static double gap_of(double pitch, double width, size_t axis) {
    if (pitch < width * (1 - 1e-9))
      throw InfeasiblePlan(Reason::does_not_fit, names(axis).pitch,
                           fmt::format("cells of {} overlap at a distance of {}",
                                       quantity_text(width, Dimension::length),
                                       quantity_text(pitch, Dimension::length)),
                           fmt::format("reduce '{}'", names(axis).size));
    return std::max(0.0, pitch - width);
  }

  /// The layout without given counts and spacings: a model specifies the start of the first cell,
  /// the size of cells and the distances between them, unless margins, sizes or gaps are given.
  Line told_line(size_t axis, double extent, int n, FreeNumbers& free) const {
    const Names& name = names(axis);
    const double before = margin_of(2 * axis, extent), behind = margin_of(2 * axis + 1, extent);
    const double inner = extent - before - behind, even = inner / n;
    const auto count = static_cast<size_t>(n);
    const std::optional<double> between = given(gap, axis, extent);
    std::optional<double> size_here = given(size, axis, extent);
    if (between) size_here = (inner - (n - 1) * *between) / n;
    const double width = size_here ? *size_here : free.length(name.size, 0, even, 0.5 * even);
    if (!(width > 0) || n * width > inner * (1 + 1e-9))
      throw InfeasiblePlan(Reason::does_not_fit, name.count,
                           fmt::format("{} {} do not fit into {}", n, name.count,
                                       quantity_text(inner, Dimension::length)));
    Line out;
    out.size = width;
    std::vector<double> pitches(count - 1, 0.0);
    const double least = width * (1 - 1e-9);
    double start = before;
    if (!margin.empty() || between) {
      // From margin to margin.
      const double walk = inner - width;
      if (n == 1) start += walk / 2;
      if (regular || n < 3)
        pitches.assign(count - 1, n > 1 ? walk / (n - 1) : 0);
      else
        pitches = free.shares(name.pitch, name.count, count - 1, walk, free.key());
    } else {
      const double room = extent - width;
      const bool placed = free.is_fixed(name.start), spaced = free.is_fixed(name.pitch);
      // By default the spaces before the first cell and after the last one are equal.
      if (!spaced || placed)
        start = free.length(name.start, 0, room - (n - 1) * width, 0.5 * (even - width));
      if (n > 1) {
        const double usual = !placed ? even : std::max(width, (room - 2 * start) / (n - 1));
        const double most = room - (spaced && !placed ? 0 : start) - (n - 2) * width;
        pitches = free.lengths(name.pitch, regular ? "" : name.count, regular ? 1 : count - 1,
                               least, most, std::min(usual, most));
        if (regular) pitches.resize(count - 1, pitches[0]);
      }
      const double walk = std::accumulate(pitches.begin(), pitches.end(), 0.0);
      const double usual = std::max(0.0, (room - walk) / 2);
      if (spaced && !placed) start = free.length(name.start, 0, std::max(0.0, room), usual);
      if (start + walk > room * (1 + 1e-9) + 1e-9)
        throw InfeasiblePlan(Reason::does_not_fit, spaced ? name.pitch : name.start,
                             fmt::format("the {} need {} of {}", name.count,
                                         quantity_text(start + walk + width, Dimension::length),
                                         quantity_text(extent, Dimension::length)));
    }
    out.at.push_back(start);
    for (const double pitch : pitches)
      out.at.push_back(out.at.back() + width + gap_of(pitch, width, axis));
    return out;
  }

  /// The numbers stored in the model: counts, the position of the first cell, and the distances, of
  /// which a regular grid has one per axis.
  Numbers numbers(const Line& x, const Line& y) const {
    Numbers out = {{"columns", static_cast<double>(x.at.size())},
                   {"rows", static_cast<double>(y.at.size())},
                   {"x", x.at[0]},
                   {"y", y.at[0]}};
    for (const auto& [name, line] : {std::pair("dx", &x), std::pair("dy", &y)}) {
      if (line->at.size() == 1) out.emplace_back(name, 0);
      for (size_t i = 1; i < (regular ? std::min<size_t>(2, line->at.size()) : line->at.size());
           ++i)
        out.emplace_back(name, line->at[i] - line->at[i - 1]);
    }
    return out;
  }

  int door_column(uint32_t across, FreeNumbers& free) const {
    if (at) return *at;
    const auto draw = [&] {
      return static_cast<int>(RandomStream(free.key().at("door")).below(across));
    };
    if (!door) return 0;
    const uint32_t middle = (across - 1) / 2;
    return free.count("door", 0, static_cast<int>(across) - 1, middle, draw);
  }

  Layout layout(double width, double height, FreeNumbers& free) const {
    const Line x = line(0, width, free);
    const Line y = line(1, height, free);
    const auto across = static_cast<uint32_t>(x.at.size());
    const auto entrance = static_cast<uint32_t>(door_column(across, free));
    if (door && entrance >= across)
      throw Error(ErrorCode::bad_input,
                  fmt::format("the door's column is {} of {}", entrance, across), {},
                  "columns are counted from 0");
    Layout out;
    out.numbers = numbers(x, y);
    const Rect way{x.at[entrance], 0, x.size, y.at[0] + y.size};
    const auto total = static_cast<int64_t>(x.at.size() * y.at.size());
    for (size_t row = 0; row < y.at.size(); ++row)
      for (size_t column = 0; column < x.at.size(); ++column) {
        if (door && row == 0 && column == entrance) continue;
        const Rect rect{x.at[column], y.at[row], x.size, y.size};
        const bool first = out.cells.empty();
        const bool same = identical && !free.apart();
        if (first || !same)
          out.cells.push_back({.part = cell.part,
                               .rect = rect,
                               .index = static_cast<int64_t>(row * x.at.size() + column),
                               .total = total,
                               .column = same ? 0 : static_cast<int>(column),
                               .row = same ? 0 : static_cast<int>(row)});
        else
          out.cells[0].copies.push_back(
              Placement::shift(rect.x - out.cells[0].rect.x, rect.y - out.cells[0].rect.y));
      }
    if (door) out.cells.push_back({.part = door->part, .rect = way, .row = -1});
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_SPLIT_KIND(grid) { return split_kind<Grid>("grid"); }
