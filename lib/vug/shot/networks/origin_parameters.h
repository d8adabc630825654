// SPDX-License-Identifier: Apache-2.0
// The parameters of networks from files that place them in the scene.
#pragma once

#include <vug/base/schema.h>
#include <vug/network/scene_origin.h>

namespace vug::shot {

template <class P>
requires std::derived_from<P, network::OriginOptions>
void describe_origin(Schema<P>& s) {
  s.param("recenter", &network::OriginOptions::recenter,
          {.doc = "put the middle of the stations, rounded to metres, into the origin; false: keep "
                  "the coordinates, which must be within 20 km of the origin"})
      .param("origin", &network::OriginOptions::origin,
             {.doc = "the point (east, north, height) of the file that becomes the origin of the "
                     "scene, instead of the middle; networks with the same one share it",
              .dimension = Dimension::length});
}

}  // namespace vug::shot
