# SPDX-License-Identifier: Apache-2.0
"""Sequences of pictures: vug render --frames."""
import re
import unittest

import exr
from vug import VugTest, digest

SCENE = """seed 5
volume rock = level_set(box(size: (6, 4, 6)) - sphere(1.8m), voxel: 20cm)
camera main { eye (keys(1: -1.2m, 9: 0m), 0.3, 0.4)  target (1, 0, 0)  fov 70deg }
light lamp = sphere(center: (0.5, 0.6, 0.3), radius: 10cm, radiance: (9 * frame, 60, 30))
render main { size 48x30  spp 8 }
"""


class Frames(VugTest):
    def render(self, *args, code=0):
        return self.expect(code, "render", "s.vug", *args)

    def setUp(self):
        super().setUp()
        self.write("s.vug", SCENE)

    def test_a_frame_alone_is_that_of_the_sequence(self):
        run = self.render("-o", "a.####.exr", "--frames", "3..7x2")
        self.assertEqual([name for name in self.files() if name.startswith("a.")],
                         [f"a.000{n}.{end}" for n in (3, 5, 7) for end in ("exr", "png")])
        self.assertEqual(run.out.split(), [f"a.000{n}.{end}" for n in (3, 5, 7)
                                           for end in ("exr", "png")])
        self.assertIn("frame 5, 2 of 3", run.err)
        self.render("-o", "alone.exr", "--frame", "7", "--threads", "1")
        for end in ("exr", "png"):
            self.assertEqual(digest(self.folder / f"a.0007.{end}"),
                             digest(self.folder / f"alone.{end}"))
        self.assertNotEqual(digest(self.folder / "a.0005.exr"), digest(self.folder / "a.0007.exr"))
        self.assertEqual(self.render("-o", "b.####.exr", "--frame", "7", "--preview", "b.png").out.split(),
                         ["b.0007.exr", "b.0007.png"])
        self.assertEqual(digest(self.folder / "b.0007.exr"), digest(self.folder / "alone.exr"))
        part, = exr.read(self.folder / "alone.exr")
        self.assertEqual(part.text("vug:frame"), "7")
        self.assertIn("--frame 7", part.text("vug:recipe"))

    def test_a_locked_exposure_is_that_of_the_first_frame(self):
        def exposures(*args):
            self.render("-o", "e.####.exr", "--frames", "1..9x4", *args)
            return [exr.read(self.folder / f"e.000{n}.exr")[0].attributes["vug:exposure"][1].decode() for n in (1, 5, 9)]

        metered, locked = exposures(), exposures("--exposure", "locked")
        self.assertEqual(locked, [metered[0]] * 3)
        self.assertEqual(len(set(metered)), 3)
        (self.folder / "e.0005.exr").unlink()
        self.assertEqual(exposures("--exposure", "locked", "--resume"), locked)
        self.assertEqual(exposures("--exposure", "2", "--compensation", "1"), ["2"] * 3)

    def test_resuming_renders_missing_and_outdated_frames(self):
        self.render("-o", "a.#.exr", "--frames", "1..3")
        first = digest(self.folder / "a.2.exr")
        (self.folder / "a.2.exr").unlink()
        (self.folder / "a.3.png").unlink()
        run = self.render("-o", "a.#.exr", "--frames", "1..4", "--resume")
        self.assertEqual(re.findall(r"a\.(\d)\.exr", run.out), ["2", "3", "4"])
        self.assertIn("1 frame", run.err)
        self.assertEqual(digest(self.folder / "a.2.exr"), first)
        run = self.render("-o", "a.#.exr", "--frames", "1..4", "--resume", "-q")
        self.assertEqual(run.out + run.err, "")
        run = self.render("-o", "a.#.exr", "--frames", "1..4", "--resume", "--spp", "9")
        self.assertEqual(len(run.out.split()), 8)
        self.write("s.vug", SCENE.replace("70deg", "71deg"))
        run = self.render("-o", "a.#.exr", "--frames", "2", "--resume")
        self.assertEqual(len(run.out.split()), 2)

    def test_parts_and_products_of_frames(self):
        for i in (1, 2):
            self.render("--part", f"t{i}.%d.part", "--tile", f"{i}/2", "--frames", "4,5")
        self.expect(0, "merge", "t1.5.part", "t2.5.part", "-o", "joint.exr")
        self.render("-o", "whole.exr", "--frame", "5")
        self.assertEqual(digest(self.folder / "joint.exr"), digest(self.folder / "whole.exr"))
        self.assertIn("'t1.4.part' and 't2.5.part' have different frames, 4 and 5",
                      self.expect(2, "merge", "t1.4.part", "t2.5.part", "-o", "x.exr").err)

    def test_a_preview_of_each_frame_or_of_the_one_that_is_rendered(self):
        self.render("-o", "a.#.exr", "--frames", "3,4", "--preview", "so_far.##.png")
        self.render("-o", "a.#.exr", "--frames", "3,4", "--preview", "so_far.png")
        for preview, frame in (("so_far.03", 3), ("so_far.04", 4), ("so_far", 4)):
            self.assertEqual(digest(self.folder / f"{preview}.png"), digest(self.folder / f"a.{frame}.png"))
        self.assertNotIn("so_far.##.png", self.files())

    def test_refusals(self):
        self.assertIn("####", self.render("-o", "a.exr", "--frames", "1..3", code=2).err)
        self.assertIn("1..24", self.render("-o", "a.#.exr", "--frames", "1-3", code=2).err)
        self.assertIn("backwards", self.render("-o", "a.#.exr", "--frames", "3..1", code=2).err)
        self.assertIn("####", self.render("-o", "a.#.exr", "--frames", "1..3", "--checkpoint", "c",
                                          code=2).err)
        self.render("-o", "a.#.exr", "--frames", "1..3", "--frame", "2", code=2)
        self.assertEqual(self.files(), ["s.vug"])

    def test_other_verbs_take_a_frame(self):
        self.write("b.vug", "volume ball = level_set(sphere(keys(1: 50cm, 3: 1m)), voxel: 10cm)\n")
        sizes = [float(re.search(r'"volume": ([\d.]+)', self.expect(
            0, "measure", "b.vug", "--json", "--frame", n).out).group(1)) for n in (1, 3)]
        self.assertGreater(sizes[1], 6 * sizes[0])


if __name__ == "__main__":
    unittest.main()
