// SPDX-License-Identifier: Apache-2.0
// Corrects the locations in plans after the text around them has moved.
#pragma once

#include <vug/shot/shot.h>

#include <set>

namespace vug::shot {

/// Moves the locations of the shot's plans that lie in the lines of `extent` down by a number of
/// lines. Those of shared plans are mutable: they take no part in the identity of a product, and
/// nothing is built from the plans meanwhile. `moved` collects the locations that are correct now:
/// a plan that several declarations share is moved once, with the declaration that made it.
void move_lines(Shot& shot, const SourceLocation& extent, int by,
                std::set<const SourceLocation*>& moved);

}  // namespace vug::shot
