// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/fill_pools.h>
#include <vug/cells/level_key.h>

#include <functional>
#include <queue>

namespace vug::cells {
namespace {

/// The flooded surface grows from the outlets. A cell above a flooded neighbour drains to it, so
/// its level is its height. Only a flooded cell with a lower neighbour that is not flooded yet may
/// be a crest; crests wait in a heap, because water rises to the lowest of them first (zhou2016).
class Flood {
 public:
  Flood(const Links& links, const std::vector<float>& height)
      : links_(links), height_(height), level_(height.size()), seen_(height.size(), 0) {}

  void start(uint32_t outlet) { set(outlet, height_[outlet]); }

  std::vector<float> run() {
    grow();
    while (!crests_.empty()) {
      const auto crest = static_cast<uint32_t>(crests_.top());
      crests_.pop();
      submerge(crest);
      grow();
    }
    return std::move(level_);
  }

 private:
  void set(uint32_t cell, float level) {
    seen_[cell] = 1;
    level_[cell] = level;
    open_.push_back(cell);
  }
  void grow() {
    // First in, first out: the front moves upwards evenly, and few cells seem to be crests.
    for (size_t next = 0; next < open_.size(); ++next) {
      const uint32_t from = open_[next];
      bool is_crest = false;
      for (const uint32_t to : links_.of(from)) {
        if (seen_[to]) continue;
        if (height_[to] >= level_[from])
          set(to, height_[to]);
        else
          is_crest = true;
      }
      if (is_crest) crests_.push(level_key(level_[from], from));
    }
    open_.clear();
  }
  /// Fills the hollow behind a crest.
  void submerge(uint32_t crest) {
    const float level = level_[crest];
    under_.assign(1, crest);
    while (!under_.empty()) {
      const uint32_t from = under_.back();
      under_.pop_back();
      for (const uint32_t to : links_.of(from)) {
        if (seen_[to]) continue;
        if (height_[to] > level) {
          set(to, height_[to]);
        } else {
          seen_[to] = 1;
          level_[to] = level;
          under_.push_back(to);
        }
      }
    }
  }

  const Links& links_;
  const std::vector<float>& height_;
  std::vector<float> level_;
  std::vector<uint8_t> seen_;
  std::vector<uint32_t> open_, under_;
  std::priority_queue<uint64_t, std::vector<uint64_t>, std::greater<>> crests_;
};

}  // namespace

std::vector<float> fill_pools(const Links& links, const std::vector<float>& height,
                              const std::vector<uint8_t>& outlet) {
  Flood flood(links, height);
  for (uint32_t i = 0; i < height.size(); ++i)
    if (outlet[i]) flood.start(i);
  return flood.run();
}

}  // namespace vug::cells
