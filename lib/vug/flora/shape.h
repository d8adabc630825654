// SPDX-License-Identifier: Apache-2.0
// Interface of parametric meshes, such as leaves and sprays.
#pragma once

#include <vug/base/kind.h>
#include <vug/mesh/mesh.h>

namespace vug::flora {

/// Distinguishes parametric meshes from other meshes in the expressions of a scene.
struct Shape {
  mesh::MeshPtr mesh;
};

using ShapeKind = Kind<Shape>;
/// Generated from the list in CMakeLists.txt.
const Kinds<Shape>& shapes();

/// A kind whose parameter struct P has `static void describe(Schema<P>&)`; `make` is
/// mesh::Mesh(const P&).
template <class P, class Make>
ShapeKind shape_kind(std::string name, Make make) {
  return make_kind<Shape, P>(std::move(name), "shape", [make](const P& params) {
    return Shape{std::make_shared<const mesh::Mesh>(make(params))};
  });
}

}  // namespace vug::flora

/// Opens the one definition that the file of a shape exports; see VUG_EXPORT_KIND.
#define VUG_SHAPE_KIND(name) VUG_EXPORT_KIND(vug::flora, ShapeKind, name##_shape)

namespace vug {

template <>
struct ValueTraits<flora::Shape> : ObjectTraits<flora::Shape> {
  static constexpr const char* kWord = "shape";
};

}  // namespace vug
