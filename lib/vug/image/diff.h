// Two pictures of one scene: the same, or different? Measures for every layer, limits on them, and
// where the noise is known a test of significance.
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

/// A picture with what its file tells about it.
struct ImageUnderTest {
  std::string name;  ///< For messages: the file.
  Image image;
  Metadata metadata;
  int left = 0, top = 0;                      ///< Where it lies in a larger picture.
  WorkingSpace space = WorkingSpace::rec709;  ///< Of its colours.
  bool screen = false;  ///< Integer codes of a screen's picture (PNG), read as linear light.
};

/// Error(bad_input) as for `read`.
ImageUnderTest read_image_under_test(const std::filesystem::path& file);

/// A pixel counts where the mask's first channel is at least 0.5. Error(bad_input) when the file
/// cannot be read, is not of this size, or lets nothing through.
std::vector<uint8_t> read_mask(const std::filesystem::path& file, int width, int height);

/// What a measure may be at most, or at least where more is better.
struct Limit {
  std::string layer;  ///< Empty: the main layers.
  std::string measure;
  double value = 0;
};

struct DiffOptions {
  /// Layers to compare; these are then the main ones. Empty: all but `variance` and `samples`,
  /// which both pictures must share, and the main one is the beauty, or all where there is none.
  std::vector<std::string> layers;
  std::vector<std::string> measures;  ///< For the main layers; empty: all that fit.
  /// A layer with limits is judged by them. A beauty without is judged by the test of significance
  /// where a variance is there. Without any limit or variance all layers are judged by kRounding.
  std::vector<Limit> limits;
  /// Demands the test of significance, also beside limits, at this rate of false alarms.
  std::optional<double> false_alarm_rate;
  std::optional<double> exposure;    ///< Stops for what is shown; none: that makes middle grey.
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

/// How the verdict was reached.
enum class Basis {
  identical,     ///< Every value of every layer compared is the same.
  limits,        ///< Limits were given; the test of significance may have had a say (`tested`).
  significance,  ///< That test alone.
  rounding,      ///< Neither: relative_max of every layer against kRounding.
};

/// The limit without any other: twice what rounding to 16-bit floats does to a value.
inline constexpr double kRounding = 1e-3;
inline constexpr double kFalseAlarmRate = 0.01;

struct Diff {
  bool same = true;
  Basis basis = Basis::identical;
  std::vector<LayerResult>
      rows;  ///< Layer by layer; of identical ones that are not main only limits.
  std::vector<std::string> identical;  ///< Layers without a difference, the main ones aside.
  std::optional<Significance> significance;
  /// The same of a stereo picture's other views, with their names.
  std::vector<std::pair<std::string, Significance>> other_views;
  bool tested = false;                ///< Whether the verdict heeds `significance`.
  size_t not_finite = 0;              ///< Values in either picture, among those that count.
  std::vector<std::string> unjudged;  ///< Layers that differ but no limit or test speaks about.
  std::vector<std::string> reasons;   ///< Why they are different, in sentences.
  double exposure = 0;                ///< Stops at which the measures of an eye looked.

  // For reports; of the first main layer.
  std::string shown_layer;
  Comparison shown;
  std::string heat_measure;  ///< "flip" for colours, else "max".
  std::vector<float> heat;   ///< In [0, 1], for each pixel.
};

/// Error(bad_input) with a hint: different sizes or colour spaces, channels that one picture lacks,
/// layers, measures or limits that do not exist, a test of significance without variance. Swapping
/// the pictures swaps signs and roles, but never the verdict. Of pictures for stereo both views are
/// compared, and share the rate of false alarms; "right.N" names a layer of one, "N" that of both.
Diff diff(const ImageUnderTest& reference, const ImageUnderTest& test,
          const DiffOptions& options = {});

/// "beauty.rmse" or "rmse", with its value; Error(bad_input) for an unknown measure, or
/// where not even equal pictures pass.
Limit limit_of(const std::string& name, double value);

/// From black over red to pale yellow, light rising with t in [0, 1]: linear channels R, G, B.
Image heat_map(const std::vector<float>& values, int width, int height);

}  // namespace vug::image
