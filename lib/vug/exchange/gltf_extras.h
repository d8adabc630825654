// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: data that glTF cannot express, stored as extras for programs that know
// Vug.
#pragma once

#include <vug/exchange/assembly.h>

#include <tiny_gltf.h>

namespace vug::exchange {

/// A dome: its name, radiance, rotation (a quaternion, if any) and the file of its environment map;
/// empty without one.
tinygltf::Value gltf_sky(const Light& dome, const std::string& picture);

/// A volume: its name, file, grids and medium.
tinygltf::Value gltf_volume(const Volume& volume);

}  // namespace vug::exchange
