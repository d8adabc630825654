// SPDX-License-Identifier: Apache-2.0
// Translation of a facade grammar's text into rules for the sampler.
#pragma once

#include <vug/facade/rules.h>
#include <vug/fit/model/rules.h>

namespace vug::fit {

/// Compiles rules whose sizes and counts are free. The supported right sides are those of
/// data/facades/ripperda.vug:
///   rows(A, B)             a ground floor and the rest
///   repeat(x, A)           one part repeated; with `alike: false`, elements of any width
///   mirror(A), mirror(A, B)
///   A                      if A only has rules that make grids
///   grid(window), grid(window, door), with `regular: false`, `identical: false`
///   window, door, shop, doorway
/// Error(bad_input), with its location, for a rule of another form or with sizes.
Rules compile(const facade::Rules& rules);

}  // namespace vug::fit
