// Elements: what stands in a rectangle that is not split any further.
#pragma once

#include <vug/base/kind.h>
#include <vug/field/field.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::facade {

/// What an element is made of, in its own frame: x to the right from 0 to its width, y up from 0 to
/// its height, z out of the wall, whose face is at z = 0. Metres.
struct Solids {
  std::vector<field::Field> cut;   ///< Taken out of the wall, before anything is added.
  std::vector<field::Field> add;   ///< Of the wall's own matter.
  std::vector<field::Field> fill;  ///< Of other matter: panes of glass, leaves of doors.

  void take(Solids more);
};

/// A window, a door, ... of a kind, with its measures. Shared and immutable.
class Element {
 public:
  Element(std::string kind, std::string text) : kind_(std::move(kind)), text_(std::move(text)) {}
  virtual ~Element() = default;
  /// The kind's name: "window".
  const std::string& kind() const { return kind_; }
  /// As scenes write it, with the measures that were told: "window(reveal: 20cm)".
  const std::string& text() const { return text_; }
  /// In a rectangle of that size in metres. Error(bad_input) where the measures leave nothing.
  virtual Solids solids(double width, double height) const = 0;

 private:
  std::string kind_, text_;
};
using ElementPtr = std::shared_ptr<const Element>;

using ElementKind = Kind<ElementPtr>;
/// ParametricElement from the list in CMakeLists.txt.
const Kinds<ElementPtr>& elements();

/// An element of that kind with arguments that its schema has accepted, as scenes write it.
std::string element_text(const KindInfo& kind, const Arguments& arguments);

/// A kind whose parameter struct P has `static void describe(Schema<P>&)` and
/// `Solids solids(double width, double height) const`.
template <class P>
ElementKind element_kind(const std::string& name) {
  struct ParametricElement final : Element {
    ParametricElement(const KindInfo& kind, const Arguments& arguments, const P& p)
        : Element(kind.name, element_text(kind, arguments)), params(p) {}
    Solids solids(double width, double height) const override {
      return params.solids(width, height);
    }
    P params;
  };
  Schema<P> schema(name, "element");
  P::describe(schema);
  return {schema.info(),
          [schema](const Arguments& arguments, const SourceLocation& where,
                   Diagnostics& diagnostics) -> std::optional<ElementPtr> {
            const std::optional<P> params = schema.bind(arguments, where, diagnostics);
            if (!params) return std::nullopt;
            return std::make_shared<const ParametricElement>(schema.info(), arguments, *params);
          }};
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
