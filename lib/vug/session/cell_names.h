// Which attributes the cells of a plan have, told before any work.
#pragma once

#include <vug/session/cells_plan.h>

namespace vug::session {

/// Fills plan.surroundings, and tells of attributes that rules or masks of the plan name and nobody
/// brings, where the text does so, and of rules that disagree about the type of one.
void read_names(CellsPlan& plan, Diagnostics& diagnostics);

}  // namespace vug::session
