// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/base/vec.h>
#include <vug/image/significance.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::image {
namespace {

constexpr double kStorage = 5e-4;       ///< Relative rounding error of a half.
constexpr double kFloor = 1e-4;         ///< Relative to the log-average of the image.
constexpr double kPixelShare = 0.0025;  ///< Fraction of the pixels that may fail (Mitsuba 3).
constexpr size_t kFamilies = 4;
constexpr double kLeastScatter = 12;  ///< Minimum number of pixels for a meaningful scatter.
constexpr size_t kChannels = 3;

std::string channel_name(size_t channel) { return std::string(1, "RGB"[channel]); }

Finding finding_of(const char* name) {
  Finding out;
  out.name = std::string(name);
  out.channel = channel_name(0);
  return out;
}

/// Probability that at least one of `count` independent events of probability p occurs.
double probability_of_any(double p, double count) {
  if (p >= 1) return 1;
  return p < 1e-9 ? std::min(1.0, p * count) : 1 - maths::exp(count * maths::log(1 - p));
}

/// The probability of each of `count` events that gives `any` for at least one of them.
double probability_of_each(double any, double count) {
  return 1 - maths::exp(maths::log(1 - any) / count);
}

/// One channel of one pixel of both images.
struct Entry {
  double difference = 0, size = 0, variance = 0;
  bool counts = false;
};

/// The variance of a difference from pooled variances of single samples; see the header.
double pooled(std::optional<double> va, std::optional<double> vb, double na, double nb) {
  const bool counted = na > 0 && nb > 0;
  if (!counted) return va.value_or(0) + vb.value_or(0);
  const double sample = va && vb ? (na * na * *va + nb * nb * *vb) / (na + nb)
                        : va     ? *va * na
                                 : *vb * nb;
  return sample * (1 / na + 1 / nb);
}

double value(const Image& image, size_t pixel, size_t channel) {
  return static_cast<double>(image.pixels[pixel * kChannels + channel]);
}

std::optional<double> variance(const NoisyPicture& picture, size_t pixel, size_t channel) {
  if (!picture.variance) return {};
  const double v = value(*picture.variance, pixel, channel);
  return std::isfinite(v) ? std::max(v, 0.0) : 0.0;
}

/// The log-average of lit pixels, which visible lights hardly affect.
double typical_size(const NoisyPicture& a, const NoisyPicture& b) {
  double sum = 0;
  size_t count = 0;
  for (const Image* image : {&a.mean, &b.mean})
    for (const float v : image->pixels)
      if (std::isfinite(v) && v > 0) {
        sum += maths::log(static_cast<double>(v));
        ++count;
      }
  return count > 0 ? maths::exp(sum / static_cast<double>(count)) : 0;
}

std::vector<Entry> entries(const NoisyPicture& a, const NoisyPicture& b,
                           const std::vector<uint8_t>& mask) {
  std::vector<Entry> out(a.mean.pixels.size());
  const double floor = kFloor * typical_size(a, b);
  for (size_t i = 0; i < out.size(); ++i) {
    const size_t p = i / kChannels, c = i % kChannels;
    const double x = value(a.mean, p, c), y = value(b.mean, p, c);
    if ((!mask.empty() && mask[p] == 0) || !std::isfinite(x) || !std::isfinite(y)) continue;
    const double na = a.samples.empty() ? 0 : static_cast<double>(a.samples[p]);
    const double nb = b.samples.empty() ? 0 : static_cast<double>(b.samples[p]);
    out[i].counts = true;
    out[i].difference = y - x;
    out[i].size = 0.5 * (std::fabs(x) + std::fabs(y));
    out[i].variance = pooled(variance(a, p, c), variance(b, p, c), na, nb) + floor * floor;
  }
  return out;
}

/// Sums over a block, and its mean difference in standard errors. There are two z-scores: one from
/// the images' variances, one from the scatter of the block's own pixels.
struct Block {
  double difference = 0, square = 0, size = 0, variance = 0;
  double count = 0;

