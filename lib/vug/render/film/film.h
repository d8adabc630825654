// SPDX-License-Identifier: Apache-2.0
// The film accumulates samples: exact sums per pixel that any number of threads, passes or machines
// may fill in any order, with the same bits.
#pragma once

#include <vug/render/camera.h>
#include <vug/render/film/deep.h>
#include <vug/render/film/fixed_point.h>
#include <vug/render/film/region.h>
#include <vug/render/integrator.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace vug::render {

/// The sums of one pixel. Each sample counts fully for its own pixel (box filter). Sums are
/// integers: `add` in any order and `merge` of any partition give the same bits.
struct PixelSum {
  std::array<Wide, 3> light{}, square{};  ///< Radiance and its square, in units of 2^-64 and 2^-48.
  std::array<int64_t, 3> normal{}, position{},
      albedo{};                  ///< At the first surface, in units of 2^-24.
  int64_t alpha = 0, depth = 0;  ///< In units of 2^-24.
  uint32_t samples = 0;          ///< Number of valid samples.
  uint32_t hits = 0;             ///< Number of valid samples whose ray hit a surface.
  uint32_t invalid =
      0;  ///< Number of samples with a NaN or infinite radiance, which are discarded.
  uint32_t clamped = 0;  ///< Number of samples brighter than kMaxLight, which are clamped to it.

  /// Returns false if the sample was invalid.
  bool add(const PathResult& sample, const Camera& camera);
  void merge(const PixelSum& other);
  /// Mean radiance of a channel 0..2, and the variance of that mean (its squared standard error),
  /// estimated from the samples; 0 for fewer than two samples.
  double mean(size_t channel) const;
  double variance(size_t channel) const;

  bool operator==(const PixelSum&) const = default;
};

/// The objects that a pixel's camera rays hit first, with their numbers of samples, sorted by
/// object index.
using Coverage = std::vector<std::pair<uint32_t, uint32_t>>;

/// The data that a film accumulates in addition to PixelSum.
struct FilmLayout {
  size_t colours =
      0;  ///< Further colours per pixel: light components, light groups, and surface values.
  bool coverage = false;  ///< The objects that camera rays hit.
  bool deep = false;      ///< The fragments of a deep picture.

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
  /// Three sums for each of FilmLayout::colours, in the units of PixelSum::light.
  Wide* colours(int x, int y) {
    return colours_.data() + region_.index(x, y) * layout_.colours * 3;
  }
  const Wide* colours(int x, int y) const {
    return colours_.data() + region_.index(x, y) * layout_.colours * 3;
  }
  Coverage& coverage(int x, int y) { return coverage_[region_.index(x, y)]; }
  const Coverage& coverage(int x, int y) const { return coverage_[region_.index(x, y)]; }

  /// The fragments of a deep pixel, sorted by sample index.
  std::vector<DeepFragment>& fragments(int x, int y) { return fragments_[region_.index(x, y)]; }
  const std::vector<DeepFragment>& fragments(int x, int y) const {
    return fragments_[region_.index(x, y)];
  }

  /// Adds sample `index` of a pixel; larger indices must follow smaller ones. `values`: as many as
  /// FilmLayout::colours.
  void add(int x, int y, uint32_t index, const PathResult& sample, const Camera& camera,
           const Rgb* values);
  /// Adds the overlapping pixels of another film with the same FilmLayout and other samples.
  void merge(const Film& other);

  /// The sums of PixelSum::invalid and PixelSum::clamped over all pixels.
  std::pair<uint64_t, uint64_t> invalid_samples() const;

  /// Bytes per pixel with this number of samples, without the lists of coverage.
  static double pixel_bytes(const FilmLayout& layout, double samples);

 private:
  Region region_;
  FilmLayout layout_;
  std::vector<PixelSum> sums_;
  std::vector<Wide> colours_;
  std::vector<Coverage> coverage_;
  std::vector<std::vector<DeepFragment>> fragments_;
};

}  // namespace vug::render
