// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: glTF materials.
#pragma once

#include <vug/exchange/assembly.h>

#include <tiny_gltf.h>

#include <map>
#include <string>

namespace vug::exchange {

/// The look of the prototype: metallic-roughness, with extensions for properties that differ from
/// their defaults. Vertex colours multiply the base colour, which is then white.
tinygltf::Material gltf_material(const Prototype& prototype, double emission_scale);

/// An array of three numbers.
tinygltf::Value gltf_value(const Vec3d& v);

}  // namespace vug::exchange