  void add(const Entry& e) {
    if (!e.counts) return;
    difference += e.difference, square += e.difference * e.difference;
    size += e.size, variance += e.variance;
    ++count;
  }
  double stored() const { return kStorage * size / count; }
  double deviation() const { return std::sqrt(variance / (count * count) + stored() * stored()); }
  double z() const { return count > 0 && deviation() > 0 ? difference / count / deviation() : 0; }
  /// Student's t of the pixels, converted to the normal deviate of the same probability
  /// (wallace1959).
  double scatter_z() const {
    if (count < kLeastScatter) return 0;
    const double mean = difference / count, free = count - 1;
    const double error = std::max(0.0, square / count - mean * mean) / free;
    const double deviation = std::sqrt(error + stored() * stored());
    if (!(deviation > 0)) return 0;
    const double t = mean / deviation;
    const double z =
        (8 * free + 1) / (8 * free + 3) * std::sqrt(free * maths::log(1 + t * t / free));
    return std::copysign(z, t);
  }
  double signal() const { return deviation() > 0 ? size / count / deviation() : 0; }
};

struct Grid {
  int across, down;
  int block_of(int x, int y, int width, int height) const {
    return y * down / height * across + x * across / width;
  }
};

int block_size(const Image& image, int wanted) {
  if (wanted > 0) return wanted;
  const int most = static_cast<int>(std::sqrt(static_cast<double>(image.pixel_count()) / 64));
  return std::clamp(most, 4, 20);
}

using Blocks = std::array<std::vector<Block>, kChannels>;

Blocks blocks_of(const std::vector<Entry>& entries, const Image& image, const Grid& grid) {
  Blocks out;
  out.fill(std::vector<Block>(static_cast<size_t>(grid.across * grid.down)));
  size_t i = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (size_t c = 0; c < kChannels; ++c, ++i)
        out[c][static_cast<size_t>(grid.block_of(x, y, image.width, image.height))].add(entries[i]);
  return out;
}

/// The z-scores of one channel's blocks, and their weights.
struct Scores {
  size_t channel = 0;
  std::vector<double> z, signal;
};

/// The scores from the variances; then, if both images have equal sample counts, those from the
/// scatter of the pixels: a difference is then as likely as its opposite, whatever the noise, and
/// the scatter reflects the lower error of Sobol points.
std::vector<Scores> scores_of(const Blocks& blocks, bool exchangeable) {
  std::vector<Scores> out;
  for (const bool scatter : {false, true})
    for (size_t c = 0; c < kChannels && (!scatter || exchangeable); ++c) {
      Scores scores;
      scores.channel = c;
      for (const Block& b : blocks[c]) {
        if (b.count == 0) continue;
        scores.z.push_back(scatter ? b.scatter_z() : b.z());
        scores.signal.push_back(b.signal());
      }
      out.push_back(std::move(scores));
    }
  return out;
}

/// The least likely of the scores by `statistic`, a z-score, and its p-value.
template <class Statistic, class PValue>
Finding least_likely(const char* name, const std::vector<Scores>& all, Statistic statistic,
                     PValue chance) {
  Finding out = finding_of(name);
  bool first = true;
  for (const Scores& scores : all) {
    const double z = statistic(scores), p = chance(z);
    if (!first && p >= out.p_value) continue;
    out.value = z, out.p_value = p, out.channel = channel_name(scores.channel);
    first = false;
  }
  out.p_value = probability_of_any(out.p_value, static_cast<double>(all.size()));
  return out;
}

Finding find_bias(const std::vector<Scores>& all) {
  const auto lean = [](const Scores& scores) {
    std::vector<double> ordered = scores.signal;
    std::sort(ordered.begin(), ordered.end());
    const double most = 4 * ordered[ordered.size() / 2];
    double sum = 0, squares = 0;
    for (size_t i = 0; i < scores.z.size(); ++i) {
      const double w = std::min(scores.signal[i], most) * scores.z[i];
      sum += w, squares += w * w;
    }
    return squares > 0 ? sum / std::sqrt(squares) : 0.0;
  };
  return least_likely("bias", all, lean, two_sided_p_value);
}

Finding find_spread(const std::vector<Scores>& all) {
  const auto spread = [](const Scores& scores) {
    double squares = 0;
    for (const double z : scores.z) squares += z * z;
    const double n = static_cast<double>(scores.z.size());
    // Wilson and Hilferty's cube root of a chi-square deviate (wilson1931).
    const double k = 2 / (9 * n);
    return ((squares > 0 ? maths::pow(squares / n, 1.0 / 3) : 0) - (1 - k)) / std::sqrt(k);
  };
  return least_likely("spread", all, spread,
                      [](double z) { return z > 0 ? 0.5 * two_sided_p_value(z) : 1.0; });
}

Finding find_block(const std::vector<Scores>& all) {
  const auto furthest = [](const Scores& scores) {
    double most = 0;
    for (const double z : scores.z)
      if (std::fabs(z) > std::fabs(most)) most = z;
    return most;
  };
  const auto count = static_cast<double>(all.front().z.size());
  return least_likely("block", all, furthest,
                      [&](double z) { return probability_of_any(two_sided_p_value(z), count); });
}

Finding find_pixels(const std::vector<Entry>& entries, double level) {
  double count = 0;
  for (const Entry& e : entries) count += e.counts ? 1 : 0;
  const double single = probability_of_each(level, std::max(count, 1.0));
  std::array<double, kChannels> failed{};
  for (size_t i = 0; i < entries.size(); ++i) {
    const Entry& e = entries[i];
    if (!e.counts || e.difference == 0) continue;
    const double stored = kStorage * e.size, sigma = std::sqrt(e.variance + stored * stored);
    if (two_sided_p_value(e.difference / sigma) < single) ++failed[i % kChannels];
  }
  Finding out = finding_of("pixels");
  const auto most = std::max_element(failed.begin(), failed.end());
  out.channel = channel_name(static_cast<size_t>(most - failed.begin()));
  out.value = (failed[0] + failed[1] + failed[2]) / std::max(count, 1.0);
  out.different = out.value > kPixelShare;
  out.p_value = out.different ? 0 : 1;
  return out;
}

void summarise(const Blocks& blocks, bool exchangeable, const Image& image, const Grid& grid,
               Significance& out) {
  double sum = 0, squares = 0, beyond = 0, n = 0;
  std::vector<double> furthest(blocks[0].size(), 0.0);
  for (const std::vector<Block>& channel : blocks)
    for (size_t i = 0; i < channel.size(); ++i) {
      if (channel[i].count == 0) continue;
      const double z = exchangeable ? channel[i].scatter_z() : channel[i].z();
      sum += z, squares += z * z, ++n;
      if (std::fabs(z) > 3) ++beyond;
      if (std::fabs(z) > std::fabs(furthest[i])) furthest[i] = z;
    }
  out.mean_z = sum / n;
  out.std_z = std::sqrt(std::max(0.0, squares / n - out.mean_z * out.mean_z));
  out.beyond_3 = beyond / n;
  out.blocks = static_cast<size_t>(n) / kChannels;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      out.z.push_back(static_cast<float>(
          furthest[static_cast<size_t>(grid.block_of(x, y, image.width, image.height))]));
}

/// Equal sample counts in both images, within a tenth.
bool same_samples(const NoisyPicture& a, const NoisyPicture& b) {
  if (a.samples.empty() || b.samples.empty()) return false;
  double sum_a = 0, sum_b = 0;
  for (const float n : a.samples) sum_a += static_cast<double>(n);
  for (const float n : b.samples) sum_b += static_cast<double>(n);
  return sum_a > 0 && std::fabs(sum_a - sum_b) <= 0.1 * sum_a;
}

void require_usable(const NoisyPicture& a, const NoisyPicture& b) {
  if (a.mean.width != b.mean.width || a.mean.height != b.mean.height)
    throw Error(ErrorCode::bad_input, "pictures of different size cannot be tested");
  if (!a.variance && !b.variance)
    throw Error(ErrorCode::bad_input, "neither image contains the variance of its pixels", {},
                "the statistical test reads the channels variance.R, variance.G and variance.B");
}

}  // namespace

