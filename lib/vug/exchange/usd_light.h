// SPDX-License-Identifier: Apache-2.0
// Internal to exchange/: USD cameras and lights.
#pragma once

#include <vug/exchange/assembly.h>
#include <vug/exchange/usd_layer.h>

#include <string>

namespace vug::exchange {

void write_usd_camera(UsdLayer& out, const Camera& camera, const std::string& name,
                      double metres_per_unit);

/// `picture`: the asset path of a dome's environment map.
void write_usd_light(UsdLayer& out, const Light& light, const std::string& name,
                     const std::string& picture);

}  // namespace vug::exchange
