// Inside exchange/ only: cameras and lights as USD has them.
#pragma once

#include <vug/exchange/assembly.h>
#include <vug/exchange/usd_text.h>

#include <string>

namespace vug::exchange {

void write_usd_camera(UsdText& out, const Camera& camera, const std::string& name,
                      double metres_per_unit);

/// `picture`: the file of a dome's picture, as the layer names it.
void write_usd_light(UsdText& out, const Light& light, const std::string& name,
                     const std::string& picture);

}  // namespace vug::exchange
