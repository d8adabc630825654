// SPDX-License-Identifier: Apache-2.0
#include <vug/base/median.h>
#include <vug/scan/cell_depths.h>
#include <vug/scan/mask.h>
#include <vug/scan/sections.h>
#include <vug/scan/wall.h>

#include <algorithm>
#include <cmath>

namespace vug::scan {
namespace {

constexpr int kNone = -1;
constexpr size_t kMaxSections = 64;

/// A connected surface without steps.
struct Patch {
  std::vector<size_t> cells;
  PixelBox box;  ///< In cells.
};

/// Visits the four neighbours of a cell.
template <class Visit>
void each_neighbour(const CellDepths& grid, size_t cell, const Visit& visit) {
  const auto across = static_cast<size_t>(grid.across), x = cell % across, y = cell / across;
  if (x > 0) visit(cell - 1);
  if (x + 1 < across) visit(cell + 1);
  if (y > 0) visit(cell - across);
  if (y + 1 < static_cast<size_t>(grid.down)) visit(cell + across);
}

/// The connected surfaces, largest first.
std::vector<Patch> patches_of(const CellDepths& grid, double step) {
  std::vector<Patch> out;
  std::vector<bool> seen(grid.depths.size());
  for (size_t first = 0; first < seen.size(); ++first) {
    if (seen[first] || std::isnan(grid.depths[first])) continue;
    Patch patch{{first}, {grid.across, grid.down, 0, 0}};
    seen[first] = true;
    for (size_t i = 0; i < patch.cells.size(); ++i) {
      const size_t cell = patch.cells[i];
      const int x = static_cast<int>(cell % static_cast<size_t>(grid.across));
      const int y = static_cast<int>(cell / static_cast<size_t>(grid.across));
      PixelBox& box = patch.box;
      box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1),
             std::max(box.y1, y + 1)};
      each_neighbour(grid, cell, [&](size_t next) {
        // False for NaN.
        if (seen[next] || !(std::fabs(grid.depths[next] - grid.depths[cell]) < step)) return;
        seen[next] = true;
        patch.cells.push_back(next);
      });
    }
    out.push_back(std::move(patch));
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Patch& a, const Patch& b) { return a.cells.size() > b.cells.size(); });
  return out;
}

/// Whether the patch surrounds a hole of at least `cells` per side.
bool surrounds_hole(const Patch& patch, const CellDepths& grid, int cells) {
  const PixelBox& box = patch.box;
  Mask solid(box.x1 - box.x0, box.y1 - box.y0);
  for (const size_t cell : patch.cells)
    solid.on[solid.index(static_cast<int>(cell % static_cast<size_t>(grid.across)) - box.x0,
                         static_cast<int>(cell / static_cast<size_t>(grid.across)) - box.y0)] = 1;
  bool found = false;
  each_component(inverted(solid), [&](const Component& hole) {
    const PixelBox& b = hole.box;
    const bool inside = b.x0 > 0 && b.y0 > 0 && b.x1 < solid.width && b.y1 < solid.height;
    found = found || (inside && std::min(b.x1 - b.x0, b.y1 - b.y0) >= cells);
  });
  return found;
}

bool is_wall(const Patch& patch, const CellDepths& grid, double cell,
             const SectionOptions& options) {
  if (static_cast<double>(patch.cells.size()) * cell * cell < options.min_area) return false;
  const int side = std::max(patch.box.x1 - patch.box.x0, patch.box.y1 - patch.box.y0);
  if (side * cell > options.max_opening) return true;
  return surrounds_hole(patch, grid, std::max(1, static_cast<int>(options.min_opening / cell)));
}

/// Spreads the sections of the walls' cells to all cells: each takes that of the nearest wall.
void spread(const CellDepths& grid, std::vector<int>& section) {
  std::vector<size_t> front;
  for (size_t cell = 0; cell < section.size(); ++cell)
    if (section[cell] != kNone) front.push_back(cell);
  for (size_t i = 0; i < front.size(); ++i)
    each_neighbour(grid, front[i], [&](size_t next) {
      if (section[next] != kNone) return;
      section[next] = section[front[i]];
      front.push_back(next);
    });
}

std::vector<uint8_t> to_pixels(const RangeImage& range, const CellDepths& grid,
                               const std::vector<int>& section) {
  std::vector<uint8_t> out(range.pixel_count());
  for (int y = 0; y < range.height; ++y)
    for (int x = 0; x < range.width; ++x)
      out[range.index(x, y)] =
          static_cast<uint8_t>(section[grid.index(x / grid.side, y / grid.side)]);
  return out;
}

/// Whether the patch is the continuation of a wall, such as the part of it behind a drainpipe.
bool continues(const Patch& patch, const Wall& wall, const RangeImage& range,
               const CellDepths& grid, double min_offset) {
  std::vector<double> apart;
  for (const size_t cell : patch.cells) {
    const int x = static_cast<int>(cell % static_cast<size_t>(grid.across)) * grid.side;
    const int y = static_cast<int>(cell / static_cast<size_t>(grid.across)) * grid.side;
    const int half = grid.side / 2;
    apart.push_back(grid.depths[cell] - wall.at(range.pixel_center(x + half, y + half)));
  }
  return std::fabs(median(std::move(apart))) < min_offset;
}

}  // namespace

std::vector<uint8_t> Sections::mask(int section) const {
  std::vector<uint8_t> out(of_pixel.size());
  for (size_t p = 0; p < out.size(); ++p) out[p] = of_pixel[p] == section;
  return out;
}

Sections wall_sections(const RangeImage& range, const SectionOptions& options) {
  const CellDepths grid = cell_depths(range, options.cell);
  const double cell = grid.side * range.pixel;
  std::vector<int> section(grid.depths.size(), kNone);
  std::vector<Wall> walls;
  for (const Patch& patch : patches_of(grid, options.step)) {
    if (!is_wall(patch, grid, cell, options)) continue;
    const auto known = std::find_if(walls.begin(), walls.end(), [&](const Wall& wall) {
      return continues(patch, wall, range, grid, options.min_offset);
    });
    if (known == walls.end() && walls.size() == kMaxSections) continue;
    const auto number = static_cast<int>(known - walls.begin());
    for (const size_t at : patch.cells) section[at] = number;
    if (known != walls.end()) continue;
    std::vector<int> own(section.size(), 0);
    for (const size_t at : patch.cells) own[at] = 1;
    walls.push_back(fit_wall(range, {}, to_pixels(range, grid, own)));
  }
  if (walls.size() < 2) return {};
  spread(grid, section);
  return {static_cast<int>(walls.size()), to_pixels(range, grid, section)};
}

}  // namespace vug::scan
