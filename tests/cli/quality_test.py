# SPDX-License-Identifier: Apache-2.0
"""The quality of pictures: vug render --quality, and the noise in their headers."""
import unittest

from vug import VugTest, digest

SCENE = """volume rock = level_set(box(size: (6, 4, 6)) - sphere(1.8m), voxel: 20cm)
camera main { eye (-1.2m, 0.3, 0.4)  target (1, 0, 0)  fov 70deg }
light lamp = sphere(center: (0.5, 0.6, 0.3), radius: 10cm, radiance: (9, 60, 30))
render main { size 48x32 %s }
"""


class Quality(VugTest):
    def render(self, entries, *args, code=0):
        self.write("s.vug", SCENE % entries)
        return self.expect(code, "render", "s.vug", "-o", "s.exr", *args)

    def header(self):
        lines = self.expect(0, "info", "s.exr").out.splitlines()
        return dict(line.strip().split(": ", 1) for line in lines if line.startswith("  vug:"))

    def test_a_picture_without_samples_is_rendered_to_a_noise(self):
        said = self.render("").err
        header = self.header()
        self.assertRegex(said, r"noise \d+\.\d % with \d+ samples per pixel\n")
        self.assertEqual(header["vug:spp"], "128")
        self.assertLess(float(header["vug:noise"]), 0.08)
        self.assertLessEqual(float(header["vug:samples"]), 128)
        self.assertIn("denoised", self.expect(0, "info", "s.exr").out)

    def test_the_same_bytes_on_any_number_of_threads(self):
        digests = set()
        for threads in (1, 2, 7):
            self.render("quality look", "--threads", threads)
            digests.add(digest(self.folder / "s.exr"))
        self.assertEqual(len(digests), 1)

    def test_stated_samples_are_exact(self):
        self.render("spp 8")
        self.assertNotIn("vug:noise", self.header())
        plain = digest(self.folder / "s.exr")
        self.render("spp 8", "--quality", "look", "--spp", "8", "--denoise=false")
        self.assertNotIn("vug:noise", self.header())
        self.assertEqual(self.header()["vug:spp"], "8")
        self.render("spp 8")
        self.assertEqual(digest(self.folder / "s.exr"), plain)

    def test_an_option_replaces_the_samples_of_the_scene(self):
        self.assertIn("% with", self.render("spp 8", "--quality", "final", "--noise", "20%").err)
        self.assertEqual(self.header()["vug:spp"], "4096")
        self.assertNotIn("denoised", self.expect(0, "info", "s.exr").out)

    def test_a_limit_out_of_reach_is_stated(self):
        self.assertIn(", the most that spp allows; 1 % needs about ", self.render("spp 16  noise 1%").err)

    def test_parts_need_a_number_of_samples(self):
        self.write("s.vug", SCENE % "")
        self.assertIn("--spp 64", self.expect(2, "render", "s.vug", "--part", "p", "--tile", "1/2").err)
        self.assertIn("draft, look", self.render("", "--quality", "best", code=2).err)


if __name__ == "__main__":
    unittest.main()
