// SPDX-License-Identifier: Apache-2.0
#include <vug/terrain/placed_heights.h>

#include <fmt/format.h>
#include <vug/base/error.h>
#include <vug/base/memory.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vug::terrain {
namespace {

/// Points along each edge of the file, whose images are curves.
constexpr int kEdgePoints = 16;

/// Cells that cubic interpolation needs around a place, and one for rounding.
constexpr int kBorder = 3;

Error empty_box(const ElevationFile& file) {
  return Error(
      ErrorCode::bad_input,
      fmt::format("fewer than 2 x 2 cells of '{}' lie in the terrain", file.path().string()), {},
      "use a larger 'margin', or a file with smaller cells");
}

/// Columns or rows from `first` to `last`, limited to the file's.
std::pair<int, int> span_of(double first, double last, int count) {
  const auto limited = [&](double x) { return static_cast<int>(std::clamp(x, 0.0, count - 1.0)); };
  return {limited(std::floor(first)), limited(std::ceil(last))};
}

/// For grids whose axes are those of the survey: the cells themselves.
PlacedHeights cells_in(const ElevationFile& file, const Box3d& box) {
  const GeoTransform& grid = file.transform();
  const Vec3d a = grid.cell(box.min), b = grid.cell(box.max);
  // A tolerance for places that are centres but for rounding.
  constexpr double kSlack = 1e-6;
  const auto [left, right] =
      span_of(std::min(a.x, b.x) - 0.5 + kSlack, std::max(a.x, b.x) - 0.5 - kSlack, file.columns());
  const auto [top, bottom] =
      span_of(std::min(a.y, b.y) - 0.5 + kSlack, std::max(a.y, b.y) - 0.5 - kSlack, file.rows());
  PlacedHeights out;
  out.columns = right - left + 1;
  out.rows = bottom - top + 1;
  if (out.columns < 2 || out.rows < 2) throw empty_box(file);
  out.heights = file.heights({left, top, out.columns, out.rows});
  const auto width = static_cast<std::ptrdiff_t>(out.columns);
  if (grid.c[1] < 0)  // Columns run to the west.
    for (auto row = out.heights.begin(); row != out.heights.end(); row += width)
      std::reverse(row, row + width);
  if (grid.c[5] > 0)  // Rows run to the north.
    for (std::ptrdiff_t i = 0, j = out.rows - 1; i < j; ++i, --j)
      std::swap_ranges(out.heights.begin() + i * width, out.heights.begin() + (i + 1) * width,
                       out.heights.begin() + j * width);
  out.box.extendBy(grid.place(left + 0.5, top + 0.5));
  out.box.extendBy(grid.place(right + 0.5, bottom + 0.5));
  out.cell = std::max(std::fabs(grid.c[1]), std::fabs(grid.c[5]));
  return out;
}

/// The smaller edge of a cell in metres of the survey, at the middle of a box.
double cell_edge(const ElevationFile& file, const Mapping& mapping, const Box3d& box) {
  const Vec3d middle = file.transform().cell(mapping.to_file(box.center()));
  const auto at = [&](double column, double row) {
    return mapping.to_survey(file.transform().place(column, row));
  };
  const Vec3d here = at(middle.x, middle.y);
  return std::min((at(middle.x + 1, middle.y) - here).length(),
                  (at(middle.x, middle.y + 1) - here).length());
}

PlacedHeights resample(const ElevationFile& file, const Mapping& mapping, const Box3d& box,
                       field::Sampling sampling) {
  const double edge = cell_edge(file, mapping, box);
  const Window window = cells_at(file, mapping, box);
  if (window.columns < 2 || window.rows < 2 || !(edge > 0)) throw empty_box(file);
  const Vec3d size = box.size();
  const double across = std::ceil(size.x / edge) + 1, down = std::ceil(size.y / edge) + 1;
  if (across < 2 || down < 2) throw empty_box(file);
  // Heights, and the slopes of the ground that is made of them.
  require_memory(across * down * 3 * sizeof(float), available_memory() / 10 * 9,
                 fmt::format("the terrain '{}'", file.path().string()),
                 "use 'around' and a smaller 'margin', or a file with fewer cells");
  const field::Heightmap source(window.columns, window.rows, file.heights(window),
                                window.columns - 1, window.rows - 1, sampling);
  PlacedHeights out{
      .box = box, .columns = static_cast<int>(across), .rows = static_cast<int>(down)};
  const Vec3d step(size.x / (across - 1), size.y / (down - 1), 0);
  out.cell = std::max(step.x, step.y);
  out.heights.reserve(static_cast<size_t>(across * down));
  // Exact for each kStride-th column, and linear between: millimetres for cells of 30 m.
  constexpr int kStride = 16;
  const auto exact = [&](int column, int row) {
    const Vec3d place(box.min.x + step.x * column, box.max.y - step.y * row, 0);
    return file.transform().cell(mapping.to_file(place)) -
           Vec3d(window.column + 0.5, window.row + 0.5, 0);
  };
  for (int row = 0; row < out.rows; ++row)
    for (int first = 0; first < out.columns; first += kStride) {
      const int last = std::min(first + kStride, out.columns);
      const Vec3d from = exact(first, row), change = (exact(last, row) - from) / (last - first);
      for (int column = first; column < last; ++column) {
        const Vec3d cell = from + change * (column - first);
        // The outer halves of the outermost cells have their heights.
        constexpr double kHalf = 0.5 + 1e-6;
        const bool inside = cell.x >= -kHalf && cell.y >= -kHalf &&
                            cell.x <= window.columns - 1 + kHalf &&
                            cell.y <= window.rows - 1 + kHalf;
        out.heights.push_back(inside ? static_cast<float>(source.at(cell.x, cell.y).value)
                                     : std::numeric_limits<float>::quiet_NaN());
      }
    }
  return out;
}

}  // namespace

