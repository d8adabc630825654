# SPDX-License-Identifier: Apache-2.0
"""`vug scout` finds shots, and cameras use them."""
import unittest

from vug import VugTest, digest

HALL = '''let solid = box(size: (28, 10, 28)).translate((0, 3, 0))
let air = box(size: (24, 5, 6)).translate((0, 2.5, 0)) + tapered_capsule(a: (-6, 1.4, 0), b: (-7, 1.4, 12), radius_a: 1.6, radius_b: 1)
let pillars = union([for x, z in zip([-2, 3, 8], [-1.4, 1.8, -1.6]): tapered_capsule(a: (x, -1, z), b: (x, 6, z), radius_a: 0.8, radius_b: 0.5)])
volume rock = level_set(difference(solid, air) + pillars, voxel: 30cm)
mesh cave on rock {}
object walls on cave {}
'''
CAMERA = "camera main { eye (-10, 2, 0)  target (1, 2, 0) }\n"
LAMP = "light lamp = sphere(center: (2, 4, 0), radius: 20cm, lumen: 3000)\n"
SMALL = ("--spp", "1", "-q")


class Scout(VugTest):
    def scout(self, *args, code=0):
        return self.expect(code, "scout", "hall.vug", "--shots", "2", *SMALL, *args)

    def test_the_shots_are_text_that_a_camera_uses(self):
        self.write("hall.vug", HALL + "camera main { scout 2 }\n")
        run = self.scout()
        self.assertEqual(run.out, "hall_shots/sheet.png\nhall_shots/shot1.vug\nhall_shots/shot2.vug\n")
        text = (self.folder / "hall_shots/shot2.vug").read_text()
        self.assertIn("# Shot 2 of hall.vug. Use it with: camera main { scout 2 }\n", text)
        self.assertIn("light shot2_", text)
        self.expect(0, "format", "--check", "hall_shots/shot2.vug")
        self.assertIn(": fine;", self.expect(0, "check", "hall.vug").out)
        self.expect(0, "render", "hall.vug", "-o", "a.exr", "--size", "16x9", "--spp", "1", "-q")

    def test_the_same_bytes_for_any_number_of_threads(self):
        self.write("hall.vug", HALL + CAMERA + LAMP)
        files = ("sheet.png", "shot1.vug", "shot2.vug")
        known = None
        for threads in (1, 2, 7):
            self.scout("--threads", threads, "-o", f"t{threads}")
            made = [digest(self.folder / f"t{threads}" / each) for each in files]
            self.assertEqual(made, known or made)
            known = made
        self.assertNotIn("light", (self.folder / "t1/shot1.vug").read_text())
        self.scout("--shot-seed", 5, "-o", "other")
        self.assertNotEqual(digest(self.folder / "other/shot1.vug"), known[1])

    def test_a_dark_cave_is_lit_and_the_lamps_are_printed(self):
        self.write("hall.vug", HALL + CAMERA)
        run = self.expect(0, "render", "hall.vug", "-o", "a.exr", "--size", "16x9", "--spp", "1", "-q")
        self.assertIn("note: the scene has no light", run.err)
        kept = run.err[run.err.index('include "kit/lamps.vug" as lamps\n'):]
        self.write("kept.vug", HALL + CAMERA + kept)
        again = self.expect(0, "render", "kept.vug", "-o", "b.exr", "--size", "16x9", "--spp", "1", "-q")
        self.assertNotIn("note:", again.err)
        self.expect(0, "diff", "a.exr", "b.exr")

    def test_the_test_before_a_render_names_the_exposure(self):
        self.write("hall.vug", HALL + CAMERA + LAMP + "render main { exposure -13 }\n")
        render = ("render", "hall.vug", "-o", "a.exr", "--size", "16x9", "--spp", "1", "-q")
        err = self.expect(0, *render).err
        self.assertIn("hall.vug:9:8: warning: the picture will be black\n", err)
        self.assertIn("hint: --exposure ", err)
        self.assertNotIn("will be black", self.expect(0, *render, "--untested").err)

    def test_refusals(self):
        self.write("hall.vug", "volume rock = level_set(sphere(1m), voxel: 20cm)\n")
        self.assertIn("the scene has no floor to stand on", self.scout(code=2).err)
        self.assertIn("--shots", self.expect(2, "scout", "hall.vug", "--shots", "0").err)
        self.write("hall.vug", HALL + "camera main { scout 7 }\n")
        self.assertIn("the scene has no shot 7: 'hall_shots/shot7.vug' does not exist",
                      self.expect(2, "check", "hall.vug").err)


if __name__ == "__main__":
    unittest.main()
