// SPDX-License-Identifier: Apache-2.0
// Lookahead for the start of the next rule in a grammar's block.
#pragma once

#include <vug/scene/cursor.h>

#include <vector>

namespace vug::scene {

/// Looks ahead from a cursor outside of brackets and caches the results. The cursor must outlive
/// it.
class RuleLookahead {
 public:
  explicit RuleLookahead(const Cursor& cursor) : cursor_(cursor) {}

  /// True if an arrow follows before the end of the line (closed brackets may span lines) or as the
  /// first token of the next line. `from` counts tokens from the cursor's position.
  bool arrow_ahead(size_t from);

  /// The first token from `ahead` on that is not a line break (";" does not count as one).
  size_t beyond_newlines(size_t ahead) const;

 private:
  void read(size_t at);

  const Cursor& cursor_;
  // Results for the tokens from begin_ to the next "}", so that repeated lookahead, as in a block
  // of faulty lines, takes linear time.
  size_t begin_ = 0, end_ = 0;
  std::vector<size_t> closing_;  ///< For each "(" the index of its ")"; for others their own.
  std::vector<size_t> arrow_;    ///< Index of the next arrow, or end_.
};

}  // namespace vug::scene
