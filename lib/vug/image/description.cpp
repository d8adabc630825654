// SPDX-License-Identifier: Apache-2.0
#include <vug/image/description.h>
#include <vug/image/diff.h>
#include <vug/image/layers.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::image {
namespace {

/// Blocks of pixels along each side of the picture; their means hide most of the noise.
constexpr int kBlocks = 12;
/// Parts of the picture along each side, which have names.
constexpr size_t kParts = 3;
/// Added to the local brightness, as a fraction of the mean, so that black areas do not dominate.
constexpr double kFloor = 0.25;
/// Smaller changes of the mean are not worth a sentence.
constexpr double kSmallestChange = 5e-4;
/// Changes that differ by at most this factor are reported as one.
constexpr double kAlike = 1.3;

constexpr std::array<const char*, 3> kColours = {"red", "green", "blue"};
constexpr std::array<std::array<const char*, kParts>, kParts> kCorners = {
    {{"at the upper left", "at the top", "at the upper right"},
     {"at the left", "in the middle", "at the right"},
     {"at the lower left", "at the bottom", "at the lower right"}}};
constexpr std::array<const char*, kParts> kRows = {"at the top", "at middle height",
                                                   "at the bottom"};
constexpr std::array<const char*, kParts> kColumns = {"at the left", "in the middle",
                                                      "at the right"};

/// Means of a block for one channel.
struct BlockMeans {
  double reference = 0, test = 0, count = 0;

  double change() const { return count > 0 ? (test - reference) / count : 0; }
  double brightness() const { return count > 0 ? 0.5 * (reference + test) / count : 0; }
};

/// A weight for each block of the picture: the size of the difference there.
using Weights = std::array<double, kBlocks * kBlocks>;
using Channel = std::array<BlockMeans, kBlocks * kBlocks>;

size_t block_of(int x, int y, const Image& image) {
  return static_cast<size_t>(y * kBlocks / image.height * kBlocks + x * kBlocks / image.width);
}

/// Calls `visit(pixel, block)` for each compared pixel.
template <class Visit>
void for_each_pixel(const Comparison& pair, const Visit& visit) {
  const Image& image = pair.reference;
  size_t pixel = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x, ++pixel)
      if (pair.counts(pixel)) visit(pixel, block_of(x, y, image));
}

/// Where the weights are, for the end of a sentence.
std::string place_text(const Weights& weights) {
  std::array<std::array<double, kParts>, kParts> shares{};
  std::array<double, kParts> rows{}, columns{};
  double all = 0;
  for (size_t i = 0; i < weights.size(); ++i) {
    const size_t row = i / kBlocks * kParts / kBlocks, column = i % kBlocks * kParts / kBlocks;
    shares[row][column] += weights[i], rows[row] += weights[i], columns[column] += weights[i];
    all += weights[i];
  }
  if (!(all > 0)) return "";
  for (size_t row = 0; row < kParts; ++row)
    for (size_t column = 0; column < kParts; ++column)
      if (shares[row][column] > 0.4 * all)
        return fmt::format(", {} {}", shares[row][column] > 0.99 * all ? "only" : "most",
                           kCorners[row][column]);
  for (size_t i = 0; i < kParts; ++i) {
    if (rows[i] > 0.55 * all) return fmt::format(", most {}", kRows[i]);
    if (columns[i] > 0.55 * all) return fmt::format(", most {}", kColumns[i]);
  }
  return " everywhere";
}

std::array<Channel, 3> block_means(const Comparison& pair) {
  const Image reference = pair.reference.select({"R", "G", "B"});
  const Image test = pair.test.select({"R", "G", "B"});
  std::array<Channel, 3> out{};
  for_each_pixel(pair, [&](size_t pixel, size_t block) {
    for (size_t c = 0; c < 3; ++c) {
      const auto a = static_cast<double>(reference.pixels[3 * pixel + c]);
      const auto b = static_cast<double>(test.pixels[3 * pixel + c]);
      if (!std::isfinite(a) || !std::isfinite(b)) continue;
      out[c][block].reference += a, out[c][block].test += b, ++out[c][block].count;
    }
  });
  return out;
}

/// The change of a channel's mean over the whole picture.
struct Change {
  size_t channel = 0;
  double ratio = 1;       ///< Mean of the test divided by that of the reference.
  double mean = 0;        ///< Mean of both.
  bool one_sided = true;  ///< The blocks agree that it is brighter, or darker.

  bool matters() const { return one_sided && std::fabs(ratio - 1) >= kSmallestChange; }
  bool brighter() const { return ratio > 1; }
  /// At least 1, and the same for twice and half as bright.
  double factor() const { return brighter() ? ratio : 1 / std::max(ratio, 1e-9); }
};

Change change_of(const Channel& blocks, size_t channel) {
  BlockMeans all;
  double sum = 0, sizes = 0, squares = 0, used = 0;
  for (const BlockMeans& block : blocks) {
    all.reference += block.reference, all.test += block.test, all.count += block.count;
    if (block.count == 0) continue;
    const double change = block.change();
    sum += change, sizes += std::fabs(change), squares += change * change, ++used;
  }
  Change out{channel, 1, all.brightness(), true};
  if (all.reference > 0) out.ratio = all.test / all.reference;
  // Noise hides the sign of single blocks but not that of their mean: its standard error decides.
  const double deviation = std::sqrt(std::max(0.0, squares - sum * sum / std::max(used, 1.0)));
  out.one_sided = std::fabs(sum) > 0.7 * sizes || std::fabs(sum) > 4 * deviation;
  return out;
}

