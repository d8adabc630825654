// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/median.h>
#include <vug/scan/opening_extraction.h>
#include <vug/scan/openings.h>
#include <vug/scan/split.h>

#include <algorithm>
#include <cmath>

namespace vug::scan {
namespace {

/// Lower border of the lowest facade pixel near the columns of a box, as a row.
int ground(const SurfaceMap& map, const RangeImage& range, const PixelBox& box) {
  constexpr double kAside = 1;  // Metres.
  const int aside = pixels_of(kAside, range.pixel, range.width);
  for (int y = range.height - 1; y >= box.y1; --y)
    for (int x = std::max(0, box.x0 - aside); x < std::min(range.width, box.x1 + aside); ++x) {
      const Surface surface = map.surface[range.index(x, y)];
      if (surface == Surface::wall || surface == Surface::behind) return y + 1;
    }
  return box.y1;
}

Opening opening_of(const PixelBox& box, const RangeImage& range, const SurfaceMap& map,
                   double door_sill) {
  Opening out;
  const double p = range.pixel;
  out.box =
      Box({box.x0 * p, (range.height - box.y1) * p}, {box.x1 * p, (range.height - box.y0) * p});
  std::vector<double> behind;
  double empty = 0;
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x) {
      const size_t pixel = range.index(x, y);
      if (std::isnan(range.depth[pixel])) ++empty;
      if (map.surface[pixel] == Surface::behind)
        behind.push_back(map.wall(pixel).at(range.pixel_center(x, y)) - range.depth[pixel]);
    }
  out.empty = empty / static_cast<double>(box.area());
  out.set_back = std::nan("");
  if (!behind.empty()) out.set_back = median(std::move(behind));
  if ((ground(map, range, box) - box.y1) * p <= door_sill) out.kind = OpeningKind::door;
  return out;
}

/// Splits off rows (or columns) at a box's borders that show almost nothing behind the wall, if
/// they are at least `min_pixels` wide and the rest shows something: a shop sign in front of the
/// wall hides it like window glass does, but its shadow has no frame.
std::vector<PixelBox> split_empty_borders(const PixelBox& box, const RangeImage& range,
                                          const SurfaceMap& map, int min_pixels) {
  constexpr double kNothing = 0.02, kSomething = 0.1;  // Shares of a row and of the rest.
  const auto part_behind = [&](const PixelBox& part) {
    int64_t behind = 0;
    for (int y = part.y0; y < part.y1; ++y)
      for (int x = part.x0; x < part.x1; ++x)
        behind += map.surface[range.index(x, y)] == Surface::behind;
    return static_cast<double>(behind) / static_cast<double>(std::max(part.area(), int64_t{1}));
  };
  const auto rows = [&](int y0, int y1) { return PixelBox{box.x0, y0, box.x1, y1}; };
  const auto columns = [&](int x0, int x1) { return PixelBox{x0, box.y0, x1, box.y1}; };
  int top = box.y0, bottom = box.y1, left = box.x0, right = box.x1;
  while (top < bottom && part_behind(rows(top, top + 1)) < kNothing) ++top;
  while (top < bottom && part_behind(rows(bottom - 1, bottom)) < kNothing) --bottom;
  while (left < right && part_behind(columns(left, left + 1)) < kNothing) ++left;
  while (left < right && part_behind(columns(right - 1, right)) < kNothing) --right;
  for (const auto& [rest, empty] : {std::pair{rows(top, box.y1), rows(box.y0, top)},
                                    {rows(box.y0, bottom), rows(bottom, box.y1)},
                                    {columns(left, box.x1), columns(box.x0, left)},
                                    {columns(box.x0, right), columns(right, box.x1)}}) {
    if (std::min(empty.x1 - empty.x0, empty.y1 - empty.y0) < min_pixels) continue;
    if (part_behind(rest) < kSomething) continue;
    std::vector<PixelBox> out = split_empty_borders(rest, range, map, min_pixels);
    out.push_back(empty);
    return out;
  }
  return {box};
}

/// The boxes of a component. A component that is too large, or a network rather than a box, is cut
/// at its necks first.
std::vector<PixelBox> split_component(const Component& group, const RangeImage& range,
                                      const OpeningOptions& options) {
  constexpr double kFill = 0.4;  // Share of a box below which its pixels count as a network.
  std::vector<PixelBox> out;
  const auto fits = [&](const FilledBox& piece) {
    const int side = std::max(piece.box.x1 - piece.box.x0, piece.box.y1 - piece.box.y0);
    return side * range.pixel <= options.max_size &&
           static_cast<double>(piece.pixels) >= kFill * static_cast<double>(piece.box.area());
  };
  const std::vector<FilledBox> whole = split(group);
  if (std::all_of(whole.begin(), whole.end(), fits)) {
    for (const FilledBox& piece : whole) out.push_back(piece.box);
    return out;
  }
  for (const Component& part :
       components_of(opened(group.mask, closing_radius(options.max_neck_width, range))))
    for (const FilledBox& piece : split(part))
      out.push_back({piece.box.x0 + group.box.x0, piece.box.y0 + group.box.y0,
                     piece.box.x1 + group.box.x0, piece.box.y1 + group.box.y0});
  return out;
}

}  // namespace

