// How much of a picture would rather be windows than wall, over areas that are seen in several
// places at once.
#pragma once

#include <vug/fit/evidence/evidence.h>
#include <vug/fit/model/model.h>

namespace vug::fit {

/// Bits that a pixel saves, lane by lane, when it is a window's rather than the wall's.
using Gains = std::array<double, kMaxLanes>;

/// Of supervised evidence.
Gains supervised_gains();
/// Of clusters, from how the pixels of windows and wall of a tree are spread over them.
Gains gains_from_regions(const Sums& windows, const Sums& wall, int lanes);
/// Of what the windows of the grid below node i look like, as against all else in its area.
Gains gains_from_grid(const Model& model, const Evidence& evidence, const TreeState& state, int i);
double gain_of(const Gains& gains, const Sums& sums);

/// Of each pixel, row after row from the top.
struct GainMap {
  GainMap(const Evidence& evidence, const Gains& gains);

  int width = 0, height = 0;
  std::vector<double> gains;
};

/// An area whose places lie on top of one another, as a summed area table of gains.
class FoldedIntegral {
 public:
  FoldedIntegral(const GainMap& map, const TreeState& state, const Area& area);
  /// The same where the rectangle of the area gains nothing, as something else stands there.
  FoldedIntegral without(const Rect& rect) const;

  int width() const { return width_; }
  int height() const { return height_; }
  /// Of the pixels x0 <= x < x1, y0 <= y < y1 of the area, over all its places.
  double sum(int x0, int y0, int x1, int y1) const {
    return at(x1, y1) - at(x0, y1) - at(x1, y0) + at(x0, y0);
  }
  /// What could be gained if each square of a few pixels might be chosen by itself. Places that do
  /// not belong on top of one another take from it.
  double potential() const;

 private:
  double at(int x, int y) const {
    return table_[static_cast<size_t>(y) * static_cast<size_t>(width_ + 1) +
                  static_cast<size_t>(x)];
  }
  int width_, height_;
  std::vector<double> table_;
};

}  // namespace vug::fit