Window cells_at(const ElevationFile& file, const Mapping& mapping, const Box3d& box,
                double beyond) {
  Box3d cells;
  for (int i = 0; i <= kEdgePoints; ++i)
    for (int j = 0; j <= kEdgePoints; ++j) {
      const Vec3d share(static_cast<double>(i) / kEdgePoints, static_cast<double>(j) / kEdgePoints,
                        0);
      cells.extendBy(file.transform().cell(mapping.to_file(box.min + box.size() * share)));
    }
  const Vec3d more = cells.size() * beyond + Vec3d(kBorder, kBorder, 0);
  const Box3d all(cells.min - more, cells.max + more);
  if (all.max.x < 0 || all.max.y < 0 || all.min.x > file.columns() || all.min.y > file.rows())
    return {};
  const auto [left, right] = span_of(all.min.x, all.max.x, file.columns());
  const auto [top, bottom] = span_of(all.min.y, all.max.y, file.rows());
  return {left, top, right - left + 1, bottom - top + 1};
}

Coverage coverage(const ElevationFile& file, const Mapping& mapping, const Window& cells) {
  // Corners of the centres' rectangle, in order around it.
  const double left = cells.column + 0.5, right = cells.column + cells.columns - 0.5;
  const double top = cells.row + 0.5, bottom = cells.row + cells.rows - 0.5;
  const std::array<Vec3d, 5> corners = {Vec3d(left, top, 0), Vec3d(right, top, 0),
                                        Vec3d(right, bottom, 0), Vec3d(left, bottom, 0),
                                        Vec3d(left, top, 0)};
  Coverage out;
  std::array<Box3d, 4> edges;
  for (size_t k = 0; k < 4; ++k) {
    for (int i = 0; i <= kEdgePoints; ++i) {
      const Vec3d p = corners[k] + (corners[k + 1] - corners[k]) * (i * 1.0 / kEdgePoints);
      edges[k].extendBy(mapping.to_survey(file.transform().place(p.x, p.y)));
    }
    out.around.extendBy(edges[k]);
  }
  const Vec3d middle = out.around.center();
  out.inside = out.around;
  for (const Box3d& edge : edges) {
    const Vec3d from = edge.center() - middle, size = out.around.size();
    if (std::fabs(from.x) * size.y > std::fabs(from.y) * size.x) {
      if (from.x < 0)
        out.inside.min.x = std::max(out.inside.min.x, edge.max.x);
      else
        out.inside.max.x = std::min(out.inside.max.x, edge.min.x);
    } else {
      if (from.y < 0)
        out.inside.min.y = std::max(out.inside.min.y, edge.max.y);
      else
        out.inside.max.y = std::min(out.inside.max.y, edge.min.y);
    }
  }
  return out;
}

PlacedHeights place_heights(const ElevationFile& file, const Mapping& mapping, const Box3d& box,
                            field::Sampling sampling) {
  const bool aligned = mapping.identity && !file.transform().is_rotated();
  return aligned ? cells_in(file, box) : resample(file, mapping, box, sampling);
}

}  // namespace vug::terrain
