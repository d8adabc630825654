// SPDX-License-Identifier: Apache-2.0
// Evidence about a picture's pixels with constant-time sums over rectangles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vug::fit {

constexpr int kMaxLanes = 8;
/// Replaces a cluster index at pixels without evidence, such as those next to the facade.
constexpr uint8_t kNoEvidence = 255;
/// Sums over pixels, one per lane: the pixel count of each cluster, or the code length under each
/// region type.
struct alignas(32) Sums {
  std::array<uint32_t, kMaxLanes> lane{};

  Sums& operator+=(const Sums& other) {
    for (size_t i = 0; i < lane.size(); ++i) lane[i] += other.lane[i];
    return *this;
  }
  Sums& operator-=(const Sums& other) {
    for (size_t i = 0; i < lane.size(); ++i) lane[i] -= other.lane[i];
    return *this;
  }
  bool operator==(const Sums&) const = default;
};

/// Summed area tables (cite crow1984). Sums are modulo 2^32, so differences are correct as long as
/// the sums over the whole picture fit.
class Evidence {
 public:
  /// `values` holds `lanes` numbers per pixel, row by row from the top. Error(bad_input) for
  /// non-positive or mismatched sizes, Error(too_large) if the sum of a lane exceeds 32 bits.
  Evidence(int width, int height, int lanes, const std::vector<uint32_t>& values);
  /// One lane per cluster 0..lanes-1, from the cluster of each pixel; kNoEvidence adds to no lane.
  static Evidence from_clusters(int width, int height, int lanes,
                                const std::vector<uint8_t>& clusters);

  int width() const { return width_; }
  int height() const { return height_; }
  int lanes() const { return lanes_; }

  /// Sums over the pixels with x0 <= x < x1 and y0 <= y < y1; y points down.
  Sums sums(int x0, int y0, int x1, int y1) const {
    Sums out = at(x1, y1);
    out -= at(x0, y1);
    out -= at(x1, y0);
    out += at(x0, y0);
    return out;
  }

 private:
  const Sums& at(int x, int y) const {
    return table_[static_cast<size_t>(y) * static_cast<size_t>(width_ + 1) +
                  static_cast<size_t>(x)];
  }

  int width_, height_, lanes_;
  std::vector<Sums> table_;
};

}  // namespace vug::fit
