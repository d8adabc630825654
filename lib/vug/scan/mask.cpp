// SPDX-License-Identifier: Apache-2.0
#include <vug/base/disjoint_sets.h>
#include <vug/base/parallel.h>
#include <vug/scan/mask.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vug::scan {
namespace {

/// Dilates one line of `count` pixels with stride `step` in place.
void dilate_line(uint8_t* line, int count, size_t step, int radius) {
  const auto at = [&](int i) -> uint8_t& { return line[static_cast<size_t>(i) * step]; };
  // Bit 0 holds the input; bit 1 collects the output.
  for (int i = 0, since = radius + 1; i < count; ++i) {
    since = at(i) & 1 ? 0 : since + 1;
    if (since <= radius) at(i) |= 2;
    if (since > radius) since = radius + 1;
  }
  for (int i = count - 1, since = radius + 1; i >= 0; --i) {
    since = at(i) & 1 ? 0 : since + 1;
    if (since <= radius) at(i) |= 2;
    if (since > radius) since = radius + 1;
  }
  for (int i = 0; i < count; ++i) at(i) = (at(i) & 2) != 0;
}

}  // namespace

int pixels_of(double metres, double pixel, int most) {
  return static_cast<int>(std::lround(std::min(metres / pixel, static_cast<double>(most))));
}

Mask inverted(Mask mask) {
  for (uint8_t& pixel : mask.on) pixel = !pixel;
  return mask;
}

Mask dilated(const Mask& mask, int radius) {
  Mask out = mask;
  if (radius < 1) return out;
  const auto width = static_cast<size_t>(out.width);
  parallel_for(static_cast<size_t>(out.height),
               [&](size_t y) { dilate_line(out.on.data() + y * width, out.width, 1, radius); });
  parallel_for(width, [&](size_t x) { dilate_line(out.on.data() + x, out.height, width, radius); });
  return out;
}

Mask eroded(const Mask& mask, int radius) { return inverted(dilated(inverted(mask), radius)); }

Mask closed(const Mask& mask, int radius) { return eroded(dilated(mask, radius), radius); }

Mask opened(const Mask& mask, int radius) { return dilated(eroded(mask, radius), radius); }

Mask outside_of(const Mask& solid) {
  Mask out(solid.width, solid.height);
  std::vector<std::pair<int, int>> open;
  const auto enter = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= solid.width || y >= solid.height) return;
    if (solid.at(x, y) || out.at(x, y)) return;
    out.on[out.index(x, y)] = 1;
    open.emplace_back(x, y);
  };
  for (int x = 0; x < solid.width; ++x) enter(x, 0);
  for (int y = 0; y < solid.height; ++y) enter(0, y), enter(solid.width - 1, y);
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    enter(x - 1, y), enter(x + 1, y), enter(x, y - 1), enter(x, y + 1);
  }
  return out;
}

void each_component(const Mask& mask, const std::function<void(const Component&)>& visit) {
  DisjointSets<> sets(mask.on.size());
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      if (!mask.at(x, y)) continue;
      const auto i = static_cast<uint32_t>(mask.index(x, y));
      if (x > 0 && mask.at(x - 1, y)) sets.join(i, i - 1);
      if (y > 0 && mask.at(x, y - 1)) sets.join(i, i - static_cast<uint32_t>(mask.width));
    }
  // Roots are the first pixels of their components, which defines the order.
  struct ComponentBounds {
    uint32_t root = 0;
    PixelBox box;
    int64_t pixels = 0;
  };
  std::vector<ComponentBounds> all;
  std::vector<uint32_t> group_of(mask.on.size(), 0);
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      if (!mask.at(x, y)) continue;
      const auto i = static_cast<uint32_t>(mask.index(x, y));
      const uint32_t root = sets.root(i);
      if (root == i) {
        group_of[root] = static_cast<uint32_t>(all.size());
        all.push_back({root, {x, y, x + 1, y + 1}, 0});
      }
      ComponentBounds& group = all[group_of[root]];
      PixelBox& box = group.box;
      box = {std::min(box.x0, x), box.y0, std::max(box.x1, x + 1), y + 1};
      ++group.pixels;
    }
  for (const ComponentBounds& group : all) {
    const PixelBox& box = group.box;
    Component out{box, Mask(box.x1 - box.x0, box.y1 - box.y0), group.pixels};
    for (int y = box.y0; y < box.y1; ++y)
      for (int x = box.x0; x < box.x1; ++x)
        out.mask.on[out.mask.index(x - box.x0, y - box.y0)] =
            mask.at(x, y) && sets.root(static_cast<uint32_t>(mask.index(x, y))) == group.root;
    visit(out);
  }
}

std::vector<Component> components_of(const Mask& mask) {
  std::vector<Component> out;
  each_component(mask, [&](const Component& group) { out.push_back(group); });
  return out;
}

}  // namespace vug::scan
