// How the plans of volumes and meshes travel through scene expressions as Values.
#pragma once

#include <vug/base/kind.h>
#include <vug/render/kinds.h>
#include <vug/session/shot.h>

namespace vug {

template <>
struct ValueTraits<session::VolumePtr> : ObjectTraits<session::VolumePtr> {
  static constexpr const char* kWord = "volume";
};
template <>
struct ValueTraits<session::MeshPtr> : ObjectTraits<session::MeshPtr> {
  static constexpr const char* kWord = "mesh";
};

/// A mesh, or a level set that stands for a plain mesh of it.
namespace session {
struct AnyMesh {
  MeshPtr mesh;
};
}  // namespace session
template <>
struct ValueTraits<session::AnyMesh> {
  static std::string type() { return "mesh or level set"; }
  static std::optional<session::AnyMesh> read(const Value& value);
  static Value write(const session::AnyMesh& any) {
    return ValueTraits<session::MeshPtr>::write(any.mesh);
  }
};

}  // namespace vug
