# SPDX-License-Identifier: Apache-2.0
"""No verb overwrites its inputs under any name, and two outputs never share a file."""
import os
import unittest

from pictures import write_hdr
from vug import BALL, VugTest

SCENE = BALL + """mesh skin on rock { paint picture(file: "shot.png", size: 1m) }
object ball on skin {}
light sky = sky(radiance: (1, 1, 1))
camera main { eye (0, 0, 7) }
render main { size 8x6  spp 1 }
"""


class InputsKept(VugTest):
    def refused(self, kept, *args):
        before = {file: (self.folder / file).read_bytes() for file in kept}
        result = self.expect(2, *args)
        self.assertRegex(result.err, "would overwrite an input file|would be written twice")
        self.assertEqual(before, {file: (self.folder / file).read_bytes() for file in kept})

    def test_scenes_and_what_they_name(self):
        self.write("ball.vug", BALL + "mesh skin on rock {}\n")
        self.expect(0, "build", "ball.vug", "-o", ".")
        again = 'volume rock = level_set(mesh(file: "ball.ply"), voxel: 40cm)\nmesh skin on rock {}\n'
        self.write("ball.vug", again)
        self.refused(["ball.vug", "ball.ply"], "build", "ball.vug", "-o", ".")
        self.refused(["ball.ply"], "build", "ball.vug", "-o", "x/..")
        self.expect(0, "build", "ball.vug", "-o", "elsewhere")

        self.write("plain.vug", SCENE.replace('paint picture(file: "shot.png", size: 1m)', ""))
        self.expect(0, "render", "plain.vug", "-o", "shot.exr")
        self.write("shot.vug", SCENE)
        os.symlink("shot.vug", self.folder / "link.vug")
        for args in [("-o", "shot.exr"), ("-o", "other.exr", "--preview", "shot.png"),
                     ("--part", "shot.vug"), ("--part", "link.vug"),
                     ("-o", "other.exr", "--checkpoint", "./shot.vug")]:
            self.refused(["shot.vug", "shot.png"], "render", "shot.vug", *args)
        self.assertFalse((self.folder / "other.exr").exists())
        self.expect(0, "render", "shot.vug", "-o", "other.exr", "--preview", "other.png")

    def test_surveys(self):
        self.write("all.svx", "*include part\n1 2 10 0 0\n")
        self.write("part.svx", "2 3 10 90 0\n")
        self.write("cave.vug", 'network plan = survey(file: "all.svx")\n'
                   'volume air = level_set(passages(of: plan), voxel: 1m)\nmesh wall on air {}\n')
        os.symlink("part.svx", self.folder / "plot.svg")
        kept = ["all.svx", "part.svx", "cave.vug"]
        for name in ("all.svx", "./part.svx"):
            self.refused(kept, "survey", "all.svx", "-o", name)
            self.refused(kept, "survey", "--shoot", "cave.vug", "-o", name)
        for file in ("cave.vug", "all.svx"):
            self.refused(kept, "measure", file, "--score", "--plot", "plot.svg")
        os.symlink("part.svx", self.folder / "cave.ply")
        self.refused(kept, "build", "cave.vug", "-o", ".")
        # A network without a name.
        self.write("cave.vug", 'volume air = level_set(passages(of: survey(file: "all.svx")), voxel: 1m)\n')
        self.refused(kept, "survey", "--shoot", "cave.vug", "-o", "part.svx")
        os.symlink("part.svx", self.folder / "cave.vdb")
        self.refused(kept, "build", "cave.vug", "-o", ".")

    def test_pictures_that_are_compared(self):
        for name in ["a.hdr", "b.hdr"]:
            write_hdr(self.folder / name, [[(0.5, 0.5, 0.5)] * 8] * 8)
        self.refused(["a.hdr"], "diff", "a.hdr", "b.hdr", "--json", "a.hdr")
        self.refused(["b.hdr"], "diff", "a.hdr", "b.hdr", "--html", "./b.hdr")
        self.refused([], "diff", "a.hdr", "b.hdr", "--html", "same", "--json", "same")

    def test_parts(self):
        self.write("plain.vug", SCENE.replace('paint picture(file: "shot.png", size: 1m)', ""))
        self.expect(0, "render", "plain.vug", "--part", "whole.exr")
        self.refused(["whole.exr"], "merge", "whole.exr", "-o", "whole.exr")


if __name__ == "__main__":
    unittest.main()
