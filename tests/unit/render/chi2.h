// SPDX-License-Identifier: Apache-2.0
// Pearson's chi-square test of directions against a density.
#pragma once

#include <vug/render/sampling.h>

#include <cmath>
#include <functional>
#include <vector>

namespace vug::render {

/// Upper tail of the chi-square distribution: Wilson and Hilferty 1931, accurate to 1e-3 for 10 and
/// more degrees of freedom.
inline double chi2_tail(double statistic, double freedom) {
  const double z =
      (std::cbrt(statistic / freedom) - (1 - 2 / (9 * freedom))) / std::sqrt(2 / (9 * freedom));
  return 0.5 * std::erfc(z / std::sqrt(2.0));
}

struct Chi2 {
  double p = 0;
  double integral = 0;    ///< Integral of the density over the tested cap; must be 1.
  int stray = 0;          ///< Samples in cells (or outside the cap) where the density is 0.
  int disagreements = 0;  ///< Samples whose reported density differs from the density there.
};

struct DirectionSample {
  Vec3f direction;
  double pdf = 0;  ///< 0: no sample.
};

/// Cells in the cap of directions around `axis` with 1 - cosine up to `cap` (2: all directions),
/// narrower towards the axis. The density of each is found by midpoint quadrature with `fine` steps
/// in each dimension, which resolves the edges of lights.
inline Chi2 chi2(const Vec3f& axis, double cap, int samples,
                 const std::function<DirectionSample(int)>& sample,
                 const std::function<double(const Vec3f&)>& pdf, int fine = 64) {
  constexpr int kRows = 12, kColumns = 24;
  const Frame frame(axis);
  std::vector<double> expected(kRows * kColumns, 0), seen(kRows * kColumns, 0);
  const double cell = 4 * kPi * cap / (kRows * kColumns * fine * fine);
  for (int i = 0; i < kRows * fine; ++i)
    for (int j = 0; j < kColumns * fine; ++j) {
      const double r = (i + 0.5) / (kRows * fine), turn = (j + 0.5) / (kColumns * fine);
      const Vec3f local =
          direction_off_axis(static_cast<float>(cap * r * r), static_cast<float>(turn));
      expected[static_cast<size_t>(i / fine * kColumns + j / fine)] +=
          cell * r * pdf(frame.to_world(local));
    }
  Chi2 out;
  for (double& e : expected) {
    out.integral += e;
    e *= samples;
  }
  for (int s = 0; s < samples; ++s) {
    const DirectionSample d = sample(s);
    if (!(d.pdf > 0)) continue;
    if (std::fabs(pdf(d.direction) - d.pdf) > 2e-3 * d.pdf) ++out.disagreements;
    const Vec3d local(frame.to_local(d.direction));
    const double squared_sine = std::min(1.0, local.x * local.x + local.y * local.y);
    const double cosine = std::copysign(std::sqrt(1 - squared_sine), local.z);
    const double off = local.z > 0 ? squared_sine / (1 + cosine) : 1 - cosine;
    const int row = static_cast<int>(kRows * std::sqrt(off / cap));
    double turn = std::atan2(local.y, local.x) / (2 * kPi);
    turn -= std::floor(turn);
    const int column = std::min(static_cast<int>(turn * kColumns), kColumns - 1);
    if (row >= kRows)
      ++out.stray;
    else
      seen[static_cast<size_t>(row * kColumns + column)] += 1;
  }
  double statistic = 0, pooled_expected = 0, pooled_seen = 0;
  int cells = 0;
  for (size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] == 0) out.stray += static_cast<int>(seen[i]);
    if (expected[i] < 5) {
      pooled_expected += expected[i];
      pooled_seen += seen[i];
    } else {
      statistic += (seen[i] - expected[i]) * (seen[i] - expected[i]) / expected[i];
      ++cells;
    }
  }
  if (pooled_expected >= 5) {
    statistic +=
        (pooled_seen - pooled_expected) * (pooled_seen - pooled_expected) / pooled_expected;
    ++cells;
  }
  out.p = cells > 1 ? chi2_tail(statistic, cells - 1) : 1;
  return out;
}

}  // namespace vug::render
