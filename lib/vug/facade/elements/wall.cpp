#include <vug/facade/element.h>

namespace vug::facade {
namespace {

struct Wall {
  static void describe(Schema<Wall>& s) { s.doc("Plain wall.").cite("ripperda2009"); }
};

class WallElement final : public Element {
 public:
  WallElement(const std::string& kind, const Wall&) : Element(kind) {}
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(wall) { return element_kind<Wall, WallElement>("wall"); }
