// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/rule.h>

#include <algorithm>

namespace vug::cells {
namespace {

/// Seeds count from 1; 0 means no seed. If several arrive in one step the smallest wins, so each
/// cell belongs to the smallest of the seeds with the fewest links in between.
struct Voronoi {
  static void describe(Schema<Voronoi>& s) {
    s.doc(
         "Cells without colour (Cd) take the colour and seed of a neighbour that has one: patches "
         "grow around seeds until they meet.")
        .cite("gobron2006");
  }

  void step(Pass& pass) const {
    const auto color = pass.writes<Vec3f>("Cd");
    const auto seed = pass.writes<int32_t>("seed");
    pass.run([=](const auto& neighbours, uint32_t i) {
      int32_t first = seed[i];
      Vec3f taken = color[i];
      if (first == 0)
        neighbours.each(i, [&](uint32_t n) {
          if (seed[n] != 0 && (first == 0 || seed[n] < first)) first = seed[n], taken = color[n];
        });
      color.set(i, taken);
      seed.set(i, first);
    });
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(voronoi) { return rule_kind<Voronoi>("voronoi"); }