double two_sided_p_value(double z) {
  const double x = std::fabs(z) / std::sqrt(2.0);
  if (!(x < 26)) return 0;  // Below the smallest number.
  if (x < 2) {              // 1 - erf(x) by its series.
    double term = x, sum = x;
    for (int k = 1; k < 60; ++k) {
      term *= -x * x / k;
      sum += term / (2 * k + 1);
    }
    return std::max(0.0, 1 - 2 / std::sqrt(kPi) * sum);
  }
  double fraction = 0;  // erfc(x) by its continued fraction.
  for (int k = 120; k > 0; --k) fraction = 0.5 * k / (x + fraction);
  return maths::exp(-x * x) / (std::sqrt(kPi) * (x + fraction));
}

Significance test_significance(const NoisyPicture& reference, const NoisyPicture& test,
                               const std::vector<uint8_t>& mask,
                               const SignificanceOptions& options) {
  require_usable(reference, test);
  const Image& image = reference.mean;
  const std::vector<Entry> all = entries(reference, test, mask);
  if (std::count_if(all.begin(), all.end(), [](const Entry& e) { return e.counts; }) < 6)
    throw Error(ErrorCode::bad_input, "too few pixels are left to test");
  Significance out;
  out.block = block_size(image, options.block);
  const Grid grid{std::max(1, image.width / out.block), std::max(1, image.height / out.block)};
  const Blocks blocks = blocks_of(all, image, grid);
  const double level = probability_of_each(options.false_alarm_rate, kFamilies);
  const bool exchangeable = same_samples(reference, test);
  const std::vector<Scores> scores = scores_of(blocks, exchangeable);
  out.findings = {find_bias(scores), find_spread(scores), find_block(scores),
                  find_pixels(all, level)};
  for (Finding& finding : out.findings) {
    finding.different = finding.different || finding.p_value < level;
    out.different = out.different || finding.different;
    out.p_value = std::min(out.p_value, probability_of_any(finding.p_value, kFamilies));
  }
  double difference = 0, size = 0;
  for (size_t i = 0; i < all.size(); ++i)
    if (all[i].counts)
      difference += all[i].difference, size += value(image, i / kChannels, i % kChannels);
  out.bias = size > 0 ? difference / size : 0;
  summarise(blocks, exchangeable, image, grid, out);
  return out;
}

}  // namespace vug::image
