// Inside exchange/ only: what glTF has no words for, as data for those who know Vug.
#pragma once

#include <vug/exchange/assembly.h>

#include <tiny_gltf.h>

namespace vug::exchange {

/// A dome: its name, radiance, how it is turned (a quaternion, where it is) and the file of its
/// picture; empty without one.
tinygltf::Value gltf_sky(const Light& dome, const std::string& picture);

/// A volume: its name, file, grids, and what a cloud's mean.
tinygltf::Value gltf_volume(const Volume& volume);

}  // namespace vug::exchange
