# SPDX-License-Identifier: Apache-2.0
"""Micro-displacement: the same bytes in one run, in tiles and for any number of threads; its limits and its export."""
import unittest

from vug import VugTest, digest

SCENE = """
volume rock = level_set(displace(sphere(1m), noise: fbm(scale: 30cm, octaves: 5), amount: 4cm), voxel: 15cm)
mesh skin on rock {}
object stone on skin { detail dice(DETAIL) }
camera main { eye (0, 0.5, 3)  target (0, 0, 0)  fov 50deg }
light lamp = sphere(center: (2, 4, 3), radius: 40cm, radiance: (30, 28, 25))
render main { size 64x40  spp 16 }
"""


class Detail(VugTest):
    def prepare(self):
        self.write("s.vug", SCENE.replace("DETAIL", "pixels: 1"))
        self.write("fixed.vug", SCENE.replace("DETAIL", "edge: 2cm"))
        self.expect(0, "render", "s.vug", "-o", "whole.exr", "--threads", 2)

    def expect_whole(self, name):
        self.assertEqual(digest(self.folder / name), digest(self.folder / "whole.exr"), name)

    def test_any_number_of_threads(self):
        for threads in (1, 7):
            self.expect(0, "render", "s.vug", "-o", f"t{threads}.exr", "--threads", threads)
            self.expect_whole(f"t{threads}.exr")

    def test_tiles(self):
        for i in (1, 2, 3):
            self.expect(0, "render", "s.vug", "--part", f"p{i}", "--tile", f"{i}/3", "--threads", i)
        self.expect(0, "merge", "p3", "p1", "p2", "-o", "tiles.exr")
        self.expect_whole("tiles.exr")

    def test_the_log_reports_the_triangles(self):
        error = self.expect(0, "render", "s.vug", "-o", "log.exr", "--size", "480x300", "--spp", 1).err
        self.assertRegex(error, r"dicing into \d+\.\d\d million triangles, [\d.]+ MiB")

    def test_too_little_memory(self):
        self.write("large.vug", SCENE.replace("DETAIL", "pixels: 0.1"))
        error = self.expect(2, "render", "large.vug", "-o", "large.exr", "--size", "640x400", "--max-memory", "1G").err
        self.assertIn("large.vug:4:8: error: detail of", error)
        self.assertRegex(error, r"it fits with: detail dice\(pixels: [\d.]+\), or raise --max-memory")
        self.assertNotIn("large.exr", self.files())

    def test_exports_with_a_fixed_edge(self):
        sizes = {}
        for name in ("s", "fixed"):
            self.expect(0, "export", f"{name}.vug", "-o", f"out_{name}", "--for", "gltf")
            sizes[name] = sum(path.stat().st_size for path in (self.folder / f"out_{name}").rglob("*") if path.is_file())
        self.assertGreater(sizes["fixed"], 10 * sizes["s"])


if __name__ == "__main__":
    unittest.main()
