// SPDX-License-Identifier: Apache-2.0
// Names of elements whose type does not affect the code length.
#pragma once

#include <vug/fit/model/model.h>

namespace vug::fit {

/// Under codes of clusters any element may be a window, a door or a shop. An element whose main
/// cluster is that of the grids' windows becomes a window; of the others, those on the ground
/// become doors, or shops if they are wider than high. Gaps in a row that do not look like wall
/// become elements as well. With supervised evidence elements keep their region type. Among several
/// names for one type, such as `door` and `doorway`, the first in the rules is used. The cost of
/// the tree does not change.
void name_elements(const Model& model, const Evidence& evidence, TreeState& state);

}  // namespace vug::fit
