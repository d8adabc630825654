# SPDX-License-Identifier: Apache-2.0
"""`vug new` writes scenes that render the archetypes of data/caves."""
import os
import unittest

from vug import SOURCE, VugTest

TINY = '''# A tiny cave: a ball of air. It is dark.
param size   = 1m   in 20cm..5m  "radius of the ball"
param detail = 20cm              "edge of a voxel"
volume rock = level_set(complement(sphere(size)), voxel: detail, from: (-6, -6, -6), to: (6, 6, 6))
mesh cave on rock {}
camera main  { eye (0, 0, 0)  target (1, 0, 0) }
camera aside { eye (0, 0, 0)  target (0, 0, 1) }
light lamp = sphere(center: (0.2, 0.2, 0), radius: 5cm, lumen: 100)
'''


class New(VugTest):
    def setUp(self):
        super().setUp()
        (self.folder / "data/caves").mkdir(parents=True)
        self.write("data/caves/tiny.vug", TINY)
        self.write("data/caves/part.vug", "let ball = sphere(1m)\n")  # no camera: not an archetype

    def new(self, *args, code=0):
        return self.expect(code, "new", *args, env={**os.environ, "VUG_DATA": str(self.folder / "data")})

    def test_the_list_has_the_first_sentences(self):
        out = self.new().out
        self.assertIn("tiny             A tiny cave: a ball of air.\n", out)
        self.assertIn("show_cave ", out)
        self.assertNotIn("part ", out)
        self.assertNotIn("sgm_experiment", out)

    def test_the_scene_names_every_parameter_and_renders(self):
        run = self.new("my", "--like", "tiny")
        self.assertEqual(run.out, "my.vug\n")
        text = (self.folder / "my.vug").read_text()
        self.assertIn("  size   1m    # radius of the ball, 20cm to 5m\n", text)
        self.assertIn("  detail 20cm  # edge of a voxel\n", text)
        self.assertIn("# Another view: --camera cave.aside\n", text)
        self.assertEqual(self.expect(0, "format", "--check", "my.vug").out, "")
        self.expect(0, "render", "my.vug", "-o", "my.exr", "--size", "16x9", "--spp", "1", "-q",
                    env={**os.environ, "VUG_DATA": str(self.folder / "data")})

    def test_scenes_of_all_archetypes_are_short_and_fine(self):
        for file in sorted((SOURCE / "data/caves").glob("*.vug")):
            if "\ncamera " not in file.read_text():
                continue
            self.new(file.stem, "--like", file.stem)
            text = (self.folder / f"{file.stem}.vug").read_text()
            self.assertLessEqual(len(text.splitlines()), 25, file.stem)
            self.expect(0, "format", "--check", f"{file.stem}.vug")
            self.assertIn(": fine;", self.expect(0, "check", f"{file.stem}.vug").out)

    def test_refusals(self):
        self.assertIn("did you mean 'tiny'?", self.new("my", "--like", "tinny", code=2).err)
        self.assertIn("a new scene needs a name and an archetype", self.new("my", code=2).err)
        self.write("my.vug", "seed 3\n")
        self.assertIn("'my.vug' exists already", self.new("my", "--like", "tiny", code=2).err)
        self.assertEqual((self.folder / "my.vug").read_text(), "seed 3\n")


if __name__ == "__main__":
    unittest.main()
