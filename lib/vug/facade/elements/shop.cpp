#include <vug/facade/element.h>

namespace vug::facade {
namespace {

struct Shop {
  static void describe(Schema<Shop>& s) {
    s.doc("A shop front: a wide window down to the ground.").cite("ripperda2009");
  }
};

class ShopElement final : public Element {
 public:
  ShopElement(const std::string& kind, const Shop&) : Element(kind) {}
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(shop) { return element_kind<Shop, ShopElement>("shop"); }