std::string amount_text(const Change& change) {
  if (change.ratio >= 2) return fmt::format("{:.2g} times as bright", change.ratio);
  const double percent = 100 * std::fabs(change.ratio - 1);
  return fmt::format("{} % {}",
                     percent < 1 ? fmt::format("{:.1g}", percent) : fmt::format("{:.0f}", percent),
                     change.brighter() ? "brighter" : "darker");
}

/// Channels that have changed alike, as "red and green are 8 % brighter".
std::string colours_text(const std::vector<Change>& alike) {
  if (alike.size() == kColours.size())
    return "the picture is " + amount_text(alike[1]);  // green has most of the luminance
  std::vector<std::string> names;
  for (const Change& change : alike) names.emplace_back(kColours[change.channel]);
  return fmt::format("{} {} {}", fmt::join(names, " and "), names.size() == 1 ? "is" : "are",
                     amount_text(alike.front()));
}

/// Changes of the same direction and of about the same size, together.
std::vector<std::vector<Change>> group_alike(const std::vector<Change>& changes) {
  std::vector<std::vector<Change>> groups;
  for (const Change& change : changes) {
    const auto same = [&](const std::vector<Change>& group) {
      const Change& first = group.front();
      const double a = std::fabs(first.ratio - 1), b = std::fabs(change.ratio - 1);
      return first.brighter() == change.brighter() && std::max(a, b) <= kAlike * std::min(a, b);
    };
    const auto group = std::find_if(groups.begin(), groups.end(), same);
    if (group != groups.end())
      group->push_back(change);
    else
      groups.push_back({change});
  }
  return groups;
}

std::string describe_colours(const Comparison& pair) {
  const std::array<Channel, 3> blocks = block_means(pair);
  std::vector<Change> all, shifted;
  for (size_t c = 0; c < 3; ++c) {
    all.push_back(change_of(blocks[c], c));
    if (all.back().matters()) shifted.push_back(all.back());
  }
  std::vector<std::string> sentences;
  for (const std::vector<Change>& group : group_alike(shifted))
    sentences.push_back(colours_text(group));
  if (sentences.empty()) sentences.emplace_back("parts are brighter and others darker");
  Weights weights{};
  for (const Change& change : shifted.empty() ? all : shifted)
    for (size_t i = 0; i < weights.size(); ++i) {
      const BlockMeans& block = blocks[change.channel][i];
      if (!shifted.empty() && (block.change() > 0) != change.brighter()) continue;
      const double size = block.brightness() + kFloor * change.mean;
      if (size > 0) weights[i] += block.change() * block.change() / (size * size);
    }
  return fmt::format("{}{}", fmt::join(sentences, ", "), place_text(weights));
}

bool differ(float a, float b) {
  if (std::isnan(a) && std::isnan(b)) return false;
  const double size =
      std::max(std::fabs(static_cast<double>(a)), std::fabs(static_cast<double>(b)));
  return !(std::fabs(static_cast<double>(a) - static_cast<double>(b)) <= kRounding * size) &&
         a != b;
}

std::string describe_values(const Comparison& pair, const std::string& layer) {
  const size_t stride = pair.reference.channels.size();
  Weights weights{};
  double count = 0, all = 0;
  for_each_pixel(pair, [&](size_t pixel, size_t block) {
    ++all;
    for (size_t c = 0; c < stride; ++c)
      if (differ(pair.reference.pixels[stride * pixel + c], pair.test.pixels[stride * pixel + c])) {
        ++count, ++weights[block];
        break;
      }
  });
  if (count == 0) return layer + " differs by little more than rounding";
  const double percent = 100 * count / all;
  if (percent >= 99.5) return layer + " differs in all pixels";
  return fmt::format("{} differs in {} of the pixels{}", layer,
                     percent < 0.1 ? "less than 0.1 %" : fmt::format("{:.2g} %", percent),
                     place_text(weights));
}

/// The number of pixels with a value that is not finite in one image only.
size_t not_finite_in_one(const Comparison& pair) {
  const size_t stride = pair.reference.channels.size();
  size_t count = 0;
  for_each_pixel(pair, [&](size_t pixel, size_t) {
    for (size_t c = 0; c < stride; ++c)
      if (std::isfinite(pair.reference.pixels[stride * pixel + c]) !=
          std::isfinite(pair.test.pixels[stride * pixel + c])) {
        ++count;
        break;
      }
  });
  return count;
}

}  // namespace

std::string describe_difference(const Comparison& pair, const std::string& layer) {
  const Differences found = differences(pair);
  if (!(found.largest > 0)) return "";
  const bool colours = Layer{layer, pair.reference.channels}.colour();
  std::string out = colours ? (layer == kBeauty ? "" : layer + ": ") + describe_colours(pair)
                            : describe_values(pair, layer);
  if (const size_t pixels = not_finite_in_one(pair); pixels > 0)
    out += fmt::format("; {} {} not finite in one picture", pixels,
                       pixels == 1 ? "pixel is" : "pixels are");
  return out;
}

}  // namespace vug::image
