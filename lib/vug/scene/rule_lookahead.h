// Where the rules of an L-system's block begin, known before they are read.
#pragma once

#include <vug/scene/cursor.h>

#include <vector>

namespace vug::scene {

/// Looks ahead in a cursor that is outside of brackets, and remembers what it has looked at. The
/// cursor must outlive it.
class RuleLookahead {
 public:
  explicit RuleLookahead(const Cursor& cursor) : cursor_(cursor) {}

  /// True when an arrow comes before the line ends, which brackets that are closed somewhere may
  /// put off, or first on the next line. `from` counts tokens from the cursor's.
  bool arrow_ahead(size_t from);

  /// The first token from `ahead` on that is no line break (";" is none).
  size_t beyond_newlines(size_t ahead) const;

 private:
  void read(size_t at);

  const Cursor& cursor_;
  // Of the tokens from begin_ to the next "}", so that looking again and again, as a block of
  // faulty lines makes us do, costs no more than looking once.
  size_t begin_ = 0, end_ = 0;
  std::vector<size_t> closing_;  ///< Of each "(" the place of its ")"; of others their own.
  std::vector<size_t> arrow_;    ///< The place of the next arrow, or end_.
};

}  // namespace vug::scene
