// SPDX-License-Identifier: Apache-2.0
#include <vug/flora/orientation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>

namespace vug::flora {

int orientation(const Vec2d& a, const Vec2d& b, const Vec2d& c) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  return CGAL::orientation(Kernel::Point_2(a.x, a.y), Kernel::Point_2(b.x, b.y),
                           Kernel::Point_2(c.x, c.y));
}

}  // namespace vug::flora
