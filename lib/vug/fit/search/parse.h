// Trees found from the top down: each area is tried as every production's parts, and the parts in
// turn, as far as the picture promises anything.
#pragma once

#include <vug/fit/evidence/folded_integral.h>
#include <vug/fit/move.h>

namespace vug::fit {

struct ParseOptions {
  int depth = 3;               ///< How many splits lie within each other.
  int breadth = 3;             ///< How many ways to split an area are looked into.
  double min_potential = 0.8;  ///< Share of an area's gain that must remain when its parts are laid
                               ///< on top of one another.
};

/// The tree of least energy that is found below node i, which has not been rewritten. `gains` say
/// where windows may be.
TreeState parse(const MoveContext& context, const Evidence& evidence, const Gains& gains,
                TreeState state, int i, const ParseOptions& options = {});

}  // namespace vug::fit
