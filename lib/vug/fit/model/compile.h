// A facade grammar's text as rules for the sampler.
#pragma once

#include <vug/facade/rules.h>
#include <vug/fit/model/rules.h>

namespace vug::fit {

/// The rules whose sizes and counts are free, by these patterns of right sides, which are those of
/// data/facades/ripperda.vug:
///   rows(A, B)             a ground floor and the rest
///   repeat(x, A)           one part several times; with `alike: false`, elements of any width
///   mirror(A), mirror(A, B)
///   A                      where A has but rules to grids
///   grid(window), grid(window, door), with `regular: false`, `identical: false`
///   window, door, shop, doorway
/// Error(bad_input), with its place, for a rule of another pattern or with sizes.
Rules compile(const facade::Rules& rules);

}  // namespace vug::fit
