// SPDX-License-Identifier: Apache-2.0
// The micro-displacement of an object: how finely its mesh is diced, and onto which field.
#pragma once

#include <vug/field/kind.h>
#include <vug/render/kinds.h>

#include <optional>

namespace vug::shot {

/// `detail dice(...)` of an object; see building/dice_objects.h.
struct Dicing {
  double pixels = 1;           ///< Longest edge in pixels, where `edge` is not set.
  std::optional<double> edge;  ///< Longest edge in metres, for any camera.
  double least = 0.2e-3;       ///< Edges are not made shorter than this, metres.
  int levels = 8;              ///< Number of times that an edge may be halved.
  double off_screen = 4;       ///< Factor on `pixels` outside the picture; see render::PixelSize.
  std::optional<field::Field> field;   ///< None: the field of the mesh's volume.
  render::CameraPtr camera = nullptr;  ///< Null: the camera of the picture.
};

/// The kinds listed in CMakeLists.txt.
const Kinds<Dicing>& dicing_kinds();
using DicingKind = Kind<Dicing>;
/// Begins the definition of the function that the source of such a kind exports.
#define VUG_DICING_KIND(name) VUG_EXPORT_KIND(vug::shot, DicingKind, name##_dicing)

}  // namespace vug::shot

namespace vug {

template <>
struct ValueTraits<shot::Dicing> : ObjectTraits<shot::Dicing> {
  static constexpr const char* kWord = "dicing";
};

}  // namespace vug
