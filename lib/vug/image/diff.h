// SPDX-License-Identifier: Apache-2.0
// Comparison of two images of one scene: measures for every layer, limits on them, and a
// significance test if the noise is known.
#pragma once

#include <vug/image/io.h>
#include <vug/image/layers.h>
#include <vug/image/measure.h>
#include <vug/image/significance.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vug::image {

/// An image with the relevant information from its file.
struct ImageUnderTest {
  std::string name;  ///< File name, for messages.
  Image image;
  Metadata metadata;
  int left = 0, top = 0;                      ///< Position in a larger image (crop).
  WorkingSpace space = WorkingSpace::rec709;  ///< Working space of its colours.
  bool screen = false;  ///< True for integer display values (PNG), read as linear light.
};

/// Throws Error(bad_input) as `read` does.
ImageUnderTest read_image_under_test(const std::filesystem::path& file);

/// Pixels whose first mask channel is at least 0.5 are compared. Throws Error(bad_input) if the
/// file cannot be read, has another size or selects no pixel.
std::vector<uint8_t> read_mask(const std::filesystem::path& file, int width, int height);

/// Maximum of a measure, or minimum if larger values are better.
struct Limit {
  std::string layer;  ///< Empty: the main layers.
  std::string measure;
  double value = 0;
};

struct DiffOptions {
  /// Layers to compare, which become the main layers. Empty: all layers except `variance` and
  /// `samples`, which both images must have in common; the main layer is then the beauty, or
  /// without a beauty all layers are.
  std::vector<std::string> layers;
  std::vector<std::string> measures;  ///< For the main layers; empty: all applicable measures.
  /// Layers with limits are judged by them. A beauty layer without limits is judged by the
  /// significance test if there is a variance. Without any limit or variance all layers are judged
  /// by kRounding.
  std::vector<Limit> limits;
  /// Requires the significance test, in addition to limits, with this false-alarm rate.
  std::optional<double> false_alarm_rate;
  std::optional<double> exposure;    ///< Exposure of the displayed images in stops; none: the
                                     ///< exposure that yields middle grey.
  bool reference_exposures = false;  ///< See Comparison.
  std::vector<uint8_t> mask;
};

struct LayerResult {
  std::string layer;
  std::string measure;
  double value = 0;
  std::optional<double> limit;
  bool passed = true;
};

/// The basis of the verdict.
enum class Basis {
  identical,     ///< Every value of every compared layer is identical.
  limits,        ///< Limits were given; the significance test may also have contributed (`tested`).
  significance,  ///< The significance test alone.
  rounding,      ///< Neither: relative_max of every layer is compared with kRounding.
};

/// The default limit: twice the rounding error of 16-bit floats.
inline constexpr double kRounding = 1e-3;
inline constexpr double kFalseAlarmRate = 0.01;

struct Diff {
  bool same = true;
  Basis basis = Basis::identical;
  std::vector<LayerResult> rows;  ///< Layer by layer; identical layers other than the main ones
                                  ///< appear only if they have limits.
  std::vector<std::string> identical;  ///< Identical layers, excluding the main ones.
  std::optional<Significance> significance;
  /// The significance tests of the other views of a stereo image, by view name.
  std::vector<std::pair<std::string, Significance>> other_views;
  bool tested = false;    ///< Whether the verdict takes `significance` into account.
  size_t not_finite = 0;  ///< NaN and infinite values in either image, among the compared pixels.
  std::vector<std::string> unjudged;  ///< Layers that differ but are covered by no limit or test.
  std::vector<std::string> words;     ///< What is different, for people: see describe_difference.
  std::vector<std::string> reasons;   ///< Statistics that led to the verdict "different".
  double exposure = 0;                ///< Exposure in stops used by the perceptual measures.

  // Data for reports, from the first main layer.
  std::string shown_layer;
  Comparison shown;
  std::string heat_measure;  ///< "flip" for colours, otherwise "max".
  std::vector<float> heat;   ///< One value in [0, 1] per pixel.
};

/// Throws Error(bad_input) with a hint for different sizes or colour spaces, channels missing in
/// one image, unknown layers, measures or limits, and a significance test without variance.
/// Swapping the images swaps signs and roles, but never the verdict. For stereo images both views
/// are compared and share the false-alarm rate; "right.N" names a layer of one view, "N" that of
/// both.
Diff diff(const ImageUnderTest& reference, const ImageUnderTest& test,
          const DiffOptions& options = {});

/// Parses "beauty.rmse" or "rmse" with its value. Throws Error(bad_input) for an unknown
/// measure, or if not even equal images would pass.
Limit limit_of(const std::string& name, double value);

/// Colour map from black through red to pale yellow, with luminance increasing with the value in
/// [0, 1]: linear channels R, G, B.
Image heat_map(const std::vector<float>& values, int width, int height);

}  // namespace vug::image
