#include <vug/facade/element.h>

namespace vug::facade {
namespace {

struct Window {
  static void describe(Schema<Window>& s) { s.doc("A window.").cite("ripperda2009"); }
};

class WindowElement final : public Element {
 public:
  WindowElement(const std::string& kind, const Window&) : Element(kind) {}
};

}  // namespace
}  // namespace vug::facade

VUG_ELEMENT_KIND(window) { return element_kind<Window, WindowElement>("window"); }
