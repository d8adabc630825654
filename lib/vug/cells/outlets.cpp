// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/cells/frames.h>
#include <vug/cells/outlets.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::cells {
namespace {

/// The neighbours of a cell inside a surface surround it without a gap as wide as this, those of a
/// cell at a straight edge leave half a turn.
constexpr double kGap = 165 * kPi / 180;
/// Slopes up to this count as level (sine).
constexpr float kLevel = 0.05f;
/// Normals that point down more than this hold no water.
constexpr float kOverhang = -0.05f;

/// The direction of the widest gap between the neighbours, in the tangent plane; 0 if it is narrow.
Vec3f open_side(const Network& n, uint32_t cell) {
  const auto [right, ahead] = tangents_of(n.normal[cell]);
  std::array<double, 64> angles{};
  size_t count = 0;
  for (const uint32_t to : n.links.of(cell)) {
    const Vec3f d = n.position[to] - n.position[cell];
    if (count < angles.size())
      angles[count++] =
          maths::atan2(static_cast<double>(d.dot(ahead)), static_cast<double>(d.dot(right)));
  }
  if (count == 0) return Vec3f(0);
  std::sort(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(count));
  double widest = 0, middle = 0;
  for (size_t k = 0; k < count; ++k) {
    const double next = k + 1 < count ? angles[k + 1] : angles[0] + 2 * kPi;
    if (next - angles[k] > widest) widest = next - angles[k], middle = (next + angles[k]) / 2;
  }
  if (widest < kGap) return Vec3f(0);
  return right * static_cast<float>(maths::cos(middle)) +
         ahead * static_cast<float>(maths::sin(middle));
}

bool is_outlet(const Network& n, uint32_t cell) {
  const Vec3f normal = n.normal[cell];
  if (normal.y < kOverhang) {
    const auto links = n.links.of(cell);
    return std::none_of(links.begin(), links.end(),
                        [&](uint32_t to) { return n.position[to].y < n.position[cell].y; });
  }
  const Vec3f open = open_side(n, cell);
  if (open == Vec3f(0)) return false;
  const Vec3f down = normal * normal.y - Vec3f(0, 1, 0);
  const float steep = down.length();
  return steep < kLevel || down.dot(open) > 0.5f * steep;
}

}  // namespace

std::vector<uint8_t> find_outlets(const Network& network, const CellState* states) {
  std::vector<uint8_t> outlet(network.size());
  parallel_for(
      network.size(),
      [&](size_t i) {
        outlet[i] = states[i] != CellState::active || is_outlet(network, static_cast<uint32_t>(i));
      },
      kCellGrain);
  const std::vector<uint32_t> piece = components(network.links);
  constexpr uint32_t kNone = ~0u;
  const uint32_t pieces = piece.empty() ? 0 : *std::max_element(piece.begin(), piece.end()) + 1;
  std::vector<uint8_t> drained(pieces, 0);
  std::vector<uint32_t> lowest(pieces, kNone);
  for (uint32_t i = 0; i < network.size(); ++i) {
    if (outlet[i]) drained[piece[i]] = 1;
    uint32_t& low = lowest[piece[i]];
    if (low == kNone || network.position[i].y < network.position[low].y) low = i;
  }
  for (uint32_t p = 0; p < pieces; ++p)
    if (!drained[p]) outlet[lowest[p]] = 1;
  return outlet;
}

}  // namespace vug::cells
