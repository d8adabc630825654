// SPDX-License-Identifier: Apache-2.0
// Choice of a few window sizes for many cells, and of the size of each cell.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace vug::fit {

struct WindowSize {
  int width = 0, height = 0;  ///< Pixels.
  bool operator==(const WindowSize&) const = default;
};

/// Gain of a window in each cell, for each size from `min_size` to `max_size`.
struct SizeGains {
  WindowSize min_size, max_size;
  /// For each cell the gain of each size, widths varying fastest; 0 for sizes that do not fit.
  std::vector<std::vector<double>> cells;

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
  std::vector<int> kinds;  ///< For each cell: 0 for empty, else 1 + the index of its size.
  double gain = 0;         ///< Total gain over all cells.
};

/// Assigns to each cell the size with the largest gain, where `gain(cell, k)` is the gain of
/// sizes[k] and an empty cell gains 0.
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

/// Choices of one size, two sizes, and so on up to `most`, as long as another size could gain more
/// than `cost`. In each choice no single size can be exchanged to increase the total gain. Each
/// extends the previous one by the size that adds most (k-medians with greedy initialisation and
/// exchange; cite kaufman1990).
std::vector<SizeChoice> choose_sizes(const SizeGains& gains, int most, double cost);

}  // namespace vug::fit
