#include <vug/base/parallel.h>
#include <vug/mesh/disjoint_sets.h>
#include <vug/scan/mask.h>

#include <algorithm>
#include <cmath>

namespace vug::scan {
namespace {

/// One line of `count` pixels, `step` apart, dilated in place.
void dilate_line(uint8_t* line, int count, size_t step, int radius) {
  const auto at = [&](int i) -> uint8_t& { return line[static_cast<size_t>(i) * step]; };
  // What is on in the line; bit 1 of a pixel keeps what comes of it meanwhile.
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

std::vector<Group> groups_of(const Mask& mask, int64_t least) {
  mesh::DisjointSets sets(mask.on.size());
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      if (!mask.at(x, y)) continue;
      const auto i = static_cast<uint32_t>(mask.index(x, y));
      if (x > 0 && mask.at(x - 1, y)) sets.join(i, i - 1);
      if (y > 0 && mask.at(x, y - 1)) sets.join(i, i - static_cast<uint32_t>(mask.width));
    }
  // Roots are the first pixels of their groups, so groups come in that order.
  constexpr uint32_t kNone = UINT32_MAX;
  std::vector<uint32_t> group_of(mask.on.size(), kNone);
  std::vector<Group> groups;
  const auto each = [&](const auto& visit) {
    for (int y = 0; y < mask.height; ++y)
      for (int x = 0; x < mask.width; ++x)
        if (mask.at(x, y)) visit(x, y, sets.root(static_cast<uint32_t>(mask.index(x, y))));
  };
  each([&](int x, int y, uint32_t root) {
    if (group_of[root] == kNone) {
      group_of[root] = static_cast<uint32_t>(groups.size());
      groups.push_back({{x, y, x + 1, y + 1}, {}, 0});
    }
    Group& group = groups[group_of[root]];
    PixelBox& box = group.box;
    box = {std::min(box.x0, x), box.y0, std::max(box.x1, x + 1), y + 1};
    ++group.pixels;
  });
  for (Group& group : groups)
    if (group.pixels >= least)
      group.mask = Mask(group.box.x1 - group.box.x0, group.box.y1 - group.box.y0);
  each([&](int x, int y, uint32_t root) {
    Group& group = groups[group_of[root]];
    if (group.pixels >= least)
      group.mask.on[group.mask.index(x - group.box.x0, y - group.box.y0)] = 1;
  });
  std::erase_if(groups, [&](const Group& group) { return group.pixels < least; });
  return groups;
}

}  // namespace vug::scan
