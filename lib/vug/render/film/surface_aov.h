// SPDX-License-Identifier: Apache-2.0
// AOVs whose values are read at the first surface. Each is one file in surface_aovs/ and one line
// in this module's CMakeLists.txt.
#pragma once

#include <vug/render/vectors.h>

#include <string>
#include <vector>

namespace vug::render {

class Material;
struct Surface;

/// The picture contains the mean of `read` over the samples of a pixel that hit a surface.
struct SurfaceAov {
  std::string name;
  std::string doc;
  std::vector<std::string> channels;  ///< At most three names.
  /// The values of the channels at a hit, limited to +-kMaxLight. Called by all threads.
  Rgb (*read)(const Surface& surface, const Material& material) = nullptr;
};

/// The surface AOVs in the order of the list.
const std::vector<SurfaceAov>& surface_aovs();

}  // namespace vug::render
