// Inside exchange/ only: looks as glTF has them.
#pragma once

#include <vug/exchange/assembly.h>

#include <tiny_gltf.h>

#include <map>
#include <string>

namespace vug::exchange {

/// The look of the part: metallic-roughness with extensions for what differs from its defaults.
/// Vertex colours multiply the colour, which is then white.
tinygltf::Material gltf_material(const Prototype& prototype, double emission_scale);

/// Three numbers.
tinygltf::Value gltf_value(const Vec3d& v);

}  // namespace vug::exchange
