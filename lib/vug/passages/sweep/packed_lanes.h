// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: the voxels of a block at which a segment is evaluated, without gaps.
#pragma once

#include <vug/field/near_surface.h>
#include <vug/passages/sweep/lane_order.h>

#include <bit>

namespace vug::passages {

using field::Pack;

/// Three numbers for each chosen lane of the runs of a block, and room for what is computed from
/// them. The rest of the last pack repeats the last lane, so that results depend on nothing else.
class PackedLanes {
 public:
  static constexpr size_t kRuns = field::LatticeBlock::kRuns, kMost = 8 * kRuns;
  struct Run {
    uint8_t run, lanes;
    uint16_t first;  ///< The position of the run's first lane in the packed order.
  };

  void clear() { runs_ = lanes_ = 0; }
  void add(size_t run, unsigned lanes, const Pack& a, const Pack& b, const Pack& c) {
    const __m256i order = lane_order(kLanesOf, lanes);
    permuted(a, order).store(numbers_[0] + lanes_);
    permuted(b, order).store(numbers_[1] + lanes_);
    permuted(c, order).store(numbers_[2] + lanes_);
    run_[runs_++] = {static_cast<uint8_t>(run), static_cast<uint8_t>(lanes),
                     static_cast<uint16_t>(lanes_)};
    lanes_ += static_cast<size_t>(std::popcount(lanes));
  }

  /// Completes the last pack. There must be a lane.
  void finish() {
    for (float* numbers : numbers_) Pack(numbers[lanes_ - 1]).store(numbers + lanes_);
  }

  size_t runs() const { return runs_; }
  const Run& run(size_t i) const { return run_[i]; }
  size_t packs() const { return (lanes_ + 7) / 8; }
  Pack number(size_t i, size_t pack) const { return Pack::load(numbers_[i] + 8 * pack); }
  void set_result(size_t i, size_t pack, const Pack& x) { x.store(results_[i] + 8 * pack); }
  /// The results of a run in its lanes; other lanes have no meaning.
  Pack result(size_t i, const Run& run) const {
    return permuted(Pack::load(results_[i] + run.first), lane_order(kRanksOf, run.lanes));
  }

 private:
  Run run_[kRuns];
  size_t runs_ = 0, lanes_ = 0;
  float numbers_[3][kMost + 8] = {};
  float results_[4][kMost + 8] = {};
};

/// The numbers of a result as an array.
inline constexpr size_t numbers_of(const field::FirstOrder*) { return 2; }
inline constexpr size_t numbers_of(const field::Dual<Pack>*) { return 4; }
inline void keep_result(PackedLanes& lanes, size_t pack, const field::FirstOrder& x) {
  lanes.set_result(0, pack, x.value);
  lanes.set_result(1, pack, x.distance);
}
inline void keep_result(PackedLanes& lanes, size_t pack, const field::Dual<Pack>& x) {
  lanes.set_result(0, pack, x.v);
  lanes.set_result(1, pack, x.dx);
  lanes.set_result(2, pack, x.dy);
  lanes.set_result(3, pack, x.dz);
}

}  // namespace vug::passages
