// SPDX-License-Identifier: Apache-2.0
// The statistics of the cross-sections of a network.
#include <vug/base/maths.h>
#include <vug/base/median.h>
#include <vug/network/graph.h>
#include <vug/network/section_statistics.h>

#include <cmath>

namespace vug::network {
namespace {

/// Sums for the mean, the spread and the correlation of pairs.
class PairSums {
 public:
  void add(double a, double b) {
    a_.push_back(a);
    b_.push_back(b);
  }

  double correlation() const {
    if (a_.size() < 2) return kUndefined;
    const double mean_a = mean(a_);
    const double mean_b = mean(b_);
    double aa = 0;
    double bb = 0;
    double ab = 0;
    for (size_t i = 0; i < a_.size(); ++i) {
      aa += (a_[i] - mean_a) * (a_[i] - mean_a);
      bb += (b_[i] - mean_b) * (b_[i] - mean_b);
      ab += (a_[i] - mean_a) * (b_[i] - mean_b);
    }
    return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : kUndefined;
  }

  static double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return values.empty() ? kUndefined : sum / static_cast<double>(values.size());
  }

 private:
  std::vector<double> a_;
  std::vector<double> b_;
};

double spread(const std::vector<double>& values) {
  if (values.size() < 2) return kUndefined;
  const double mean = PairSums::mean(values);
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

double median_of(const std::vector<double>& values) {
  return values.empty() ? kUndefined : median(values);
}

/// The logarithms of a station's width and height; NaN for a station without complete section.
struct LogSize {
  double width = kUndefined;
  double height = kUndefined;
};

LogSize log_size(const Station& station) {
  const auto& s = station.section;
  if (!s || !s->left || !s->right || !s->up || !s->down) return {};
  const double width = *s->left + *s->right;
  const double height = *s->up + *s->down;
  if (!(width > 0 && height > 0)) return {};
  return {maths::log(width), maths::log(height)};
}

}  // namespace

SectionSummary measure_sections(const Network& network) {
  require_valid(network);
  std::vector<LogSize> sizes;
  std::vector<double> widths, heights, ratios, width_offsets, height_offsets;
  PairSums at_stations;
  for (const Station& station : network.stations) {
    const LogSize size = log_size(station);
    sizes.push_back(size);
    if (std::isnan(size.width)) continue;
    const CrossSection& s = *station.section;
    widths.push_back(size.width);
    heights.push_back(size.height);
    ratios.push_back(size.width - size.height);
    width_offsets.push_back(std::abs(*s.left - *s.right) / (*s.left + *s.right));
    height_offsets.push_back(std::abs(*s.up - *s.down) / (*s.up + *s.down));
    at_stations.add(size.width, size.height);
  }
  PairSums width_pairs, height_pairs;
  for (const Leg& leg : network.legs) {
    const LogSize& from = sizes[static_cast<size_t>(leg.from)];
    const LogSize& to = sizes[static_cast<size_t>(leg.to)];
    if (leg.from == leg.to || std::isnan(from.width) || std::isnan(to.width)) continue;
    width_pairs.add(from.width, to.width);
    height_pairs.add(from.height, to.height);
  }
  return {.count = static_cast<int>(widths.size()),
          .width_median = maths::exp(median_of(widths)),
          .width_spread = spread(widths),
          .height_median = maths::exp(median_of(heights)),
          .height_spread = spread(heights),
          .ratio_median = maths::exp(median_of(ratios)),
          .correlation = at_stations.correlation(),
          .width_lag = width_pairs.correlation(),
          .height_lag = height_pairs.correlation(),
          .off_centre_width = PairSums::mean(width_offsets),
          .off_centre_height = PairSums::mean(height_offsets)};
}

}  // namespace vug::network
