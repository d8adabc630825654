// SPDX-License-Identifier: Apache-2.0
// Tracks which blocks of cells need work, so that inactive cells cost nothing.
#pragma once

#include <vug/cells/attributes.h>
#include <vug/cells/links.h>

#include <algorithm>
#include <utility>

namespace vug::cells {

/// Cells per task: enough to amortise the scheduling, few enough for the second-level cache.
inline constexpr uint32_t kBlock = 8192;

class Blocks {
 public:
  Blocks(const Links& links, const std::vector<CellState>& states);

  uint32_t count() const { return static_cast<uint32_t>(receiving_.size()); }
  uint32_t first(uint32_t block) const { return block * kBlock; }
  uint32_t end(uint32_t block) const { return std::min(cells_, (block + 1) * kBlock); }
  /// Number of links if it is the same for every cell of the block, otherwise 0.
  uint32_t degree(uint32_t block) const { return degree_[block]; }
  /// The range of cells that contains the block and all cells linked to it, limited to one block
  /// beyond either end.
  std::pair<uint32_t, uint32_t> around(uint32_t block) const { return around_[block]; }
  /// Whether every cell of the block receives.
  bool all_receive(uint32_t block) const { return receiving_[block] == end(block) - first(block); }
  /// The indices of blocks with receiving cells.
  const std::vector<uint32_t>& active() const { return active_; }
  /// Whether every cell distributes.
  bool all_distribute() const { return silent_total_ == 0; }

  /// Re-evaluates the states in these blocks.
  void update(const std::vector<uint32_t>& blocks, const std::vector<CellState>& states);
  std::vector<uint32_t> all() const;

 private:
  uint32_t cells_;
  std::vector<uint32_t> degree_, receiving_, silent_, active_;
  std::vector<std::pair<uint32_t, uint32_t>> around_;
  uint64_t silent_total_ = 0;
};

}  // namespace vug::cells
