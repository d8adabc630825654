# SPDX-License-Identifier: Apache-2.0
"""Look development: denoising, layers, kept pictures and comparisons."""
import unittest

from studio import HERE, StudioTest, require_studio

SCENE = """param RADIUS = 50cm in 10cm..90cm
volume ball = level_set(sphere(RADIUS), voxel: 5cm)
mesh ball on ball { }
object ball on ball { }
light key = sphere(center: (-1, 1, 1), radius: 20cm, radiance: (9, 8, 6), group: "lamps")
camera main { eye (0.4, 0.8, 4) target (0, 0, 0) fov 40deg }
render main { size 64x36 spp 4 layers ["beauty", "light_lamps"] }
"""


class LookDevelopment(StudioTest):
    def prepare(self):
        super().prepare()
        self.scene.write_text(SCENE)

    @property
    def scene(self):
        return self.folder / "scene.vug"

    def test_pictures_are_denoised_kept_and_compared(self):
        self.studio((HERE / "look_dev.txt").read_text(), "--scene")
        names = ("noisy", "smooth", "again", "albedo", "wipe", "moved", "difference", "kept", "restored")
        images = {name: (self.folder / f"{name}.png").read_bytes() for name in names}
        self.assertEqual(images["noisy"], images["again"])
        self.assertEqual(images["noisy"], images["restored"])
        self.assertEqual(len({images[name] for name in names}), 7)


if __name__ == "__main__":
    require_studio()
    unittest.main()
