// A few sizes of windows for many cells: which sizes, and which of them each cell has.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace vug::fit {

struct WindowSize {
  int width = 0, height = 0;  ///< Pixels.
  bool operator==(const WindowSize&) const = default;
};

/// What a window gains in each cell, at each size from `least` to `most`.
struct SizeGains {
  WindowSize min_size, max_size;
  std::vector<std::vector<double>> cells;  ///< Of each cell the sizes, row after row of widths;
                                           ///< 0 for those that have no room there.

  size_t count() const {
    return static_cast<size_t>((max_size.width - min_size.width + 1) *
                               (max_size.height - min_size.height + 1));
  }
  WindowSize size(size_t at) const {
    const auto across = static_cast<size_t>(max_size.width - min_size.width + 1);
    return {min_size.width + static_cast<int>(at % across),
            min_size.height + static_cast<int>(at / across)};
  }
};

struct SizeChoice {
  std::vector<WindowSize> sizes;
  std::vector<int> kinds;  ///< Of each cell: 0 nothing, else one more than the place of its size.
  double gain = 0;         ///< Of all cells.
};

/// The sizes with, for each cell, what gains most there: `gain(cell, k)` is that of sizes[k], and
/// nothing gains 0.
template <class Gain>
SizeChoice best_of_each(std::vector<WindowSize> sizes, size_t cells, const Gain& gain) {
  SizeChoice out;
  out.sizes = std::move(sizes);
  for (size_t cell = 0; cell < cells; ++cell) {
    int best = 0;
    double most = 0;
    for (size_t k = 0; k < out.sizes.size(); ++k)
      if (const double here = gain(cell, k); here > most)
        most = here, best = static_cast<int>(k) + 1;
    out.kinds.push_back(best);
    out.gain += most;
  }
  return out;
}

/// For one size, two, and so on up to `most`, as long as another could gain more than `cost`: sizes
/// of which none can be changed alone such that the cells, each with what gains most there, gain
/// more. Each begins with the last ones and the size that adds most (k-medians, where centres are
/// found one by one and exchanged; cite kaufman1990).
std::vector<SizeChoice> choose_sizes(const SizeGains& gains, int most, double cost);

}  // namespace vug::fit
