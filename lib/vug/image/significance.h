// SPDX-License-Identifier: Apache-2.0
// A significance test, with a chosen false-alarm rate, for the question whether two rendered images
// differ by more than their noise.
//
// Assumptions: the errors of pixels (or at least of the blocks below) are independent, and follow
// the same law in both images if nothing changed. Variances may be too large, as they are for Sobol
// points: then there are fewer false alarms than chosen, and some power is lost.
#pragma once

#include <vug/image/image.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vug::image {

/// An image R, G, B and the known properties of its noise.
struct NoisyPicture {
  Image mean;                     ///< R, G, B.
  std::optional<Image> variance;  ///< R, G, B: squared standard error of the pixel mean.
  std::vector<float> samples;     ///< Samples per pixel; empty: unknown.
};

struct SignificanceOptions {
  double false_alarm_rate =
      0.01;       ///< Probability that two images of the same scene are declared different.
  int block = 0;  ///< Block size in pixels; 0: 20, or less if that gives fewer than 64 blocks.
};

/// Result of one of the individual tests.
struct Finding {
  std::string name;     ///< "bias", "spread", "block" or "pixels".
  std::string channel;  ///< The channel with the lowest p-value.
  double value = 0;     ///< The statistic: a z-score, or for "pixels" a fraction in [0, 1].
  double p_value = 1;   ///< Corrected for the number of tested values.
  bool different = false;
};

struct Significance {
  bool different = false;
  double p_value = 1;  ///< The smallest p-value of the findings, corrected for their number.
  std::vector<Finding> findings;
  int block = 0;  ///< Approximate block size in pixels.
  size_t blocks = 0;
  double mean_z = 0;    ///< Mean of the blocks' z-scores over all channels.
  double std_z = 0;     ///< About 1 if only noise differs; less with Sobol points.
  double beyond_3 = 0;  ///< Fraction of blocks with |z| > 3; 0.0027 is expected for noise.
  double bias = 0;      ///< Mean of test divided by mean of reference, minus 1.
  std::vector<float>
      z;  ///< For each pixel, the z-score of its block in the channel with the largest deviation.
};

/// Each block has a z-score: its mean difference divided by the standard error. One set of scores
/// uses the pixels' variances. If both images have equal sample counts (within a tenth), a second
/// set uses the scatter of the block's own pixels (Student's t): their noise is then symmetric, so
/// no variance is needed, and the lower error of Sobol points is accounted for. The tests, each at
/// its part of the false-alarm rate (Sidak) and over both sets and all channels:
///   bias    z-scores lean to one side: t = sum w z / sqrt(sum w^2 z^2), which is robust against
///           wrong variances; w favours blocks with much signal and is capped
///   spread  z-scores are further from 0 than chance allows (sum of squares, chi-square)
///   block   one block deviates (largest |z|, Sidak over blocks)
///   pixels  more than 0.25 % of the pixels have a p-value below the level corrected for their
///           number (the rule of Mitsuba 3's render tests, jakob2022mitsuba3)
/// The variances of both images are pooled over their samples (as in Student's test), so that the
/// skewed noise of light transport does not bias z if the sample counts differ. The error of 16-bit
/// storage is added, 5e-4 of the value, and a floor of 1e-4 of the image's log-average, so that
/// noise-free values can be compared. At least one image needs a variance; the other one's is
/// inferred from the sample counts, or taken as 0 if they are unknown. Pixels that are not finite
/// are ignored. Throws Error(bad_input) without any variance, for unequal sizes, or if fewer than 2
/// pixels are compared.
Significance test_significance(const NoisyPicture& reference, const NoisyPicture& test,
                               const std::vector<uint8_t>& mask = {},
                               const SignificanceOptions& options = {});

/// Probability that a standard normal deviate is at least |z| away from 0.
double two_sided_p_value(double z);

}  // namespace vug::image
