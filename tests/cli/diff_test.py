# SPDX-License-Identifier: Apache-2.0
"""vug diff: exit codes, symmetry, masks, limits, the significance test, and reports."""
import base64
import html.parser
import json
import re
import subprocess
import unittest

from pictures import scene, shown, write_hdr, write_png
from vug import VugTest, digest

ROOM = """param LIGHT = 9  in 0..100  "radiance of the lamp"
param GREY = 0.5  in 0..1  "of the ball"
volume walls = level_set(shell(box(size: (4, 4, 4)), thickness: 20cm), voxel: 20cm)
volume ball = level_set(sphere(50cm).translate((0, -1.4, 0)), voxel: 10cm)
mesh wall on walls {}
mesh round on ball {}
material rock = lambert(albedo: (0.5, 0.5, 0.5))
material skin = lambert(albedo: (GREY, GREY, GREY))
object a on wall { material rock }
object b on round { material skin }
camera main { eye (0, 0, 1.7)  target (0, -0.3, 0)  fov 70deg }
light lamp = sphere(center: (1, 0.8, 0.4), radius: 20cm, radiance: (LIGHT, LIGHT, LIGHT))
render main { size 48x32  spp 64 }
"""


class Page(html.parser.HTMLParser):
    """The contents of a report page."""

    def __init__(self, text):
        super().__init__()
        self.pictures, self.open, self.words = {}, [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            assert name not in ("src", "href") or value.startswith("data:"), f"{tag} loads {value}"
        if tag == "img":
            attributes = dict(attributes)
            self.pictures[attributes["alt"]] = base64.b64decode(attributes["src"].split(",")[1])
        elif tag not in ("meta", "input"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_data(self, data):
        self.words.append(data)


class OfScreens(VugTest):
    def prepare(self):
        write_png(self.folder / "a.png", shown(scene(40, 30, 1)))
        write_png(self.folder / "b.png", shown(scene(40, 30, 1, shift=0.05)))
        write_png(self.folder / "small.png", shown(scene(20, 30, 1)))
        write_hdr(self.folder / "a.hdr", scene(40, 30, 1))
        write_hdr(self.folder / "dark.hdr", scene(40, 30, 1, dark=0.98))
        white, black = (255, 255, 255), (0, 0, 0)
        left = [[white if x < 12 else black for x in range(40)] for _ in range(30)]
        write_png(self.folder / "left.png", left)
        write_png(self.folder / "none.png", [[black] * 40] * 30)

    def test_a_file_is_itself(self):
        for name in ("a.png", "a.hdr"):
            result = self.expect(0, "diff", name, name)
            self.assertTrue(result.out.startswith("identical\n\n"), result.out)
            values = re.findall(r"^beauty +(\w+) +(\S+)", result.out, re.M)
            self.assertEqual({name: value for name, value in values if value != "0"},
                             {"psnr": "inf", "ssim": "1"})

    def test_verdicts_do_not_depend_on_the_order(self):
        for a, b in [("a.png", "b.png"), ("a.hdr", "dark.hdr")]:
            one, other = (self.expect(1, "diff", *pair).out for pair in [(a, b), (b, a)])
            self.assertTrue(one.startswith("different: ") and other.startswith("different: "), one)
            self.assertEqual(one.split("\n")[1:], other.split("\n")[1:])

    def test_pictures_without_variance(self):
        said = "the noise is unknown: neither picture contains the variance of its pixels"
        self.assertIn(said, self.expect(1, "diff", "a.hdr", "dark.hdr").out)
        self.assertNotIn(said, self.expect(1, "diff", "a.hdr", "dark.hdr", "--max", "rmse=1e-6").out)

    def test_limits(self):
        args = ("diff", "a.hdr", "dark.hdr")
        self.expect(0, *args, "--max", "relative_rmse=0.2", "--min", "ssim=0.5")
        failed = self.expect(1, *args, "--max", "relative_rmse=0.2", "--max", "beauty.rmse=1e-6")
        self.assertRegex(failed.out, r"rmse +\S+ +at most +1e-06 +FAILED")
        self.assertTrue(failed.out.startswith("different: the picture is 2 % darker everywhere\n"), failed.out)
        self.assertIn("\nreasons: rmse of beauty is ", failed.out)
        self.write("limits.json", '{"relative_rmse": 0.2, "ssim": 0.5}')
        self.expect(0, *args, "--thresholds", "limits.json")
        self.write("limits.json", '{"psnr": 90}')
        self.expect(1, *args, "--thresholds", "limits.json")

    def test_masks(self):
        write_png(self.folder / "far.png", [[(255,) * 3 if x > 34 and y > 25 else (0,) * 3
                                             for x in range(40)] for y in range(30)])
        self.expect(0, "diff", "a.png", "b.png", "--mask", "far.png", "--metric", "rmse")
        self.expect(1, "diff", "a.png", "b.png", "--mask", "left.png")
        for mask in ("none.png", "small.png"):
            self.assertIn("hint: ", self.expect(2, "diff", "a.png", "b.png", "--mask", mask).err)

    def test_unusable(self):
        self.write("text.exr", "no picture at all")
        self.write("bad.json", '{"rmse": }')
        self.write("list.json", "[1]")
        self.write("word.json", '{"rmse": "low"}')
        for args, said in [
                (("a.png", "none.exr"), "no such file"), (("text.exr", "a.png"), "text.exr"),
                (("a.png", "."), "folder"), (("a.png", "small.png"), "40 x 30"),
                (("a.png", "b.png", "--layer", "beuty"), "did you mean 'beauty'?"),
                (("a.png", "b.png", "--metric", "rsme"), "did you mean 'rmse'?"),
                (("a.png", "b.png", "--max", "rsme=1"), "did you mean 'rmse'?"),
                (("a.png", "b.png", "--max", "rmse"), "write --max"),
                (("a.png", "b.png", "--max", "rmse=low"), "write --max"),
                (("a.png", "b.png", "--max", "psnr=30"), "write --min"),
                (("a.png", "b.png", "--min", "rmse=30"), "write --max"),
                (("a.png", "b.png", "--max", "N.rmse=30"), "'N'"),
                (("a.png", "b.png", "--alarm", "0.01"), "variance"),
                (("a.png", "b.png", "--alarm", "2"), "alarm"),
                (("a.png", "b.png", "--thresholds", "bad.json"), "bad.json:1"),
                (("a.png", "b.png", "--thresholds", "list.json"), "list.json"),
                (("a.png", "b.png", "--thresholds", "word.json"), "rmse"),
                (("a.png", "b.png", "--heat", "heat.jpg"), ".png"), (("a.png",), "test")]:
            with self.subTest(args=args):
                self.assertIn(said, self.expect(2, "diff", *args).err)
        self.assertIn("error: ", self.expect(3, "diff", "a.png", "b.png", "--html", "a.png/x.html").err)

    def test_reports(self):
        for name, threads in (("one", 1), ("two", 2), ("five", 5), ("eight", 8)):
            self.expect(1, "diff", "a.png", "b.png", "--json", f"{name}.json", "--html", f"{name}.html",
                        "--heat", f"{name}.png", "--threads", threads)
        for kind in ("json", "html", "png"):
            self.assertEqual(len({digest(self.folder / f"{name}.{kind}") for name in ("one", "two", "five", "eight")}), 1)
        verdict = json.loads((self.folder / "one.json").read_text())
        self.assertEqual((verdict["same"], verdict["basis"]), (False, "rounding"))
        self.assertFalse(verdict["layers"]["beauty"]["relative_max"]["passed"])
        page = Page((self.folder / "one.html").read_text())
        self.assertEqual(page.open, [])
        self.assertEqual(list(page.pictures), ["reference", "test", "heat map (flip)"])
        for data in page.pictures.values():
            self.assertTrue(data.startswith(b"\x89PNG"))
        self.assertIn("different", page.words)
        self.expect(0, "info", "one.png")

    def test_names_in_reports_are_text(self):
        write_png(self.folder / "<b>&.png", shown(scene(40, 30, 1)))
        self.expect(0, "diff", "a.png", "<b>&.png", "--html", "page.html")
        self.assertIn("<b>&.png", Page((self.folder / "page.html").read_text()).words)


class OfRenders(VugTest):
    def prepare(self):
        self.write("room.vug", ROOM)
        for name, args in [("a", ["--seed", "1"]), ("b", ["--seed", "2"]),
                           ("dark", ["--seed", "3", "-D", "LIGHT=8.5"]), ("ball", ["--seed", "4", "-D", "GREY=0.3"])]:
            self.expect(0, "render", "room.vug", "-o", f"{name}.exr", *args)

    def test_noise_is_not_a_difference(self):
        same = self.expect(0, "diff", "a.exr", "b.exr")
        self.assertIn("the same: the differences are within the noise", same.out)
        self.assertIn("not judged although they differ: ", same.out)

    def test_less_light_and_another_material_are_differences(self):
        for name, words in [("dark", r"the picture is \d % {} everywhere"),
                            ("ball", r"the picture is \d % {}, most at the bottom")]:
            for pair, change in [(("a.exr", f"{name}.exr"), "darker"), ((f"{name}.exr", "a.exr"), "brighter")]:
                with self.subTest(pair=pair):
                    said = self.expect(1, "diff", *pair, "--html", "page.html", "--json", "diff.json").out
                    verdict, statistics = said.split("\n", 1)
                    self.assertRegex(verdict, f"^different: {words.format(change)}$")
                    self.assertIn("\nreasons: ", statistics)
                    self.assertIn(json.loads((self.folder / "diff.json").read_text())["words"][0], verdict)
                    page = Page((self.folder / "page.html").read_text()).words
                    self.assertLess(page.index(verdict), min(i for i, text in enumerate(page) if "z = " in text))

    def test_layers(self):
        limits = ("--max", "Z.mean=0.1", "--max", "albedo.max=1")
        self.expect(0, "diff", "a.exr", "ball.exr", "--layer", "Z", "--max", "mean=0.1")
        self.expect(1, "diff", "a.exr", "ball.exr", "--layer", "albedo", "--max", "mean=1e-4")
        self.expect(0, "diff", "a.exr", "b.exr", *limits)
        self.expect(1, "diff", "a.exr", "dark.exr", *limits)  # the beauty is judged by its noise

    def test_parts_of_one_file_are_one_picture(self):
        parts = ["a.exr", "--ch", "R,G,B,samples", "--attrib", "oiio:subimagename", "light",
                 "a.exr", "--ch", "variance.R,variance.G,variance.B,Z", "--siappend"]
        subprocess.run(["oiiotool", *parts, "-o", "parts.exr"], cwd=self.folder, check=True)
        self.expect(0, "diff", "a.exr", "parts.exr", "--layer", "beauty,Z,variance")
        self.assertIn("within the noise", self.expect(0, "diff", "parts.exr", "b.exr", "--layer", "beauty").out)

    def test_crops_and_parts(self):
        common = ("room.vug", "--sample-seed", "1")
        self.expect(0, "render", *common, "-o", "left.exr", "--crop", "0,0,24,32")
        self.expect(0, "render", *common, "-o", "right.exr", "--crop", "24,0,48,32")
        self.assertIn("crop from 24, 0", self.expect(2, "diff", "left.exr", "right.exr").err)
        self.expect(0, "render", *common, "-o", "whole.exr")
        self.expect(0, "render", *common, "-o", "parts.exr", "--multi-part")
        self.assertTrue(self.expect(0, "diff", "whole.exr", "parts.exr").out.startswith("identical\n"))

    def test_the_page_shows_the_blocks(self):
        self.expect(1, "diff", "a.exr", "dark.exr", "--html", "page.html", "--quiet")
        self.assertIn("z-scores of blocks", Page((self.folder / "page.html").read_text()).pictures)


if __name__ == "__main__":
    unittest.main()
