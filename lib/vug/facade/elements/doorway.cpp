// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/blocks.h>

namespace vug::facade {
namespace {

struct Doorway : Opening {
  double depth = 1.5;

  static void describe(Schema<Doorway>& s) {
    s.doc("An entrance without a leaf: a dark passage of any depth.")
        .cite("ripperda2009")
        .param("depth", &Doorway::depth, positive_length("depth of the passage"));
    describe_opening(s);
  }
  std::string fault() const { return opening_fault(); }

  Solids solids(double width, double height) const { return around(width, height, depth); }
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(doorway) { return element_kind<Doorway>("doorway"); }
