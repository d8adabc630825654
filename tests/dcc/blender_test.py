# SPDX-License-Identifier: Apache-2.0
"""The real Blender imports the files that vug export writes for it, and finds the scene in them."""
import json
import math
import os
import subprocess
import unittest

from external_tools import HERE, SCENE, VugTest, require_blender

VOXEL = 0.05


def to_srgb(linear):
    return 12.92 * linear if linear < 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055


class Blender(VugTest):
    def prepare(self):
        self.write("all.vug", SCENE)
        # Without polishing, our mesh equals that of Blender's own mesher for the same voxels.
        round_ = SCENE.replace("box(size: (1, 1, 1))", "sphere(70cm)")
        self.write("raw.vug", round_.replace("mesh wall on rock {", "mesh wall on rock { polish false"))
        self.write("round.vug", round_)
        for name in ("all", "raw", "round"):
            self.expect(0, "export", f"{name}.vug", "-o", "set", "--for", "blender", "-q")

    def blender(self, name):
        program = require_blender()
        # Blender's Python searches for packages next to the first python3 in the path.
        path = f"{os.path.dirname(program)}:{os.environ['PATH']}"
        done = subprocess.run(
            [program, "--background", "--factory-startup", "--python-exit-code", "1", "--python",
             HERE / "in_blender.py", "--", self.folder / "set", name, "rock"],
            capture_output=True, text=True, timeout=600, env={**os.environ, "PATH": path})
        lines = [line for line in done.stdout.splitlines() if line.startswith("FOUND ")]
        self.assertEqual((done.returncode, len(lines)), (0, 1), done.stdout + done.stderr)
        return json.loads(lines[0][len("FOUND "):])

    def test_everything_is_there(self):
        found = self.blender("all")
        types = [each["type"] for each in found["objects"].values()]
        self.assertEqual({kind: types.count(kind) for kind in ("MESH", "CAMERA", "LIGHT")},
                         {"MESH": 4, "CAMERA": 2, "LIGHT": 5})
        self.assertEqual(found["grids"], ["surface"])
        place = found["objects"]["heap.2"]["place"]
        self.assertEqual([round(row[3], 5) for row in place[:3]], [4, 0, 1])  # z up: (x, -z, y)
        # The camera looks along y; z is up in its picture.
        camera = found["objects"]["main"]["place"]
        for row, wanted in zip(camera, ([1, 0, 0, 0], [0, 0, -1, -6], [0, 1, 0, 2])):
            for got, expected in zip(row, wanted):
                self.assertAlmostEqual(got, expected, places=5)
        # 320x160 pixels, 60 degrees wide.
        self.assertAlmostEqual(math.tan(found["cameras"]["main"]["angle_y"] / 2),
                               math.tan(math.radians(30)) / 2, places=5)
        self.assertAlmostEqual(found["cameras"]["plan"]["ortho_scale"], 8, places=4)

    def test_lights_have_their_watts(self):
        lights = self.blender("all")["lights"]
        self.assertAlmostEqual(lights["ball"]["energy"], 100, delta=0.01)
        sun = [lights["sun"]["energy"] * each for each in lights["sun"]["color"]]
        for got, wanted in zip(sun, (3, 2, 1)):
            self.assertAlmostEqual(got, wanted, delta=1e-4)

    def test_a_cube_of_a_metre(self):
        wall = self.blender("all")["wall"]
        for low, high, expected in zip(wall["low"], wall["high"], ((0.5, 1.5), (-2.5, -1.5), (0, 1))):
            self.assertAlmostEqual(low, expected[0], delta=1e-3)
            self.assertAlmostEqual(high, expected[1], delta=1e-3)
        self.assertAlmostEqual(wall["volume"], 1, delta=5e-3)

    def test_the_level_set_is_the_mesh(self):
        found = self.blender("raw")
        for key in ("low", "high"):
            for axis in range(3):
                # Blender 3.4 shifts the mesh of a volume by half a voxel.
                shifted = found["surface"][key][axis] - VOXEL / 2
                self.assertLess(abs(shifted - found["wall"][key][axis]), 0.01 * VOXEL, (key, axis))
        self.assertLess(abs(found["surface"]["volume"] / found["wall"]["volume"] - 1), 0.005)
        self.assertGreater(min(found["agree"]), 0.9)
        # The polished mesh is closer to the ball and has its volume.
        polished = self.blender("round")
        self.assertLess(abs(found["surface"]["volume"] / polished["wall"]["volume"] - 1), 0.005)
        self.assertLess(abs(polished["wall"]["volume"] / (4 / 3 * math.pi * 0.7**3) - 1), 0.005)

    def test_colours_equal_ours(self):
        for x, y, z, *rgb in self.blender("all")["wall"]["colors"]:
            t = min(max((z - 0.1) / 0.8, 0), 1)
            t = t * t * (3 - 2 * t)
            for got, low, high, factor in zip(rgb, (0.8, 0.4, 0.02), (0.1, 0.2, 0.9), (0.5, 1, 1)):
                wanted = factor * (low + t * (high - low))
                # Blender stores them as 8-bit sRGB.
                self.assertAlmostEqual(to_srgb(got), to_srgb(wanted), delta=1 / 255, msg=(x, y, z))


if __name__ == "__main__":
    require_blender()
    unittest.main()
