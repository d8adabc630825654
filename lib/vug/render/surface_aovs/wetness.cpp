// SPDX-License-Identifier: Apache-2.0
// The AOV of the water on surfaces.
#include <vug/render/film/surface_aov.h>
#include <vug/render/material.h>

namespace vug::render {

SurfaceAov wetness_aov() {
  return {"wetness",
          "Fraction of the first surface that is covered by water.",
          {"wetness"},
          [](const Surface& surface, const Material& material) {
            return Rgb(material.wetness(surface), 0, 0);
          }};
}

}  // namespace vug::render
