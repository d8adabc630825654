// Elements: what stands in a rectangle that is not split any further.
#pragma once

#include <vug/base/kind.h>

#include <memory>
#include <string>

namespace vug::facade {

/// A window, a door, ... of a kind, with its measures. Shared and immutable.
class Element {
 public:
  explicit Element(std::string kind) : kind_(std::move(kind)) {}
  virtual ~Element() = default;
  /// The kind's name: "window".
  const std::string& kind() const { return kind_; }

 private:
  std::string kind_;
};
using ElementPtr = std::shared_ptr<const Element>;

using ElementKind = Kind<ElementPtr>;
/// Made from the list in CMakeLists.txt.
const Kinds<ElementPtr>& elements();

/// A kind for an element class that is constructed from its kind's name and its parameter struct P,
/// which has `static void describe(Schema<P>&)`.
template <class P, class Made>
ElementKind element_kind(const std::string& name) {
  return make_kind<ElementPtr, P>(name, "element", [name](const P& params) -> ElementPtr {
    return std::make_shared<const Made>(name, params);
  });
}

}  // namespace vug::facade

/// Opens the one definition that the file of an element exports; see VUG_EXPORT_KIND.
#define VUG_ELEMENT_KIND(name) VUG_EXPORT_KIND(vug::facade, ElementKind, name##_element)

namespace vug {

template <>
struct ValueTraits<facade::ElementPtr> : ObjectTraits<facade::ElementPtr> {
  static constexpr const char* kWord = "element";
};

}  // namespace vug
