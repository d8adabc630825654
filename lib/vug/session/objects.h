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

}  // namespace vug
