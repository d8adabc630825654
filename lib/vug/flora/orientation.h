// SPDX-License-Identifier: Apache-2.0
// Exact orientation predicate for three points.
#pragma once

#include <vug/base/vec.h>

namespace vug::flora {

/// 1 if the path from a over b to c turns left (from x towards y), -1 if it turns right, 0 if the
/// points are collinear.
int orientation(const Vec2d& a, const Vec2d& b, const Vec2d& c);

}  // namespace vug::flora
