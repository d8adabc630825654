#include <vug/facade/element.h>

namespace vug::facade {
namespace {

struct Door {
  static void describe(Schema<Door>& s) {
    s.doc("A door, its leaf set back from the wall.").cite("ripperda2009");
  }
};

class DoorElement final : public Element {
 public:
  DoorElement(const std::string& kind, const Door&) : Element(kind) {}
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(door) { return element_kind<Door, DoorElement>("door"); }
