# SPDX-License-Identifier: Apache-2.0
"""Meshes of carved facades carry the element of each vertex: in files, in exports and in pictures."""
import json
import unittest

import exr
from vug import VugTest

HOUSE = """
grammar house: facade {
  width 4m
  height 3m
  axiom House
  House -> columns(1, inset(60cm, 60cm, 80cm, 60cm, window(sash: 0cm)), 1, inset(50cm, 50cm, 0cm, 60cm, door))
}
let cliff = carve(half_space(normal: (0, 0, 1)), house, at: (0, 0, 0))
volume rock = level_set(displace(cliff, noise: fbm(scale: 50cm), amount: 1cm), voxel: 10cm, from: (-3, -1, -1), to: (3, 4, 1))
mesh wall on rock { elements cliff }
object wall on wall { material surface(color: layer(under: (0.6, 0.5, 0.4), over: (0.1, 0.1, 0.1), mask: attribute(name: "window"))) }
camera main { kind orthographic  eye (0, 1.5, 5)  target (0, 1.5, 0)  width 6m }
light sky = sky()
render main { size 24x16  spp 1  layers ["beauty", "attribute_window", "attribute_door", "attribute_node"] }
"""
NAMES = ["door", "node", "wall", "window"]


class Elements(VugTest):
    def setUp(self):
        super().setUp()
        self.write("house.vug", HOUSE)

    def test_files_carry_them(self):
        self.expect(0, "build", "house.vug", "-o", "out")
        header = (self.folder / "out/house.ply").read_bytes().split(b"end_header")[0].decode()
        for name in NAMES:
            self.assertIn(f"property float {name}\n", header)
        self.expect(0, "export", "house.vug", "-o", "usd", "--for", "usd")
        scene = (self.folder / "usd/house.usda").read_text()
        for name in NAMES:
            self.assertIn(f"primvars:{name} = ", scene)
        self.expect(0, "export", "house.vug", "-o", "gltf", "--for", "gltf")
        glb = (self.folder / "gltf/house.glb").read_bytes()
        for name in NAMES:
            self.assertIn(f'"_{name.upper()}"'.encode(), glb)

    def test_pictures_have_layers_of_them(self):
        self.expect(0, "render", "house.vug", "-o", "house.exr")
        [picture] = exr.read(self.folder / "house.exr")
        tree = json.loads(self.expect(0, "tree", "house.vug", "--json").out)
        kinds = {one["kind"]: one["node"] for one in tree["elements"]}

        def at(name, x, y):
            """The value at a point of the facade, in metres from the centre of its base."""
            return picture.pixels[f"attribute_{name}.X"][24 * int((3.5 - y) / 0.25) + int((x + 3) / 0.25)]

        self.assertGreater(at("door", 1.05, 0.85), 0.9)
        self.assertAlmostEqual(at("node", 1.05, 0.85), kinds["door"], delta=0.05)
        self.assertEqual(at("window", 1.05, 0.85), 0)
        self.assertEqual(at("node", -2.8, 1.5), -1, "rock next to the facade")

    def test_elements_require_a_facade(self):
        self.write("bad.vug", HOUSE.replace("elements cliff", "elements displace(cliff)"))
        said = self.expect(2, "build", "bad.vug", "-o", "out").err
        self.assertIn("bad.vug:10:21: error: 'elements' must be grammars of kind facade, or results of carve(...)", said)
        self.write("near.vug", HOUSE.replace('attribute(name: "window")', 'attribute(name: "windw")'))
        said = self.expect(0, "check", "near.vug").err
        self.assertIn("unknown attribute 'windw'", said)
        self.assertIn("did you mean 'window'?", said)


if __name__ == "__main__":
    unittest.main()
