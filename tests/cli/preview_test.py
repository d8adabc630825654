# SPDX-License-Identifier: Apache-2.0
"""vug preview writes one self-contained page, and no text of a scene becomes markup."""
import base64
import html
import json
import os
import pathlib
import re
import struct
import unittest

from vug import VugTest, digest

NAME = "a <b> & 'c' \"d\""
SCENE = """# </script><script>alert(1)</script> <!-- @VUG_MODEL@
seed 3
param R = 1m in 50cm..2m "radius, </script> & <b>\\"
grammar cave {
  axiom Room*3
  Room -> + sphere(R) label random
}
volume rock = level_set(cave, voxel: 20cm)
mesh wall on rock { paint (0.5, 0.4, 0.3) }
camera other { eye (0, 9, 6) target (0, 0, 0) }
camera main { eye (0, 2, 6) target (0, 0, 0) }
light ball = sphere(center: (0, 3, 0), power: 100)
render main { size 16x9 spp 1 exposure 2 }
""".replace('<b>\\"', '<b>"')
MARKS = "<title>@VUG_TITLE@</title><script id=d>@VUG_DATA@</script><p id=m>@VUG_MODEL@</p>"


class Preview(VugTest):
    """Uses a page of placeholders and therefore does not need npm; tests/dcc opens the real page."""

    def prepare(self):
        self.write(f"{NAME}.vug", SCENE)
        self.write("data/preview.html", MARKS)

    def page(self, out, *args):
        self.expect(0, "preview", f"{NAME}.vug", "-o", out, "-q", *args, env=self.env())
        return (self.folder / out).read_text()

    def env(self, folder="data"):
        return {**os.environ, "VUG_DATA": str(self.folder / folder)}

    def data(self, page):
        texts = re.fullmatch("<title>(.*)</title><script id=d>(.*)</script><p id=m>(.*)</p>", page)
        self.assertNotIn("<", texts[2])
        return texts[1], json.loads(texts[2]), base64.b64decode(texts[3], validate=True)

    def test_contents_of_the_page(self):
        title, data, model = self.data(self.page("o.html", "-D", "R=1.25m"))
        self.assertEqual(title, html.escape(NAME).replace("&#x27;", "'"))
        self.assertEqual((data["name"], data["camera"], data["exposure"]), (NAME, "main", 2))
        [radius] = data["parameters"]
        self.assertEqual((radius["name"], radius["value"], radius["fallback"], radius["doc"], radius["share"]),
                         ("R", "1.25m", "1m", "radius, </script> & <b>", 0.5))
        self.assertIn("</script><script>alert(1)</script>", data["recipe"])
        [tree] = data["trees"]
        self.assertEqual((tree["name"], tree["tree"]["applied"]), ("cave", 3))
        self.assertEqual(tree["tree"]["productions"][0]["where"]["file"], f"{NAME}.vug")
        self.assertIsNone(data["picture"])

        measured = json.loads(self.expect(0, "measure", f"{NAME}.vug", "--json", "-D", "R=1.25m").out)
        for each in ("area", "volume", "triangles", "genus", "bounds"):
            self.assertEqual(data["metrics"][each], measured[each], each)
        self.assertEqual(data["triangles"], measured["triangles"])

        self.assertEqual(struct.unpack_from("<4sII", model), (b"glTF", 2, len(model)))
        [length] = struct.unpack_from("<I", model, 12)
        gltf = json.loads(model[20:20 + length])
        [primitive] = gltf["meshes"][0]["primitives"]
        self.assertEqual(gltf["accessors"][primitive["indices"]]["count"], 3 * data["triangles"])

    def test_the_metrics_are_those_of_the_largest_mesh(self):
        self.write("two.vug", "volume pool = level_set(box(size: (1, 1, 1)), voxel: 20cm)\nmesh water on pool {}\n"
                   "volume rock = level_set(sphere(2m), voxel: 20cm)\nmesh wall on rock {}\n")
        for options, name in ((), "wall"), (("--mesh", "water"), "water"):
            self.expect(0, "preview", "two.vug", "-o", "two.html", *options, env=self.env())
            _, data, _ = self.data((self.folder / "two.html").read_text())
            measured = json.loads(self.expect(0, "measure", "two.vug", "--mesh", name, "--json").out)
            self.assertEqual((data["mesh"], data["metrics"]["area"]), (name, measured["area"]))

    def test_the_same_bytes_again(self):
        first = digest(self.folder / "one.html") if self.page("one.html", "--threads", "1") else None
        for threads in "258":
            self.page(f"{threads}.html", "--threads", threads)
            self.assertEqual(digest(self.folder / f"{threads}.html"), first, threads)

    def test_decimation(self):
        said = self.expect(0, "preview", f"{NAME}.vug", "-o", "o.html", "--max-triangles", "300", env=self.env())
        _, data, _ = self.data((self.folder / "o.html").read_text())
        self.assertLessEqual(data["triangles"], 300)
        self.assertGreater(data["triangles"], 200)
        self.assertEqual(data["whole"], data["metrics"]["triangles"])
        self.assertIn(f"decimated to {data['triangles']} of {data['whole']} triangles", said.err)

    def test_pictures(self):
        png = b"\x89PNG\r\n\x1a\n and more"
        self.write("it.png", png)
        _, data, _ = self.data(self.page("o.html", "--picture", "it.png"))
        self.assertEqual((data["picture"]["type"], base64.b64decode(data["picture"]["data"])), ("image/png", png))
        self.write("it.txt", "a text")
        refused = self.expect(2, "preview", f"{NAME}.vug", "-o", "n.html", "--picture", "it.txt", env=self.env())
        self.assertIn("'it.txt' is neither a PNG nor a JPEG", refused.err)
        self.assertFalse((self.folder / "n.html").exists())
        _, data, _ = self.data(self.page("r.html", "--render"))
        self.assertTrue(base64.b64decode(data["picture"]["data"]).startswith(b"\x89PNG"))
        self.assertIn("16 x 9", data["picture"]["note"])

    def test_refusals(self):
        for args, why in [(("-o", "page.txt"), "does not end in .html"),
                          (("--max-triangles", "2"), "max-triangles"),
                          (("--mesh", "none"), "none"),
                          (("-o", "data/preview.html"), "preview.html")]:
            self.assertIn(why, self.expect(2, "preview", f"{NAME}.vug", *args, env=self.env()).err)
        self.assertEqual((self.folder / "data/preview.html").read_text(), MARKS)
        self.write("bad/preview.html", "<title>@VUG_TITLE@</title>")
        self.assertIn("no mark @VUG_DATA@",
                      self.expect(2, "preview", f"{NAME}.vug", env=self.env("bad")).err)
        self.assertFalse(pathlib.Path(self.folder / f"{NAME}.html").exists())


if __name__ == "__main__":
    unittest.main()
