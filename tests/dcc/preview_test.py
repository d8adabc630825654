# SPDX-License-Identifier: Apache-2.0
"""The page of vug preview, opened in Chromium: it shows the model and every panel, without network requests
and console messages."""
import os
import pathlib
import re
import shutil
import unittest

from external_tools import SCENE, VugTest, node, require_node, skip

PAGE = pathlib.Path(os.environ.get("VUG_PREVIEW_PAGE", ""))
MORE = """param R = 50cm in 30cm..70cm "radius, <img src=x onerror=alert(1)>"
grammar cave {
  axiom Room*3
  Room -> + sphere(R) label random
}
volume hall = level_set(cave, voxel: 10cm)
mesh hall on hall {}
object hall on hall {}
"""


class Preview(VugTest):
    def test_the_bundle_needs_nothing_else(self):
        page = PAGE.read_text()
        for what in (r"<link[^>]+https?:", r"<script[^>]+src", r"@import", r"\bimport\s*\("):
            self.assertIsNone(re.search(what, page), what)
        self.assertEqual([page.count(f"@VUG_{mark}@") for mark in ("TITLE", "DATA", "MODEL")], [1, 1, 1])

    def test_in_a_browser(self):
        self.write("all <b>.vug", MORE + SCENE.replace("seed 3\n", ""))
        self.expect(0, "preview", "all <b>.vug", "-o", "page.html", "--render", "--seed", "3", "-q")
        seen = node("open_preview.mjs", os.environ["VUG_CHROMIUM"], self.folder / "page.html",
                    self.folder / "page.png")
        if folder := os.environ.get("VUG_KEEP"):
            shutil.copy(self.folder / "page.png", folder)
        self.assertEqual((seen["ready"], seen["trouble"]), ("yes", ""))
        self.assertEqual((seen["title"], seen["heading"]), ("all <b>", "all <b>"))
        self.assertEqual(seen["said"], [])
        self.assertEqual([url for url in seen["asked"] if not url.startswith("file:")], [])
        self.assertEqual(len(seen["asked"]), 1)  # the page itself
        self.assertEqual(seen["marked"], 3)      # no text of the scene has become markup

        # The number of triangles that the exporter wrote: the walls, the halls, three pebbles.
        self.expect(0, "build", "all <b>.vug", "-o", "o", "-q", "--seed", "3")
        count = {name: self.triangles(f"o/all <b>_{name}.ply") for name in ("wall", "pebble", "hall")}
        drawn = count["wall"] + count["hall"] + self.pebbles * count["pebble"]
        self.assertEqual(int(seen["triangles"]), drawn)
        self.assertIn("triangles", seen["count"])

        pages = seen["pages"]
        self.assertEqual(list(pages), [f"page-{p}" for p in ("picture", "tree", "metrics", "parameters", "recipe")])
        self.assertEqual(seen["pictureWidth"], 320)
        self.assertIn("320 x 160", pages["page-picture"])
        self.assertIn("3 productions applied", pages["page-tree"])
        self.assertIn("Room", pages["page-tree"])
        self.assertIn("Area", pages["page-metrics"])
        self.assertIn("<img src=x onerror=alert(1)>", pages["page-parameters"])
        self.assertIn("axiom Room*3", pages["page-recipe"])
        self.assertGreater(seen["spread"], 8)  # of 255; a uniform picture has 0
        self.assertEqual(seen["changes"], {"f": True, "[": True, "h": True})

    pebbles = 3  # in the heap; an instanced object does not appear in its own position

    def triangles(self, file):
        head = (self.folder / file).read_bytes()[:4096]
        return int(re.search(rb"element face (\d+)", head)[1])


if __name__ == "__main__":
    require_node()
    if not shutil.which(os.environ.get("VUG_CHROMIUM", "")):
        skip("Chromium is missing (Debian's package chromium)")
    if not PAGE.exists():
        skip("the page of vug preview was not built, which requires npm and its registry")
    unittest.main()
