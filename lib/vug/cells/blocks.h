// Which blocks of cells have anything to do, so that cells that sleep cost nothing.
#pragma once

#include <vug/cells/attributes.h>
#include <vug/cells/links.h>

#include <algorithm>
#include <utility>

namespace vug::cells {

/// Cells of one task: enough to pay for handing it out, few enough to stay in the second cache.
inline constexpr uint32_t kBlock = 8192;

class Blocks {
 public:
  Blocks(const Links& links, const std::vector<CellState>& states);

  uint32_t count() const { return static_cast<uint32_t>(receiving_.size()); }
  uint32_t first(uint32_t block) const { return block * kBlock; }
  uint32_t end(uint32_t block) const { return std::min(cells_, (block + 1) * kBlock); }
  /// Links of every cell of the block; 0 where they differ.
  uint32_t degree(uint32_t block) const { return degree_[block]; }
  /// The cells from one to before another that hold the block and what it is linked to, but no more
  /// than a block beyond either end of it.
  std::pair<uint32_t, uint32_t> around(uint32_t block) const { return around_[block]; }
  /// Whether every cell of the block receives.
  bool all_receive(uint32_t block) const { return receiving_[block] == end(block) - first(block); }
  /// Blocks in which somebody receives, by number.
  const std::vector<uint32_t>& active() const { return active_; }
  /// Whether every cell distributes.
  bool all_distribute() const { return silent_total_ == 0; }

  /// Looks at the states in these blocks again.
  void update(const std::vector<uint32_t>& blocks, const std::vector<CellState>& states);
  std::vector<uint32_t> all() const;

 private:
  uint32_t cells_;
  std::vector<uint32_t> degree_, receiving_, silent_, active_;
  std::vector<std::pair<uint32_t, uint32_t>> around_;
  uint64_t silent_total_ = 0;
};

}  // namespace vug::cells
