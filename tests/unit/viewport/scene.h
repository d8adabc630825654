// SPDX-License-Identifier: Apache-2.0
// A small scene for tests of the viewport, and what is seen in it.
#pragma once

#include <vug/viewport/preview_scene.h>

#include <gtest/gtest.h>

namespace vug::viewport {

/// A ball in the middle, a block at its right, three pebbles below, and no light on them.
inline std::string scene_text(const std::string& radius = "50cm") {
  return "param RADIUS = " + radius +
         "  in 10cm..90cm  \"radius of the ball\"\n"
         "volume ball = level_set(sphere(RADIUS), voxel: 5cm)\n"
         "mesh ball on ball { }\n"
         "material stone = lambert(albedo: (0.05, 0.05, 0.05))\n"
         "object ball on ball { material stone }\n"
         "volume block = level_set(box(size: (0.6, 0.6, 0.6)).translate((1.2, 0, 0)), voxel: 5cm)\n"
         "mesh block on block { }\n"
         "object block on block { material stone }\n"
         "volume pebble = level_set(sphere(10cm), voxel: 5cm)\n"
         "mesh pebble on pebble { }\n"
         "object pebble on pebble { material stone }\n"
         "place pebbles { of pebble at [for i in 0..3 : (i * 0.5 - 0.5, -0.8, 0.5)] }\n"
         "light lamp = sphere(center: (0, 50, -50), radius: 1cm)\n"
         "camera main { eye (0, 0, 4) target (0, 0, 0) fov 60deg }\n"
         "render main { size 64x36 spp 4 exposure 0 }\n";
}

inline PreviewScenePtr build(const std::string& text) {
  LiveText live("scene.vug", {});
  EXPECT_TRUE(live.load(text, std::make_shared<Progress>())) << live.report();
  return std::make_shared<const PreviewScene>(build_preview(live, {}));
}

}  // namespace vug::viewport
