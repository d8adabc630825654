// SPDX-License-Identifier: Apache-2.0
// Conversion between scene values and plans of volumes and meshes.
#pragma once

#include <vug/base/kind.h>
#include <vug/render/kinds.h>
#include <vug/shot/shot.h>

namespace vug {

template <>
struct ValueTraits<shot::VolumePtr> : ObjectTraits<shot::VolumePtr> {
  static constexpr const char* kWord = "volume";
};
template <>
struct ValueTraits<shot::MeshPtr> : ObjectTraits<shot::MeshPtr> {
  static constexpr const char* kWord = "mesh";
};

/// A mesh, or a level set, which is converted to its plain mesh.
namespace shot {
struct MeshOrLevelSet {
  MeshPtr mesh;
};
}  // namespace shot
template <>
struct ValueTraits<shot::MeshOrLevelSet> {
  static std::string type() { return "mesh or level set"; }
  static std::optional<shot::MeshOrLevelSet> read(const Value& value);
  static Value write(const shot::MeshOrLevelSet& any) {
    return ValueTraits<shot::MeshPtr>::write(any.mesh);
  }
};

}  // namespace vug
