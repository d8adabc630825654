# SPDX-License-Identifier: Apache-2.0
"""`vug facade fit`: recovers a known facade from a picture that is rendered with depth."""
import json
import random
import unittest

from pictures import write_png
from vug import VugTest

FRONT = """
grammar front: facade {
  width 6m
  height 5m
  axiom Front
  Front -> grid(window(reveal: 20cm, sash: 0), columns: 3, rows: 2, gap: [1m, 80cm], margin: [60cm, 60cm, 70cm, 50cm])
}
volume stone = level_set(front, voxel: 5cm)
mesh stone_mesh on stone {}
object wall on stone_mesh { material lambert(albedo: (0.6, 0.6, 0.6)) }
camera main { kind orthographic  eye (0, 2.5, 20)  target (0, 2.5, 0)  width 6m }
light even = sky(radiance: (1, 1, 1))
render main { size 150x125  spp 4  layers ["beauty", "Z"] }
"""


def area(rects):
    return sum(width * height for _, _, width, height in rects)


def shared(some, others):
    """Area of the intersection; the rectangles of each set do not overlap."""
    total = 0
    for x, y, width, height in some:
        for u, v, across, up in others:
            total += max(0, min(x + width, u + across) - max(x, u)) * max(0, min(y + height, v + up) - max(y, v))
    return total


