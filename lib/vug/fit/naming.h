// What elements are called that any name would fit.
#pragma once

#include <vug/fit/model/model.h>

namespace vug::fit {

/// Codes of clusters do not care whether an element is a window, a door or a shop. One that is
/// mostly of the cluster of the windows in grids is a window; of the others those that stand on the
/// ground are doors, or, if they are wider than high, shops. What is left out of a row and does not
/// look like the wall is something too. Where the evidence is of looks, an element keeps its look.
/// Of names for one look, as `door` and `doorway`, the first in the rules is taken. The tree costs
/// as much as before.
void name_elements(const Model& model, const Evidence& evidence, TreeState& state);

}  // namespace vug::fit
