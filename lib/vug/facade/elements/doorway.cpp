#include <vug/facade/element.h>

namespace vug::facade {
namespace {

struct Doorway {
  static void describe(Schema<Doorway>& s) {
    s.doc("A way in without a leaf.").cite("ripperda2009");
  }
};

class DoorwayElement final : public Element {
 public:
  DoorwayElement(const std::string& kind, const Doorway&) : Element(kind) {}
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(doorway) { return element_kind<Doorway, DoorwayElement>("doorway"); }