std::string to_string(OpeningKind kind) { return kind == OpeningKind::door ? "door" : "window"; }

int closing_radius(double metres, const RangeImage& range) {
  return pixels_of(metres / 2, range.pixel, std::max(range.width, range.height));
}

void require_valid(const OpeningOptions& options) {
  for (const double number :
       {options.closing, options.min_size, options.max_size, options.door_sill,
        options.min_perimeter, options.max_bar_width, options.max_neck_width})
    if (!(number >= 0 && std::isfinite(number)))
      throw Error(ErrorCode::bad_input, "the lengths of opening options must not be negative");
}

std::vector<Opening> extract_openings(const Mask& open, const RangeImage& range,
                                      const SurfaceMap& map, const OpeningOptions& options) {
  // Masks, components and their parts that exist at the same time.
  constexpr double kPixelBytes = 16;
  require_memory(kPixelBytes * static_cast<double>(range.pixel_count()), options.memory,
                 "the search for openings", "use larger pixels");
  std::vector<PixelBox> boxes;
  const int min_pixels = pixels_of(options.min_size, range.pixel, INT32_MAX);
  each_component(open, [&](const Component& group) {
    if (!options.tidy) {
      boxes.push_back(group.box);
      return;
    }
    for (const PixelBox& box : split_component(group, range, options)) {
      const std::vector<PixelBox> parts = split_empty_borders(box, range, map, min_pixels);
      boxes.insert(boxes.end(), parts.begin(), parts.end());
    }
  });
  std::vector<Opening> out;
  for (const PixelBox& box : boxes) {
    const double wide = (box.x1 - box.x0) * range.pixel, high = (box.y1 - box.y0) * range.pixel;
    if (std::min(wide, high) >= options.min_size && std::max(wide, high) <= options.max_size)
      out.push_back(opening_of(box, range, map, options.door_sill));
  }
  std::sort(out.begin(), out.end(), [](const Opening& a, const Opening& b) {
    return std::pair(a.box.min.y, a.box.min.x) < std::pair(b.box.min.y, b.box.min.x);
  });
  return out;
}

std::vector<Opening> openings_by_raster(const RangeImage& range, const SurfaceMap& map,
                                        const OpeningOptions& options) {
  require_valid(options);
  Mask full(range.width, range.height);
  for (size_t i = 0; i < full.on.size(); ++i)
    full.on[i] = map.surface[i] == Surface::wall || map.surface[i] == Surface::outside;
  Mask open = inverted(closed(full, closing_radius(options.closing, range)));
  if (options.tidy) open = closed(open, closing_radius(options.max_bar_width, range));
  return extract_openings(open, range, map, options);
}

}  // namespace vug::scan
