# SPDX-License-Identifier: Apache-2.0
"""Pictures of volumes that a region cuts, and of placed objects whose masks refer to the scene."""
import unittest

import exr
from vug import VugTest

TUNNEL = """volume rock = level_set(-cylinder(radius: 50cm, height: 9m).rotate(axis: (0, 0, 1), angle: 90deg), voxel: 10cm,
  from: (-2, -1, -1), to: (2, 1, 1){caps})
mesh skin on rock {}
object walls on skin {}
camera main { eye (0, 0, 0)  target (1, 0, 0) }
light day = sky(radiance: (1, 1, 1))
render main { size 16x9  spp 8 }
"""

# Two blocks at different heights, each in one half of the picture.
BLOCKS = """volume block = level_set(box(size: (1, 1, 1)), voxel: 20cm)
mesh skin on block {}
object cube on skin { material surface(color: gradient(mask: height(from: -2, to: 2{space}), colors: [(0, 0, 0), (1, 1, 1)])) }
place both { of cube  at [(-1, -1, 0), (1, 1, 0)]  floating true }
camera main { kind orthographic  eye (0, 0, 8)  target (0, 0, 0)  width 4m }
light day = sky(radiance: (1, 1, 1))
render main { size 8x8  spp 8  layers ["beauty", "albedo"] }
"""


class CutAndPlaced(VugTest):
    def channel(self, text, name):
        self.write("s.vug", text)
        self.expect(0, "render", "s.vug", "-o", "s.exr", "--float")
        return exr.read(self.folder / "s.exr")[0].pixels[name]

    def test_caps_keep_the_light_out(self):
        light = {caps: sum(self.channel(TUNNEL.replace("{caps}", caps), "R"))
                 for caps in ("", ", caps: +X", ", caps: [-X, +X]")}
        self.assertGreater(light[", caps: +X"], 0, "it enters behind the camera")
        self.assertGreater(light[""], light[", caps: +X"])
        self.assertEqual(light[", caps: [-X, +X]"], 0)

    def test_masks_may_refer_to_the_scene(self):
        def of_blocks(space):
            albedo = self.channel(BLOCKS.replace("{space}", space), "albedo.R")
            return albedo[8 * 5 + 1], albedo[8 * 1 + 6]  # lower left, upper right: 25 cm above their centres
        low, high = of_blocks("")
        self.assertAlmostEqual(low, high, delta=0.05)
        low, high = of_blocks(", in: scene")
        self.assertLess(low, 0.3)
        self.assertGreater(high, 0.7)


if __name__ == "__main__":
    unittest.main()
