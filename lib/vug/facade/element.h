// SPDX-License-Identifier: Apache-2.0
// Interface of the elements of facades: windows, doors and other solids in a rectangle that is not
// split further. Each keeps the text of its call.
#pragma once

#include <vug/base/kind.h>
#include <vug/field/field.h>

#include <memory>
#include <string>
#include <vector>

namespace vug::facade {

/// The solids of an element in its own frame, in metres: x to the right from 0 to its width, y up
/// from 0 to its height, z out of the wall, whose face is at z = 0.
struct Solids {
  std::vector<field::Field> cut;   ///< Subtracted from the wall before anything is added.
  std::vector<field::Field> add;   ///< Added to the wall, of the wall's material.
  std::vector<field::Field> fill;  ///< Parts of other materials: panes of glass, leaves of doors.

  void take(Solids more);
};

/// An element of a kind (window, door, ...) with its parameters. Shared and immutable.
class Element {
 public:
  Element(std::string kind, std::string text) : kind_(std::move(kind)), text_(std::move(text)) {}
  virtual ~Element() = default;
  /// The kind's name: "window".
  const std::string& kind() const { return kind_; }
  /// The element as scene text with its given arguments: "window(reveal: 20cm)".
  const std::string& text() const { return text_; }
  /// The solids for a rectangle of that size in metres. Throws Error(bad_input) if the parameters
  /// do not fit into the rectangle.
  virtual Solids solids(double width, double height) const = 0;

 private:
  std::string kind_, text_;
};
using ElementPtr = std::shared_ptr<const Element>;

using ElementKind = Kind<ElementPtr>;
/// All kinds of elements, from the list in CMakeLists.txt.
const Kinds<ElementPtr>& elements();

/// The scene text of an element of that kind with arguments that its schema has accepted.
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

/// Opens the only definition that the file of an element exports; see VUG_EXPORT_KIND.
#define VUG_ELEMENT_KIND(name) VUG_EXPORT_KIND(vug::facade, ElementKind, name##_element)

namespace vug {

template <>
struct ValueTraits<facade::ElementPtr> : ObjectTraits<facade::ElementPtr> {
  static constexpr const char* kWord = "element";
};

}  // namespace vug