class FacadeFit(VugTest):
    def photo(self):
        self.write("front.vug", FRONT)
        self.expect(0, "render", "front.vug", "-o", "photo.exr")

    def test_recovers_the_rendered_facade(self):
        self.photo()
        said = self.expect(0, "facade", "fit", "photo.exr", "-o", "out", "--width", "6m", "--steps", 20000)
        tree = json.loads((self.folder / "out/photo.json").read_text())
        self.assertTrue(tree["theta"].startswith("Facade(0, 0, 6, 5, "), tree["theta"])
        windows = [one["rect"] for one in tree["elements"] if one["kind"] == "window"]
        true = [(0.6 + column * 1.9333, 0.7 + row * 2.3, 0.9333, 1.5) for column in range(3) for row in range(2)]
        self.assertGreater(shared(windows, true), 0.9 * area(true), said.out)
        self.assertLess(area(windows), 1.1 * area(true), said.out)
        self.assertIn("window(reveal: 0.32m)", (self.folder / "out/photo.vug").read_text())
        self.assertIn('href="../photo.exr"', (self.folder / "out/photo.svg").read_text())
        recipe = self.expect(0, "recipe", "out/photo.vdb").out
        self.assertIn("window(reveal: 0.32m)", recipe)
        self.assertNotIn("include", recipe, "it stands alone")
        report = json.loads((self.folder / "out/photo.report.json").read_text())
        self.assertTrue(0 < report["score"]["s"] < 1, report)
        self.assertIn("<svg", (self.folder / "out/photo.report.svg").read_text())
        again = self.expect(0, "tree", "out/photo.vug", "--elements").out
        self.assertEqual(again.count("window,"), len(windows))

    def test_the_output_is_for_people(self):
        self.photo()
        said = self.expect(0, "facade", "fit", "photo.exr", "-o", "out", "--width", "6m", "--iterations", 20000,
                           "--no-carving")
        lines = dict(line.split(maxsplit=1) for line in said.out.splitlines())
        self.assertEqual(lines["facade"], "6 x 5 m")
        self.assertEqual(lines["elements"], "6 windows")
        self.assertEqual(lines["scene"], "out/photo_scene.vug")
        self.assertNotIn("carving", lines)
        self.assertLess(max(map(len, said.out.splitlines())), 120)
        self.assertIn("(assumed size)", self.expect(0, "facade", "fit", "photo.exr", "-o", "out", "--steps", 2000,
                                                    "--no-carving").out)

    def test_the_scene_can_be_denoised(self):
        self.photo()
        self.expect(0, "facade", "fit", "photo.exr", "-o", "out", "--width", "6m", "--steps", 2000, "--no-carving")
        self.expect(0, "render", "out/photo_scene.vug", "-o", "a.exr", "-D", "voxel=20cm", "--size", "60x50", "--spp", 4,
                    "--denoise")
        self.assertIn("denoised", self.expect(0, "info", "a.exr").out)

    def test_a_crop(self):
        self.photo()
        fit = ("facade", "fit", "photo.exr", "-o", "out", "--no-carving", "--steps", 20000)
        said = self.expect(0, *fit, "--crop", "0,0,50,125", "--width", "2m").out
        self.assertIn("elements  2 windows\n", said)
        tree = json.loads((self.folder / "out/photo.json").read_text())
        self.assertEqual((tree["width"], tree["height"]), (2, 5))
        self.assertIn('width="3000" height="2500"', (self.folder / "out/photo.svg").read_text())
        self.assertIn("photo.exr' has 150 x 125 pixels, and the crop ends at 151,125",
                      self.expect(2, *fit, "--crop", "0,0,151,125").err)
        self.assertIn("it contains no pixels", self.expect(2, *fit, "--crop", "9,0,9,125").err)
        self.assertIn("the crop has 9 x 125 pixels", self.expect(2, *fit, "--crop", "0,0,9,125").err)
        self.write("scan.txt", "\n".join(f"{0.1 * i} 0 {0.1 * j}" for i in range(60) for j in range(40)))
        self.assertIn("--crop applies to a photo", self.expect(2, "facade", "fit", "--cloud", "scan.txt", "-o", "out",
                                                               "--crop", "0,0,9,9").err)

    def test_chains_that_disagree_cause_a_warning(self):
        """Windows of any size at any place, and fewer iterations than their grammar needs."""
        draw = random.Random(3)
        rows = [[(200, 190, 170)] * 120 for _ in range(120)]
        for _ in range(40):
            x, y, width, height = draw.randrange(100), draw.randrange(100), draw.randint(5, 20), draw.randint(5, 20)
            for v in range(y, y + height):
                rows[v][x:x + width] = [(40, 50, 70)] * width
        write_png(self.folder / "noise.png", rows)
        said = self.expect(0, "facade", "fit", "noise.png", "-o", "out", "--looks", "none", "--steps", 2000, "--trust", 1,
                           "--no-carving")
        self.assertRegex(said.err, "warning: the chains disagree \\(R-hat [0-9.inf]+, more than 1.1\\)")
        self.assertRegex(said.err, "hint: .*--iterations.*--looks")
        report = json.loads((self.folder / "out/noise.report.json").read_text())
        self.assertIn("the chains disagree", report["warnings"][0]["message"])
        self.assertIn("the chains disagree", (self.folder / "out/noise.report.svg").read_text())
        said = self.expect(0, "facade", "fit", "noise.png", "-o", "out", "--looks", "none", "--steps", 200,
                           "--no-carving")
        self.assertIn("too short to be compared", said.err)

    def test_a_scan(self):
        points = []
        for i in range(160):
            for j in range(100):
                x, y = 0.04 * i, 0.04 * j
                window = 1 <= x % 3.2 < 2.2 and 1 <= y < 3
                points.append(f"{x:.3f} {0.3 if window else 0} {y:.3f}")
        self.write("scan.txt", "\n".join(points))
        self.expect(0, "facade", "fit", "--cloud", "scan.txt", "-o", "out", "--steps", 20000, "--no-carving")
        tree = json.loads((self.folder / "out/scan.json").read_text())
        self.assertAlmostEqual(tree["width"], 6.36, delta=0.1)
        windows = [one["rect"] for one in tree["elements"] if one["kind"] == "window"]
        true = [(1, 1, 1.2, 2), (4.2, 1, 1.2, 2)]
        self.assertGreater(shared(windows, true), 0.85 * area(true), tree["theta"])
        self.assertLess(area(windows), 1.2 * area(true), tree["theta"])
        self.expect(0, "info", "out/scan.depth.exr")

    def test_same_bytes_for_any_threads(self):
        self.photo()
        for threads in (1, 2, 5, 8):
            self.expect(0, "facade", "fit", "photo.exr", "-o", f"out{threads}", "--steps", 5000, "--threads", threads,
                        "--no-carving")
        trees = {(self.folder / f"out{threads}/photo.json").read_bytes() for threads in (1, 2, 5, 8)}
        self.assertEqual(len(trees), 1)

    def test_the_grammar_can_be_included(self):
        self.photo()
        self.expect(0, "facade", "fit", "photo.exr", "-o", "out", "--name", "main", "--steps", 2000)
        self.expect(0, "check", "out/facade_main_scene.vug")
        self.write("street.vug", 'include "out/facade_main.vug"\nparam voxel = 20cm\n'
                   "volume both = level_set(union([facade_main, translate(facade_main, by: (9m, 0, 0))]), voxel: voxel)\n")
        self.expect(0, "check", "street.vug")
        grammar = self.folder / "out/facade_main.vug"
        before = grammar.read_bytes()
        said = self.expect(2, "facade", "fit", "photo.exr", "-o", "out", "--name", "facade_main", "--grammar", grammar).err
        self.assertIn("facade_main.vug", said)
        self.assertEqual(grammar.read_bytes(), before)

    def test_panes_follow_the_voxels(self):
        self.photo()
        self.expect(0, "facade", "fit", "photo.exr", "-o", "out", "--width", "6m", "--steps", 20000, "--no-carving")
        for voxel, pane in (("10cm", 0.025), ("40cm", 0.03), ("3cm", 0.01)):
            self.expect(0, "build", "out/photo_scene.vug", "-D", f"voxel={voxel}", "-o", "built")
            grids = json.loads(self.expect(0, "info", "built/photo_scene.vdb", "--json").out)["grids"]
            sizes = {grid["name"]: grid["voxel_size"][0] for grid in grids}
            self.assertAlmostEqual(sizes["photo_panes"], pane)

    def test_an_empty_result_is_reported(self):
        self.write("flat.txt", "\n".join(f"{0.1 * i} 0 {0.1 * j}" for i in range(60) for j in range(40)))
        said = self.expect(0, "facade", "fit", "--cloud", "flat.txt", "-o", "out", "--steps", 1000, "--no-carving").err
        self.assertIn("bare wall", said)

    def test_bad_input(self):
        self.write("text.png", "no picture")
        self.assertIn("text.png", self.expect(2, "facade", "fit", "text.png", "-o", "out").err)
        self.expect(2, "facade", "fit", "missing.png", "-o", "out")
        self.expect(2, "facade")
        self.expect(2, "facade", "fit", "missing.png")
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
