// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/fit/evidence/evidence.h>

#include <fmt/format.h>

#include <limits>

namespace vug::fit {

Evidence::Evidence(int width, int height, int lanes, const std::vector<uint32_t>& values)
    : width_(width), height_(height), lanes_(lanes) {
  if (width < 1 || height < 1 || lanes < 1 || lanes > kMaxLanes)
    throw Error(
        ErrorCode::bad_input,
        fmt::format("invalid evidence: {} x {} pixels with {} numbers each", width, height, lanes));
  const auto w = static_cast<size_t>(width), h = static_cast<size_t>(height);
  const auto count = static_cast<size_t>(lanes);
  if (values.size() != w * h * count)
    throw Error(ErrorCode::bad_input, "evidence needs one number per pixel and lane");
  std::array<uint64_t, kMaxLanes> whole{};
  for (size_t i = 0; i < values.size(); ++i) whole[i % count] += values[i];
  for (const uint64_t sum : whole)
    if (sum > std::numeric_limits<uint32_t>::max())
      throw Error(ErrorCode::too_large,
                  "the picture is too large: a sum over its pixels exceeds 32 bits", {},
                  "reduce its size");
  table_.assign((w + 1) * (h + 1), Sums{});
  for (size_t y = 0; y < h; ++y) {
    Sums row{};
    for (size_t x = 0; x < w; ++x) {
      for (size_t lane = 0; lane < count; ++lane)
        row.lane[lane] += values[(y * w + x) * count + lane];
      Sums sum = row;
      sum += table_[y * (w + 1) + x + 1];
      table_[(y + 1) * (w + 1) + x + 1] = sum;
    }
  }
}

Evidence Evidence::from_clusters(int width, int height, int lanes,
                                 const std::vector<uint8_t>& clusters) {
  if (lanes < 1) throw Error(ErrorCode::bad_input, "evidence needs at least one cluster");
  std::vector<uint32_t> values(clusters.size() * static_cast<size_t>(lanes), 0);
  for (size_t i = 0; i < clusters.size(); ++i) {
    if (clusters[i] == kNoEvidence) continue;
    if (clusters[i] >= lanes)
      throw Error(ErrorCode::bad_input, "a pixel has a cluster that is out of range");
    values[i * static_cast<size_t>(lanes) + clusters[i]] = 1;
  }
  return Evidence(width, height, lanes, values);
}

}  // namespace vug::fit
