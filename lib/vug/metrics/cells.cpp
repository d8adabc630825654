// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/metrics/cells.h>

#include <array>
#include <atomic>
#include <cmath>

namespace vug::metrics {
namespace {

constexpr int kRoot = 64;  ///< Cells along a block of one task.
constexpr int kLeaf = 8;   ///< Cells along a block that is sampled.

/// The signs of values at the corners of the cells of a leaf. A value of size v is followed by
/// values of the same sign as far as the field cannot change by v.
class LatticeSigns {
 public:
  /// `change`: the most by which values of neighbours differ. `value(i, j, k)` is called for the
  /// corners whose sign does not follow from those before.
  template <class Value>
  LatticeSigns(double change, const Value& value) {
    for (int i = 0; i < kPoints; ++i)
      for (int j = 0; j < kPoints; ++j)
        for (int k = 0; k < kPoints; ++k) {
          double known = 0;
          const auto follow = [&](double before) {
            const double left = std::fabs(before) - change;
            if (left > std::fabs(known)) known = before > 0 ? left : -left;
          };
          if (i > 0) follow(known_[i - 1][j][k]);
          if (j > 0) follow(known_[i][j - 1][k]);
          if (k > 0) follow(known_[i][j][k - 1]);
          known_[i][j][k] = known != 0 ? known : value(i, j, k);
        }
  }

  bool inside(int i, int j, int k) const { return known_[i][j][k] < 0; }

 private:
  static constexpr int kPoints = kLeaf + 1;
  double known_[kPoints][kPoints][kPoints];  // Of the sign of the value, and at most as large.
};

/// Number of inside cells among size^3 cells from lattice point `low`.
uint64_t count_block(const field::Field& field, double edge, const std::array<int64_t, 3>& low,
                     int size) {
  const auto at = [&](int64_t i, int64_t j, int64_t k) {
    return Vec3d(static_cast<double>(i) * edge, static_cast<double>(j) * edge,
                 static_cast<double>(k) * edge);
  };
  const Vec3d first = at(low[0], low[1], low[2]);
  const Vec3d last = at(low[0] + size, low[1] + size, low[2] + size);
  const field::Ball ball{(first + last) * 0.5, 0.5 * (last - first).length() * (1 + 1e-12)};
  const field::Field::RestrictedField part = field.restricted(ball);
  const auto all = static_cast<uint64_t>(size);
  if (part.range.hi < 0) return all * all * all;
  if (part.range.lo >= 0) return 0;
  uint64_t count = 0;
  if (size > kLeaf) {
    const int half = size / 2;
    for (int octant = 0; octant < 8; ++octant)
      count += count_block(part.field, edge,
                           {low[0] + (octant & 1 ? half : 0), low[1] + (octant & 2 ? half : 0),
                            low[2] + (octant & 4 ? half : 0)},
                           half);
    return count;
  }
  constexpr double kRounding = 1 + 1e-9;
  const LatticeSigns signs(kRounding * edge * part.field.lipschitz(), [&](int i, int j, int k) {
    return part.field.value(at(low[0] + i, low[1] + j, low[2] + k));
  });
  for (int i = 0; i < kLeaf; ++i)
    for (int j = 0; j < kLeaf; ++j)
      for (int k = 0; k < kLeaf; ++k) {
        bool whole = true;
        for (int corner = 0; corner < 8 && whole; ++corner)
          whole = signs.inside(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
        count += whole ? 1 : 0;
      }
  return count;
}

}  // namespace

uint64_t inside_cells(const field::Field& field, double edge, Progress& progress) {
  const Box3d& bounds = field.bounds();
  if (bounds.isEmpty()) return 0;
  if (!(edge > 0) || !is_finite(bounds))
    throw Error(ErrorCode::bad_input, "cells can be counted within finite bounds only", {},
                "intersect the field with a box");
  std::array<int64_t, 3> first{};
  std::array<size_t, 3> blocks{};
  for (int axis = 0; axis < 3; ++axis) {
    const double low = std::floor(bounds.min[axis] / edge);
    const double high = std::ceil(bounds.max[axis] / edge);
    if (std::fabs(low) > 1e9 || std::fabs(high) > 1e9)
      throw Error(ErrorCode::too_large, "the cells are too small for these bounds");
    const auto a = static_cast<size_t>(axis);
    first[a] = static_cast<int64_t>(low);
    blocks[a] = static_cast<size_t>(high - low) / kRoot + 1;
  }
  std::atomic<uint64_t> total{0};
  const size_t count = blocks[0] * blocks[1] * blocks[2];
  progress.begin("counting cells", count);
  parallel_for(count, [&](size_t block) {
    progress.check();
    const std::array<size_t, 3> index = {block % blocks[0], block / blocks[0] % blocks[1],
                                         block / (blocks[0] * blocks[1])};
    std::array<int64_t, 3> low{};
    for (size_t axis = 0; axis < 3; ++axis)
      low[axis] = first[axis] + static_cast<int64_t>(index[axis]) * kRoot;
    total += count_block(field, edge, low, kRoot);
    progress.advance();
  });
  progress.end();
  return total;
}

double volume_cells(const field::Field& field, double edge, Progress& progress) {
  return static_cast<double>(inside_cells(field, edge, progress)) * edge * edge * edge;
}

}  // namespace vug::metrics
