// SPDX-License-Identifier: Apache-2.0
// Statistics of the widths and heights of passages, and the drawing of cross-sections with given
// statistics. Widths are left + right, heights up + down. Both are lognormal and correlated along
// the passage with the variogram (1 - nugget) (1 - exp(-3 d / range)) + nugget of their logarithms,
// where d is the distance along the legs in metres, as surveys of real caves show.
#pragma once

#include <vug/network/network.h>

#include <cstdint>

namespace vug::network {

/// Statistics to draw from. The defaults are between those of the caves in section_models().
struct SectionModel {
  double width_median = 1.25;      ///< Metres.
  double width_spread = 0.75;      ///< Standard deviation of the logarithm.
  double height_median = 1.75;     ///< Metres.
  double height_spread = 1.0;      ///< Standard deviation of the logarithm.
  double correlation = 0.35;       ///< Between ln width and ln height at a station, in -1..1.
  double nugget = 0.3;             ///< Fraction of the variance that differs between near stations.
  double range = 50;               ///< Metres until 95 % of the remaining correlation is lost.
  double off_centre_width = 0.49;  ///< Mean of |left - right| / width, in 0..1.
  double off_centre_height = 0.35;  ///< Mean of |up - down| / height, in 0..1.
  double least_width = 0;           ///< Metres; smaller widths that are drawn become this one.
  double least_height = 0;          ///< Metres.
};

/// A surveyed cave and its statistics.
struct NamedSectionModel {
  const char* name;
  SectionModel model;
};
const std::vector<NamedSectionModel>& section_models();

/// Returns the network with a cross-section at each station that had none. Stations near measured
/// ones depend on them. Sides of the passage are drawn independently: surveys contain the size of
/// the offset from the middle, but not its direction. The result depends on the seed, the order of
/// the stations and the legs only. Throws Error(bad_input) for an invalid model or network.
Network draw_sections(Network network, const SectionModel& model, uint64_t seed);

/// Statistics of the stations that have all four distances, a width and a height. Values are NaN
/// where too few stations exist.
struct SectionSummary {
  int count = 0;
  double width_median = 0;       ///< Metres.
  double width_spread = 0;       ///< Standard deviation of the logarithm (N - 1).
  double height_median = 0;      ///< Metres.
  double height_spread = 0;      ///< Standard deviation of the logarithm (N - 1).
  double ratio_median = 0;       ///< Median of width / height.
  double correlation = 0;        ///< Between ln width and ln height.
  double width_lag = 0;          ///< Correlation of ln width at the two ends of legs.
  double height_lag = 0;         ///< Correlation of ln height at the two ends of legs.
  double off_centre_width = 0;   ///< Mean of |left - right| / width.
  double off_centre_height = 0;  ///< Mean of |up - down| / height.
};
SectionSummary measure_sections(const Network& network);

}  // namespace vug::network
