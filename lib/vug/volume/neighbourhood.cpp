// SPDX-License-Identifier: Apache-2.0
#include <vug/volume/neighbourhood.h>

namespace vug::volume {
namespace {

constexpr uint32_t kAll = (1U << 27) - 1, kCentre = 1U << 13;

/// The bits of samples that have the given coordinate.
constexpr uint32_t plane(int axis, int coordinate) {
  uint32_t bits = 0;
  for (int i = 0; i < 27; ++i) {
    const int at[] = {i / 9, i / 3 % 3, i % 3};
    if (at[axis] == coordinate) bits |= 1U << i;
  }
  return bits;
}
constexpr uint32_t kLow[] = {plane(0, 0), plane(1, 0), plane(2, 0)};
constexpr uint32_t kHigh[] = {plane(0, 2), plane(1, 2), plane(2, 2)};

/// Whether the samples of a set are connected by steps along the axes.
bool connected(uint32_t set) {
  constexpr int kStep[] = {9, 3, 1};
  uint32_t reached = set & (0U - set), before = 0;
  while (reached != before) {
    before = reached;
    for (int axis = 0; axis < 3; ++axis) {
      reached |= set & ((reached & ~kHigh[axis]) << kStep[axis]);
      reached |= set & ((reached & ~kLow[axis]) >> kStep[axis]);
    }
  }
  return reached == set;
}

}  // namespace

unsigned SignRows::surface(int x, int y) const {
  const unsigned here = row(x, y);
  const unsigned changes = (here ^ here << 1) | (here ^ here >> 1) | (here ^ row(x - 1, y)) |
                           (here ^ row(x + 1, y)) | (here ^ row(x, y - 1)) | (here ^ row(x, y + 1));
  return changes >> 1 & 0xffU;
}

unsigned SignRows::low_corners(int x, int y) const {
  const unsigned here = row(x, y);
  return ((here ^ here << 1) & (here ^ row(x - 1, y)) & (here ^ row(x, y - 1))) >> 1 & 0xffU;
}

uint32_t SignRows::around(int x, int y, int z) const {
  uint32_t bits = 0;
  for (int dx = -1; dx <= 1; ++dx)
    for (int dy = -1; dy <= 1; ++dy)
      bits |= (row(x + dx, y + dy) >> z & 7U) << (9 * (dx + 1) + 3 * (dy + 1));
  return bits;
}

bool is_simple(uint32_t around) {
  const uint32_t inside = around & ~kCentre, outside = ~around & kAll & ~kCentre;
  return inside != 0 && outside != 0 && connected(inside) && connected(outside);
}

bool is_thin(uint32_t around) {
  const uint32_t own = around & kCentre ? around : ~around;
  for (int corner = 0; corner < 8; ++corner) {
    const int first = (corner >> 2) * 9 + (corner >> 1 & 1) * 3 + (corner & 1);
    // Bits 0, 1, 3, 4, 9, 10, 12 and 13: the cube whose lowest corner is sample 0.
    constexpr uint32_t kLowest = 0x361b;
    if ((own >> first & kLowest) == kLowest) return false;
  }
  return true;
}

}  // namespace vug::volume
