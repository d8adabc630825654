// SPDX-License-Identifier: Apache-2.0
// Rows of unequal elements, found by dynamic programming over the edges of the picture.
#pragma once

#include <vug/fit/move.h>
#include <vug/fit/search/segments.h>

namespace vug::fit {

/// The strongest edges of whole columns or rows of an area, at most `most` positions along x or y
/// in ascending order, without the borders.
std::vector<int> strongest_edges(const Evidence& evidence, const TreeState& state, const Area& area,
                                 bool along_x, int most);

/// Rectangles on the ground of node i's area between its window columns: for each height the one
/// that saves most bits, best first.
std::vector<Rect> ground_elements_between(const MoveContext& context, const Evidence& evidence,
                                          const TreeState& state, int i,
                                          const std::vector<Segment>& columns);

/// Candidates for node i as a row of elements with content, if the rules have such a production.
std::vector<TreeState> element_row_candidates(const MoveContext& context, const Evidence& evidence,
                                              const TreeState& state, int i);

}  // namespace vug::fit
