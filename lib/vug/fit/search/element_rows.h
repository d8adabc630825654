// Rows of unequal elements, found by dynamic programming over the places where a picture changes.
#pragma once

#include <vug/fit/move.h>
#include <vug/fit/search/segments.h>

namespace vug::fit {

/// Places along x or y of an area where whole columns or rows of it change most, at most that many,
/// in order; neither of its borders.
std::vector<int> strongest_edges(const Evidence& evidence, const TreeState& state, const Area& area,
                                 bool along_x, int most);

/// What stands on the ground of node i's area between the columns of its windows, each of them
/// `columns`: of each height the one that saves most bits, the best first.
std::vector<Rect> ground_elements_between(const MoveContext& context, const Evidence& evidence,
                                          const TreeState& state, int i,
                                          const std::vector<Segment>& columns);

/// Node i rewritten into elements with what stands in them, if the rules have any.
std::vector<TreeState> element_row_candidates(const MoveContext& context, const Evidence& evidence,
                                              const TreeState& state, int i);

}  // namespace vug::fit
