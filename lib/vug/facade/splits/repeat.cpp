// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/sequence.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::facade {
namespace {

enum class Axis { x, y };

struct Repeat {
  Axis axis = Axis::x;
  std::vector<SizeOrPart> parts;
  std::optional<int> count;
  double gap = 0;
  bool alike = true;
  bool even = true;

  static void describe(Schema<Repeat>& s) {
    s.doc(
         "A repeated part: repeat(x, 2.4m, Bay) as often as it fits, stretched to fill the extent, "
         "or repeat(x, Bay, count: 5). Without a size and a count, the count is free.")
        .cite("ripperda2009")
        .choice("axis", &Repeat::axis, {{"x", Axis::x}, {"y", Axis::y}},
                "x: side by side, y: one above the other")
        .param("parts", &Repeat::parts,
               {.doc = "the part, optionally preceded by its size", .required = true})
        .param("count", &Repeat::count, {.doc = "number of repetitions", .min = 1, .max = 10000})
        .param("gap", &Repeat::gap,
               {.doc = "gap between two repetitions", .dimension = Dimension::length, .min = 0})
        .param("alike", &Repeat::alike, {.doc = "all repetitions are identical and derived once"})
        .param("even", &Repeat::even, {.doc = "true: equal sizes; false: free sizes"});
  }
  std::string fault() const {
    std::string fault;
    const std::vector<SizedPart> all = sized_parts(parts, fault);
    if (!fault.empty()) return fault;
    if (all.size() > 1) return "'repeat' takes a single part";
    if (all[0].size && count) return "a size and a count cannot be combined";
    if (!even && alike && count.value_or(2) > 1)
      return "identical repetitions have the same size: 'alike' requires 'even'";
    return "";
  }

  int copy_count(double extent, FreeNumbers& free) const {
    std::string none;
    const std::vector<SizedPart> all = sized_parts(parts, none);
    if (count) return *count;
    if (all[0].size) {
      const double fits = (extent + gap) / (resolve_size(*all[0].size, extent) + gap);
      if (fits > 10000)
        throw Error(ErrorCode::too_large,
                    fmt::format("'{}' would be repeated {:.3g} times", all[0].part.name, fits));
      return std::max(1, static_cast<int>(std::floor(fits + 1e-9)));
    }
    const int most = std::clamp(static_cast<int>(extent), 2, 12);
    return free.count("count", 1, 1000, std::clamp(extent / 3, 2.0, 12.0), [&] {
      return 2 + static_cast<int>(
                     RandomStream(free.key().at("count")).below(static_cast<uint32_t>(most - 1)));
    });
  }

  Layout layout(double width, double height, FreeNumbers& free) const {
    std::string none;
    const int part = sized_parts(parts, none)[0].part.part;
    const double extent = axis == Axis::x ? width : height;
    const int n = copy_count(extent, free);
    const double filled = extent - (n - 1) * gap;
    if (!(filled > 0))
      throw Error(ErrorCode::bad_input, fmt::format("the gaps of {} parts need {} of {}", n,
                                                    quantity_text((n - 1) * gap, Dimension::length),
                                                    quantity_text(extent, Dimension::length)));
    std::vector<double> sizes(static_cast<size_t>(n), filled / n);
    if (!even)
      sizes = free.shares(axis == Axis::x ? "widths" : "heights", "count", sizes.size(), filled,
                          free.key().at("sizes"));
    const bool same = alike && !free.apart();
    Layout out;
    double at = 0;
    for (int i = 0; i < n; ++i) {
      const double size = sizes[static_cast<size_t>(i)];
      const Rect rect = axis == Axis::x ? Rect{at, 0, size, height} : Rect{0, at, width, size};
      if (i == 0 || !same)
        out.cells.push_back({.part = part,
                             .rect = rect,
                             .index = i,
                             .total = n,
                             .column = axis == Axis::x ? i : 0,
                             .row = axis == Axis::y ? i : 0});
      else
        out.cells[0].copies.push_back(Placement::shift(rect.x, rect.y));
      const bool uneven = !even;
      if (uneven) out.cells.back().given = {{axis == Axis::x ? "width" : "height", size}};
      at += size + gap;
    }
    if (same) {
      out.cells[0].given = {{"count", n}};
      out.cells[0].total = 1;
    }
    return out;
  }
};

}  // namespace
}  // namespace vug::facade

VUG_SPLIT_KIND(repeat) { return split_kind<Repeat>("repeat"); }
