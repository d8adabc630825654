// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: whether the neighbours of a few samples are connected without them.
#pragma once

#include <vug/volume/sign_cube.h>

#include <vector>

namespace vug::volume {

/// Searches the samples of one side in a cube without the samples at its centre, from all of their
/// neighbours at the same time. The smallest set always grows next, so that a dead end costs
/// little.
class AroundCentre {
 public:
  AroundCentre(const std::vector<Offset>& centre, int reach);

  /// Whether all samples on this side among the 26 neighbours are connected by steps along the axes
  /// within the cube. `inside(offset)` is the side of a sample.
  template <class Inside>
  bool connected(const Inside& inside, bool side) {
    for (const Offset& each : centre_)
      for (int n = 0; n < 27; ++n) {
        const Offset at{each[0] + n / 9 - 1, each[1] + n / 3 % 3 - 1, each[2] + n % 3 - 1};
        if (holds(at) && inside(at) == side && label(at) == 0) start(at);
      }
    while (roots_ > 1) {
      const size_t set = smallest();
      if (sets_[set].pending.empty()) return false;
      const Offset at = sets_[set].pending.back();
      sets_[set].pending.pop_back();
      for (const Offset& next : neighbours(at))
        if (holds(next) && inside(next) == side) reach(set, next);
    }
    return true;
  }

 private:
  struct Set {
    std::vector<Offset> pending;
    size_t size = 0, parent = 0;
  };

  void start(const Offset& at);
  void reach(size_t set, const Offset& at);  ///< Adds the sample, or joins the set that has it.
  size_t smallest() const;
  size_t root(size_t set) const;
  bool holds(const Offset& at) const;  ///< Within the cube, and not at its centre.
  uint8_t& label(const Offset& at);
  static std::array<Offset, 6> neighbours(const Offset& at);

  std::vector<Offset> centre_;
  int reach_;
  std::vector<uint8_t> labels_;  ///< 1 + index of the set of each sample; 0: none.
  std::vector<Set> sets_;
  size_t roots_ = 0;
};

}  // namespace vug::volume
