# SPDX-License-Identifier: Apache-2.0
"""Two readers of USD, tinyusdz and three.js, find everything that a scene shows, in the right place."""
import json
import math
import pathlib
import re
import shutil
import unittest

from external_tools import SCENE, VugTest, node, require_node

# Metres per unit, and whether z is up.
SPACES = {"usd": (1, False), "maya": (0.01, False), "unreal": (0.01, True)}

# A box of two rocks, whose mesh has a subset for each of them.
ROCKS = """let beds = [made_of(slab(thickness: 40cm).translate((0, 0.5, 0)), of: "chert")]
let layered = host_rock(box(size: (1, 1, 1)).translate((5, 0.5, 2)), of: "limestone", bodies: beds, contact: 8cm)
volume bank = level_set(layered, voxel: 10cm)
mesh bank on bank {}
object bank on bank {}
"""


def prims(text):
    """[(type, name)] of every prim in the output of tinyusdz."""
    return re.findall(r'def (\w+) "([^"]+)"', text)


def block(text, kind, name):
    """The lines of a prim up to its end."""
    begin = re.search(rf'^( *)def {kind} "{name}"', text, re.M)
    return text[begin.start():text.index("\n" + begin.group(1) + "}", begin.start())]


def numbers(text, name):
    found = re.search(rf"\b{re.escape(name)} = (.*)", text).group(1)
    return [float(n) for n in re.findall(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?", found)]


def contents(text):
    """The lines in the output of tinyusdz without differences that have no meaning: the extension of
    layers in payloads, and brackets around a single target, which binary files do not have.
    tinyusdz omits the properties of variants in binary files, such as vug:distance; tests/unit/exchange/usdc_test.cpp reads them."""
    text = re.sub(r"\.usdc@", ".usda@", text)
    text = re.sub(r"= \[(<[^<>]*>)\]", r"= \1", text)
    return [line for line in text.splitlines() if "vug:distance" not in line]


def flat(value):
    """All numbers in nested lists."""
    return [number for each in value for number in flat(each)] if isinstance(value, list) else [value]


class Usd(VugTest):
    def prepare(self):
        self.write("all.vug", SCENE)
        for program in SPACES:
            self.expect(0, "export", "all.vug", "-o", program, "--for", program, "-q")

    def read(self, program):
        return node("read_usd.mjs", self.folder / program / "all.usda")

    def test_tinyusdz_finds_everything(self):
        for program, (unit, turned) in SPACES.items():
            text = self.read(program)["tinyusdz"]
            kinds = [kind for kind, _ in prims(text)]
            expected = {"Mesh": 2, "PointInstancer": 1, "Volume": 3, "OpenVDBAsset": 3, "Camera": 2,
                        "Material": 2, "SphereLight": 2, "RectLight": 1, "DiskLight": 1,
                        "DistantLight": 1, "DomeLight": 1}
            self.assertEqual({kind: kinds.count(kind) for kind in expected}, expected, program)
            self.assertAlmostEqual(numbers(text, "metersPerUnit")[0], unit)
            self.assertIn(f'upAxis = "{"Z" if turned else "Y"}"', text)
            for name in ("rock", "stone", "mist"):
                grid = "density" if name == "mist" else "surface"
                asset = block(block(text, "Volume", name), "OpenVDBAsset", grid)
                self.assertIn(f"@./all_{name}.vdb@", asset)
                self.assertTrue((self.folder / program / f"all_{name}.vdb").exists())
            # The extent of the cube is one metre.
            box = numbers(block(text, "Xform", "wall"), "extent")
            for axis in range(3):
                self.assertAlmostEqual((box[3 + axis] - box[axis]) * unit, 1, delta=1e-4)
            self.assertEqual(len(numbers(block(text, "PointInstancer", "heap"), "positions")), 9)
            # 100 W from a ball of radius 10 cm.
            ball = block(text, "SphereLight", "ball")
            radius = numbers(ball, "inputs:radius")[0] * unit
            watts = 4 * math.pi**2 * radius**2 * numbers(ball, "inputs:intensity")[0]
            self.assertAlmostEqual(watts, 100, delta=0.01)

    def test_three_js_places_everything(self):
        # It converts every layer to metres with y up according to the layer's metadata.
        for program in SPACES:
            found = self.read(program)["three"]
            [wall] = [each for each in found if each["type"] == "Mesh" and each["parent"] == "wall"]
            for axis, (low, high) in enumerate([(0.5, 1.5), (0, 1), (1.5, 2.5)]):
                self.assertAlmostEqual(wall["box"][0][axis], low, delta=1e-3, msg=program)
                self.assertAlmostEqual(wall["box"][1][axis], high, delta=1e-3, msg=program)
            types = [each["type"] for each in found]
            expected = {"PerspectiveCamera": 1, "OrthographicCamera": 1, "DirectionalLight": 1,
                        "RectAreaLight": 2}  # three.js also represents a disk as one
            self.assertEqual({kind: types.count(kind) for kind in expected}, expected, program)
            [camera] = [each for each in found if each["type"] == "PerspectiveCamera"]
            for got, wanted in zip(camera["matrix"][12:15], (0, 2, 6)):
                self.assertAlmostEqual(got, wanted, delta=1e-4, msg=program)

    def test_levels_of_detail_are_variants(self):
        self.expect(0, "export", "all.vug", "-o", "levels", "--for", "usd", "--lod", "2", "-q")
        found = self.read("levels")
        for level in ("full", "lod1", "lod2"):
            self.assertIn(f'"{level}" {{', found["tinyusdz"])
        self.assertEqual(found["tinyusdz"].count('def Mesh "shape"'), 2 * 3)
        # The first level is the full mesh; each other level has about a quarter of the faces of the one before.
        sizes = [len(counts.split(",")) for counts in
                 re.findall(r"faceVertexCounts = (.*)", block(found["tinyusdz"], "Xform", "wall"))]
        whole = block(self.read("usd")["tinyusdz"], "Xform", "wall")
        self.assertEqual(sizes[0], len(numbers(whole, "faceVertexCounts")))
        for finer, coarser in zip(sizes, sizes[1:]):
            self.assertAlmostEqual(coarser / finer, 0.25, delta=0.01)


class TiledUsd(VugTest):
    """The USD layers of vug build --tiles --lods."""

    def prepare(self):
        self.write("cave.vug", "volume cave = level_set(displace(torus(radius: 2m, tube: 80cm), noise: "
                   "fbm(scale: 60cm, octaves: 3), amount: 20cm), voxel: 5cm)\nmesh cave on cave {}\n")
        self.expect(0, "build", "cave.vug", "-o", "out", "--tiles=64", "--lods", "2", "-q")

    def test_tinyusdz_opens_the_assembly_without_payloads(self):
        tiles = self.folder / "out" / "cave.tiles"
        index = json.loads((tiles / "index.json").read_text())["meshes"][0]["tiles"]
        self.assertGreaterEqual(len(index), 8)
        # A folder that contains nothing else.
        alone = self.folder / "alone"
        alone.mkdir()
        shutil.copy(tiles / "assembly.usda", alone)
        text = node("read_usd.mjs", alone / "assembly.usda", "layer")["tinyusdz"]
        kinds = prims(text)
        self.assertEqual(sum(kind == "Xform" for kind, _ in kinds), 1 + len(index))
        self.assertEqual(kinds.count(("Mesh", "proxy")), len(index))
        for tile in index:
            prim = block(text, "Xform", pathlib.Path(tile["usd"]).stem.replace("-", "_"))
            hint = numbers(prim, "extentsHint")
            self.assertEqual(len(hint), 18)
            for axis in range(3):
                self.assertAlmostEqual(hint[6 + axis], tile["bounds"]["min"][axis], delta=1e-5)
                self.assertAlmostEqual(hint[9 + axis], tile["bounds"]["max"][axis], delta=1e-5)
            for name in [tile["usd"]] + [level["usd"] for level in tile["levels"]]:
                self.assertIn(f"@./{name}@", prim)
            for level in ("full", "lod1", "lod2"):
                self.assertIn(f'"{level}"', prim)
            self.assertIn("vug:distance", prim)
            self.assertIn('"proxy"', prim)

    def test_tinyusdz_reads_the_layers_of_a_tile(self):
        tiles = self.folder / "out" / "cave.tiles"
        tile = json.loads((tiles / "index.json").read_text())["meshes"][0]["tiles"][0]
        for level in [tile] + tile["levels"]:
            text = node("read_usd.mjs", tiles / level["usd"], "layer")["tinyusdz"]
            shape = block(text, "Mesh", "shape")
            self.assertEqual(len(numbers(shape, "faceVertexCounts")), level["triangles"])
            self.assertEqual(len(numbers(shape, "points")), 3 * level["vertices"])
            self.assertIn('purpose = "render"', shape)


class BinaryUsd(VugTest):
    """The .usda and .usdc files of one scene are equal as read by both readers."""

    def prepare(self):
        self.write("all.vug", "param R = 30cm in 10cm..1m\n" + SCENE.replace("sphere(30cm)", "sphere(R)") + ROCKS +
                   "variant small { R 20cm }\nvariant large { R 40cm }\n")
        self.write("cave.vug", "volume cave = level_set(displace(torus(radius: 2m, tube: 80cm), noise: "
                   "fbm(scale: 60cm, octaves: 3), amount: 20cm), voxel: 5cm)\nmesh cave on cave {}\n")

    def export(self, *arguments):
        for layer in ("usda", "usdc"):
            self.expect(0, *arguments, "-o", layer, "--usd-format", layer, "-q")

    def expect_equal(self, name, *mode):
        """Both files of a name have the same prims, properties and values. Returns what three.js finds in them."""
        text, binary = (node("read_usd.mjs", self.folder / layer / f"{name}.{layer}", *mode)
                        for layer in ("usda", "usdc"))
        lines = [contents(each["tinyusdz"]) for each in (text, binary)]
        self.assertGreater(len(lines[0]), 20)
        self.assertEqual(*lines, name)
        return text["three"], binary["three"]

    def assert_same_scene(self, text, binary):
        self.assertEqual(len(text), len(binary))
        for one, other in zip(text, binary):
            self.assertEqual(one.keys(), other.keys())
            for key in one:
                if key in ("matrix", "box", "color", "intensity"):
                    for a, b in zip(flat(one[key]), flat(other[key]), strict=True):
                        self.assertAlmostEqual(a, b, delta=1e-6 * max(1, abs(a)), msg=one["name"])
                else:
                    self.assertEqual(one[key], other[key])

    def test_all_kinds_of_prims(self):
        for program in SPACES:
            self.export("export", "all.vug", "--for", program)
            text, binary = self.expect_equal("all")
            self.assertGreater(len(text), 20)
            self.assert_same_scene(text, binary)

    def test_levels_and_variants(self):
        # three.js shows the selected variants of binary files only, not those of text.
        self.export("export", "all.vug", "--lod", "2")
        text, binary = self.expect_equal("all")
        self.assertEqual([each["name"] for each in binary if each["type"] == "Mesh"], ["shape"] * 3)
        self.export("export", "all.vug", "--variants")
        text, binary = self.expect_equal("all")
        names = [each["name"] for each in text]
        shown = [each["name"] for each in binary]
        self.assertEqual(sorted(set(names) - set(shown)), [])
        self.assertIn("heap", shown)

    def test_tiles(self):
        self.export("build", "cave.vug", "--tiles=64", "--lods", "2")
        self.expect_equal("cave.tiles/assembly", "layer")
        index = json.loads((self.folder / "usdc/cave.tiles/index.json").read_text())
        self.assertEqual(index["usd"], "assembly.usdc")
        for tile in index["meshes"][0]["tiles"][:2]:
            for level in [tile] + tile["levels"]:
                self.expect_equal("cave.tiles/" + pathlib.Path(level["usd"]).stem, "layer")

    def test_threads_do_not_change_a_byte(self):
        for threads in (1, 2, 7):
            self.expect(0, "export", "all.vug", "-o", f"t{threads}", "--usd-format", "usdc", "-q",
                        "--threads", threads, "--no-cache")
        files = [(self.folder / f"t{threads}/all.usdc").read_bytes() for threads in (1, 2, 7)]
        self.assertEqual(files[0], files[1])
        self.assertEqual(files[0], files[2])


if __name__ == "__main__":
    require_node()
    unittest.main()
