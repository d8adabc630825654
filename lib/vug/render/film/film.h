// Where samples are gathered: sums for each pixel that any number of threads, passes or machines
// may fill in any order, and get the same bits.
#pragma once

#include <vug/render/camera.h>
#include <vug/render/film/fixed_point.h>
#include <vug/render/film/region.h>
#include <vug/render/integrator.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace vug::render {

/// The sums of one pixel. Each sample counts for its pixel alone and for all of it (box filter).
/// Sums are integers: `add` in any order and `merge` of any split give the same bits.
struct PixelSum {
  std::array<Wide, 3> light{}, square{};  ///< Radiance and its square, in 2^-64 and 2^-48.
  std::array<int64_t, 3> normal{}, position{}, albedo{};  ///< Of the first surface, in 2^-24.
  int64_t alpha = 0, depth = 0;                           ///< In 2^-24.
  uint32_t samples = 0;                                   ///< That the means are over.
  uint32_t hits = 0;     ///< Of these, those whose ray met a surface.
  uint32_t invalid = 0;  ///< Samples with a radiance that is no number: left out of everything.
  uint32_t clamped = 0;  ///< Samples brighter than kMaxLight, clamped to it.

  /// False when the sample was invalid.
  bool add(const PathResult& sample, const Camera& camera);
  void merge(const PixelSum& other);
  /// Mean radiance of a channel 0..2, and the variance of that mean (its squared standard error),
  /// from the spread of the samples; 0 for fewer than two samples.
  double mean(size_t channel) const;
  double variance(size_t channel) const;

  bool operator==(const PixelSum&) const = default;
};

/// The objects of a scene that a pixel's rays meet first, each with its number of samples, in the
/// order of their indices.
using Coverage = std::vector<std::pair<uint32_t, uint32_t>>;

/// What is summed beyond a PixelSum.
struct FilmLayout {
  size_t colours = 0;     ///< Further colours for each pixel: parts of the light.
  bool coverage = false;  ///< Which objects the rays meet.

  bool operator==(const FilmLayout&) const = default;
};

/// The sums of a rectangle of pixels.
class Film {
 public:
  Film() = default;
  Film(const Region& region, const FilmLayout& layout);

  const Region& region() const { return region_; }
  const FilmLayout& layout() const { return layout_; }
  PixelSum& at(int x, int y) { return sums_[region_.index(x, y)]; }
  const PixelSum& at(int x, int y) const { return sums_[region_.index(x, y)]; }
  /// Three sums, as PixelSum::light, for each of FilmLayout::colours.
  Wide* colours(int x, int y) {
    return colours_.data() + region_.index(x, y) * layout_.colours * 3;
  }
  const Wide* colours(int x, int y) const {
    return colours_.data() + region_.index(x, y) * layout_.colours * 3;
  }
  Coverage& coverage(int x, int y) { return coverage_[region_.index(x, y)]; }
  const Coverage& coverage(int x, int y) const { return coverage_[region_.index(x, y)]; }

  /// `values`: FilmLayout::colours of them.
  void add(int x, int y, const PathResult& sample, const Camera& camera, const Rgb* values);
  /// Adds what a film of the same FilmLayout holds where both overlap.
  void merge(const Film& other);

  /// PixelSum::invalid and ::clamped of all pixels.
  std::pair<uint64_t, uint64_t> invalid_samples() const;

  /// Bytes of a pixel, without coverage's lists.
  static double pixel_bytes(const FilmLayout& layout);

 private:
  Region region_;
  FilmLayout layout_;
  std::vector<PixelSum> sums_;
  std::vector<Wide> colours_;
  std::vector<Coverage> coverage_;
};

}  // namespace vug::render
