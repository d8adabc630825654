// SPDX-License-Identifier: Apache-2.0
// Layers of a picture as colours: AOVs and light groups.
#pragma once

#include <vug/image/image.h>

#include <optional>
#include <string>
#include <vector>

namespace vug::viewport {

struct ShownLayer {
  image::Image image;     ///< R, G and B.
  bool is_light = false;  ///< It is displayed as the beauty is, with exposure and view transform.
};

/// Light as it is; unit normals as colours; the albedo as it is; other numbers from black at the
/// smallest one to white at the largest. Nothing for an unknown layer.
std::optional<ShownLayer> shown_layer(const image::Image& picture, const std::string& name);

/// The layers of a picture that can be shown: all but those of Cryptomatte. The first is "beauty".
std::vector<std::string> layers_to_show(const image::Image& picture);

}  // namespace vug::viewport
