// Which way three points turn, told exactly.
#pragma once

#include <vug/base/vec.h>

namespace vug::flora {

/// 1 where the way from a over b to c turns to the left (from x towards y), -1 to the right, 0
/// where they lie in one line.
int orientation(const Vec2d& a, const Vec2d& b, const Vec2d& c);

}  // namespace vug::flora
