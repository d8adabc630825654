// Whether two rendered pictures differ by more than their noise: a test of significance with a
// chosen rate of false alarms.
//
// What is asked of the noise: pixels (or at least the blocks below) err independently of each
// other, and the same law holds for both pictures when nothing changed. Variances may be too large,
// as they are for Sobol points: then fewer false alarms are raised than were chosen, and some power
// is lost.
#pragma once

#include <vug/image/image.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vug::image {

/// A picture R, G, B with what is known of its noise.
struct NoisyPicture {
  Image mean;                     ///< R, G, B.
  std::optional<Image> variance;  ///< R, G, B: squared standard error of the pixel's mean.
  std::vector<float> samples;     ///< For each pixel; empty: not known.
};

struct SignificanceOptions {
  double false_alarm_rate = 0.01;  ///< Chance that two pictures of one scene are called different.
  int block = 0;  ///< Pixels on a side; 0: 20, less where that gave fewer than 64 blocks.
};

/// One of the ways in which the pictures may differ.
struct Finding {
  std::string name;     ///< "bias", "spread", "block" or "pixels".
  std::string channel;  ///< Where it is most unlikely.
  double value = 0;     ///< The statistic: a z-score, or for "pixels" a share in [0, 1].
  double p_value =
      1;  ///< Of a value like that by noise alone, corrected for all that was looked at.
  bool different = false;
};

struct Significance {
  bool different = false;
  double p_value = 1;  ///< The least one of the findings, corrected for their number.
  std::vector<Finding> findings;
  int block = 0;  ///< Pixels on a side, about.
  size_t blocks = 0;
  double mean_z = 0;     ///< Of the blocks' z-scores over all channels.
  double std_z = 0;      ///< About 1 where only noise differs; less with Sobol points.
  double beyond_3 = 0;   ///< Share of blocks with |z| > 3; 0.0027 is expected of noise.
  double bias = 0;       ///< Mean of test over mean of reference, less 1.
  std::vector<float> z;  ///< Of the block each pixel lies in: the channel that is furthest off.
};

/// Blocks have z-scores: their mean difference over its standard error. One set comes from the
/// pixels' variances. Where both pictures have as many samples (within a tenth) a second set comes
/// from the scatter of the block's own pixels (Student's t): their noise is then symmetric, so that
/// no variance is needed, and what Sobol points gain is gained here too. Findings, each at its part
/// of the alarm rate (Sidak), and over both sets and the channels:
///   bias    z-scores lean to one side: t = sum w z / sqrt(sum w^2 z^2), which wrong variances do
///           not disturb; w favours blocks with much signal and is capped
///   spread  z-scores lie further from 0 than chance allows (sum of squares, chi-square)
///   block   one block is off (largest |z|, Sidak over blocks)
///   pixels  more than 0.25 % of the pixels have a chance below the level that is corrected for
///           their number (the rule of Mitsuba 3's render tests, jakob2022mitsuba3)
/// Variances of both pictures are pooled over their samples (as in Student's test), which keeps
/// the skewed noise of light transport from leaning on z when the sample counts differ. To them the
/// error of 16-bit storage is added, 5e-4 of the value, and a floor of 1e-4 of the picture's
/// log-average, so that values without noise can be compared.
/// Needs the variance of one picture at least; the other's is then inferred from the sample counts,
/// or taken for 0 where these are not known. Pixels that are not finite are left out.
/// Error(bad_input) without any variance, for unequal sizes, or where fewer than 2 pixels count.
Significance test_significance(const NoisyPicture& reference, const NoisyPicture& test,
                               const std::vector<uint8_t>& mask = {},
                               const SignificanceOptions& options = {});

/// Chance that a standard normal deviate lies at least |z| from 0.
double two_sided_p_value(double z);

}  // namespace vug::image
