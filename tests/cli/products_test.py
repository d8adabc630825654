# SPDX-License-Identifier: Apache-2.0
"""Output and files of the verbs list, info, tree, format, sweep, measure and build."""
import json
import math
import struct
import unittest
import xml.etree.ElementTree as xml

from vug import BALL, SOURCE, VugTest

CAVE = """seed 3
param R = 1m  in 50cm..2m  "radius of a room"

grammar cave {
  axiom Room*2 Melt
  Room -> + sphere(R) label +X
  Melt -> ~ 50% box() label +Y
}

volume rock = level_set(cave, voxel: 20cm)
volume mist = fog(sphere(R), voxel: 20cm)
mesh wall on rock { paint (0.5, 0.4, 0.3) }
"""
TWO_TREES = """
grammar hall {
  axiom Room*3
  Room -> + sphere(1m) label +X
}
grammar way {
  axiom Step
  Step -> + box()
}
volume rock = level_set(hall + way, voxel: 20cm)
"""


class List(VugTest):
    def test_everything(self):
        text = self.expect(0, "list").out
        kinds = json.loads(self.expect(0, "list", "--json").out)
        self.assertGreater(len(kinds), 60)
        for kind in kinds:
            self.assertIn(f"  {kind['name']} ", text)
            self.assertTrue(kind["doc"], kind)
            for param in kind["params"]:
                self.assertTrue(param["type"], kind["name"])
        categories = {kind["category"] for kind in kinds}
        self.assertLessEqual({"declaration", "primitive", "operator", "deformer"}, categories)
        for category in ["primitive", "light"]:
            listed = json.loads(self.expect(0, "list", category, "--json").out)
            self.assertEqual([k["name"] for k in kinds if category in (k["category"], k["name"])],
                             [k["name"] for k in listed])

    def test_search(self):
        """Descriptions and synonyms, in any case."""
        for words, found in ((["flowstone"], "dripstone"), (["HDRI"], "sky_image"), (["hdri"], "sky_image"),
                             (["AOV"], "CryptoObject"), (["wet", "rock"], "coated"), (["wet rock"], "coated"),
                             (["god rays"], "haze"), (["point light"], "sphere")):
            self.assertRegex(self.expect(0, "list", *words).out, rf"\n  {found} ", words)
        self.assertEqual([k["name"] for k in json.loads(self.expect(0, "list", "HDRI", "--json").out)],
                         ["sky_image"])
        error = self.expect(2, "list", "antimatter").err
        self.assertEqual(error, "error: no kind, description or synonym contains 'antimatter'\n"
                                "hint: 'vug list' lists all of them\n")

    def test_each_kind_has_an_example(self):
        self.assertTrue(self.expect(0, "list", "torus").out.endswith(
            "\nexample:\n  field shape = torus(radius: 1m, tube: 20cm)\n"))
        self.assertIn("\nexample:\n  mesh painted on cave {\n    paint layer(", self.expect(0, "list", "slope").out)
        kinds = json.loads(self.expect(0, "list", "--json").out)
        self.assertEqual([kind["name"] for kind in kinds if not kind["example"]], [])
        self.assertIn("environment map", next(k for k in kinds if k["name"] == "sky_image")["synonyms"])

    def test_aovs(self):
        text = self.expect(0, "list", "aov").out
        self.assertRegex(text, r"\n  N +Normal of .*Channels N.X, N.Y, N.Z, written by default\.\n")
        self.assertRegex(text, r"\n  light_NAME .*\"lights\" requests all of them\.\n")
        self.assertIn("\n  wetness ", text)

    def test_one_kind(self):
        text = self.expect(0, "list", "torus").out
        self.assertIn("torus (primitive): ", text)
        self.assertRegex(text, r"\n  tube +number \(length\), above 0, default 0.25m")
        [torus] = json.loads(self.expect(0, "list", "torus", "--json").out)
        self.assertEqual(torus["cite"], "hart1996")
        self.assertEqual([p["name"] for p in torus["params"]], ["radius", "tube"])
        self.assertEqual(torus["params"][1],
                         {"name": "tube", "type": "number",
                          "doc": "radius of the tube, at most the radius",
                          "dimension": "length", "unit": "m", "default": "0.25m", "above": 0.0})

    def test_declarations(self):
        text = self.expect(0, "list", "camera").out
        self.assertIn("camera (declaration): ", text)
        self.assertRegex(text, r"\n  kind +one of orthographic, panoramic, perspective, default perspective; ")
        self.assertRegex(text, r"\n  eye +vector \(length\), default \(0, 0, 5m\); ")
        self.assertRegex(text, r"\n  fov +number \(angle\), .*, default 60deg; ")
        self.assertRegex(self.expect(0, "list", "volume").out, r"\n  voxel +number \(length\), above 0, ")
        self.assertRegex(self.expect(0, "list", "light").out, r"\n  kind +one of .*rect.*, required; ")
        self.assertRegex(self.expect(0, "list", "grammar").out, r"\n  overlap +number \(ratio\), at least 0, at most 100%, ")
        for kind in json.loads(self.expect(0, "list", "declaration", "--json").out):
            self.assertTrue(kind["params"], kind["name"])

    def test_a_name_of_two_kinds_shows_both(self):
        kinds = json.loads(self.expect(0, "list", "sphere", "--json").out)
        self.assertEqual([k["category"] for k in kinds], ["primitive", "light"])

    def test_every_citation_has_an_entry(self):
        entries = (SOURCE / "docs" / "references.bib").read_text()
        for kind in json.loads(self.expect(0, "list", "--json").out):
            if "cite" in kind:
                self.assertIn("{" + kind["cite"] + ",", entries, kind["name"])


class Info(VugTest):
    def prepare(self):
        self.write("cave.vug", CAVE)
        self.expect(0, "build", "cave.vug", "-o", "out")

    def info(self, file):
        return json.loads(self.expect(0, "info", file, "--json").out)

    def test_grids(self):
        about = self.info("out/cave.vdb")
        self.assertEqual(about["type"], "vdb")
        self.assertEqual(about["bytes"], (self.folder / "out/cave.vdb").stat().st_size)
        self.assertEqual([(g["name"], g["class"], g["type"]) for g in about["grids"]],
                         [("rock", "level set", "float"), ("mist", "fog volume", "float")])
        rock = about["grids"][0]
        self.assertEqual(rock["voxel_size"], [0.2, 0.2, 0.2])
        self.assertGreater(rock["active_voxels"], 100)
        data = {**about["metadata"], **rock["metadata"]}
        self.assertEqual(data["vug:recipe"], CAVE)
        self.assertEqual(data["vug:seed"], 3)
        self.assertEqual(data["vug:metersPerUnit"], 1)
        self.assertEqual(data["vug:upAxis"], "y")
        self.assertIn("vug:version", data)

    def test_the_recipe_builds_the_same_file(self):
        self.expect(0, "build", "cave.vug", "-o", "again", "-D", "R=80cm", "--seed", "5")
        self.write("cave.vug", self.info("again/cave.vdb")["metadata"]["vug:recipe"])
        recipe = (self.folder / "cave.vug").read_text()
        self.assertTrue(recipe.endswith("# -D R=80cm\n# --seed 5\n"), recipe)

    def test_meshes(self):
        about = self.info("out/cave.ply")
        report = json.loads(self.expect(0, "measure", "out/cave.ply", "--json").out)
        self.assertEqual(about["type"], "mesh")
        self.assertEqual(about["vertices"], report["vertices"])
        self.assertEqual(about["triangles"], report["triangles"])
        self.assertEqual(about["attributes"], ["N 3", "Cd 3"])

    def test_pictures(self):
        self.expect(0, "render", "cave.vug", "-o", "a.exr", "--size", "12x10", "--spp", "1")
        about = self.info("a.exr")
        self.assertEqual((about["type"], about["width"], about["height"]), ("picture", 12, 10))
        self.assertEqual(about["metadata"]["vug:spp"], "1")
        self.assertIn("R half", about["channels"])
        self.assertEqual((self.info("a.png")["width"], self.info("a.png")["height"]), (12, 10))

    def test_text_for_people(self):
        text = self.expect(0, "info", "out/cave.vdb").out
        self.assertIn("  name: rock\n", text.replace("    ", "  "))
        self.assertNotIn("axiom", text)  # only the first line of each long text


class Tree(VugTest):
    def setUp(self):
        super().setUp()
        self.write("cave.vug", CAVE)

    def test_text(self):
        lines = self.expect(0, "tree", "cave.vug").out.splitlines()
        self.assertEqual(lines[0].split()[0], "cave")
        self.assertEqual(len(lines), 1 + 3 + 3)  # the grammar, its symbols, their shapes
        self.assertEqual(sum("Room" in line for line in lines), 2)

    def test_json(self):
        tree = json.loads(self.expect(0, "tree", "cave.vug", "--json").out)
        self.assertEqual(tree["applied"], 3)
        self.assertEqual(tree["nodes"][0]["symbol"], "cave")
        shapes = [n for n in tree["nodes"] if n.get("terminal")]
        self.assertEqual([n["text"] for n in shapes], ["+ sphere", "+ sphere", "~ 50% box"])
        for node in tree["nodes"][1:]:
            self.assertIn(node["id"], tree["nodes"][node["parent"]]["children"])

    def test_svg(self):
        root = xml.fromstring(self.expect(0, "tree", "cave.vug", "--svg").out)
        self.assertTrue(root.tag.endswith("svg"))
        texts = ["".join(t.itertext()) for t in root.iter("{http://www.w3.org/2000/svg}text")]
        self.assertEqual(sum("sphere" in t for t in texts), 2)

    def test_one_of_two_grammars(self):
        self.write("two.vug", TWO_TREES)
        self.assertIn("name one with --grammar", self.expect(2, "tree", "two.vug", "--json").err)
        text = self.expect(0, "tree", "two.vug", "--grammar", "way").out
        self.assertIn("box", text)
        self.assertNotIn("sphere", text)
        self.assertIn("did you mean 'way'?",
                      self.expect(2, "tree", "two.vug", "--grammar", "wai").err)

    def test_the_seed_decides(self):
        self.write("chance.vug", "grammar g {\n  axiom A*20\n  A -> + sphere(1m)\n  A -> + box()\n}\n"
                                 "volume v = level_set(g, voxel: 1m)\n")
        trees = [self.expect(0, "tree", "chance.vug", "--seed", s).out for s in (1, 1, 2)]
        self.assertEqual(trees[0], trees[1])
        self.assertNotEqual(trees[0], trees[2])


class Format(VugTest):
    UGLY = "let   a=1 + 2 # three\nvolume rock=level_set( sphere(a) ,voxel:10cm )\n"

    def test_prints_and_writes(self):
        path = self.write("a.vug", self.UGLY)
        shown = self.expect(0, "format", "a.vug").out
        self.assertEqual(shown, "let a = 1 + 2  # three\n"
                                "volume rock = level_set(sphere(a), voxel: 10cm)\n")
        self.assertEqual(path.read_text(), self.UGLY)
        self.assertEqual(self.expect(0, "format", "-w", "a.vug").out, "")
        self.assertEqual(path.read_text(), shown)
        self.assertEqual(self.expect(0, "format", "--check", "a.vug").out, "")

    def test_a_faulty_text_stays_as_it_is(self):
        path = self.write("a.vug", "volume = = (\n")
        for args in [("-w", "a.vug"), ("a.vug",), ("--check", "a.vug")]:
            self.assertIn("a.vug:1:1: error: ", self.expect(2, "format", *args).err)
        self.assertEqual(path.read_text(), "volume = = (\n")

    def test_our_scenes_are_formatted(self):
        self.expect(0, "format", "--check", *sorted((SOURCE / "data").rglob("*.vug")))


class Sweep(VugTest):
    def test_table_and_plot(self):
        self.write("ball.vug", "param R = 1m\n" + BALL.replace("1m", "R"))
        text = self.expect(0, "sweep", "ball.vug", "-p", "R", "-v", "1,2,3", "-o", "out/ball").out
        self.assertEqual((self.folder / "out/ball.csv").read_text(), text)
        head, *rows = [line.split(",") for line in text.splitlines()]
        self.assertEqual(head[:2], ["R", "seconds"])
        self.assertEqual([row[0] for row in rows], ["1", "2", "3"])
        for radius, row in zip((1, 2, 3), rows):
            values = dict(zip(head, row))
            area, volume = 4 * math.pi * radius**2, 4 / 3 * math.pi * radius**3
            # A mesh of triangles of edge h lies inside the ball by about h^2 / 8R.
            self.assertAlmostEqual(float(values["area"]) / area, 1, delta=0.01 / radius)
            self.assertAlmostEqual(float(values["volume"]) / volume, 1, delta=0.01 / radius)
            self.assertEqual((values["components"], values["genus"]), ("1", "0"))
        plot = xml.fromstring((self.folder / "out/ball.svg").read_text())
        lines = list(plot.iter("{http://www.w3.org/2000/svg}polyline"))
        self.assertEqual([len(line.get("points").split()) for line in lines], [3, 3, 3, 3])

    def test_values_with_units_and_faults(self):
        self.write("ball.vug", "param R = 1m in 1m..2m\n" + BALL.replace("1m", "R"))
        text = self.expect(0, "sweep", "ball.vug", "-p", "R", "-v", "100cm,2m").out
        self.assertEqual([line.split(",")[0] for line in text.splitlines()], ["R", "100cm", "2m"])
        error = self.vug("sweep", "ball.vug", "-p", "R", "-v", "1,5", "-o", "out/a").err
        self.assertIn("param 'R' is 5m, outside 1m..2m", error)
        self.assertIn("\n  while checking R = 5\n", error)
        self.assertEqual(self.files(), ["ball.vug"])

    def test_results_before_an_error_are_kept(self):
        self.write("many.vug", "param R = 1m\nvolume rock = level_set(sphere(R), voxel: 10cm)\n")
        result = self.vug("sweep", "many.vug", "-p", "R", "-v", "1,2,1e6,1.5", "--max-memory", "1G", "-o", "out/a")
        self.assertEqual(result.code, 2)
        self.assertEqual([line.split(",")[0] for line in result.out.splitlines()], ["R", "1", "2"])
        self.assertEqual((self.folder / "out/a.csv").read_text(), result.out)
        self.assertIn("  while measuring R = 1e6\n", result.err)
        self.assertIn("\nthe table contains the first 2 of 4 values\n", result.err)


class Measure(VugTest):
    KEYS = ["area", "volume", "volume_cells", "cf", "cf_area", "vertices", "triangles",
            "productions", "build_seconds", "components", "genus", "boundary_edges",
            "nonmanifold_edges", "zero_area_triangles", "self_intersections", "bounds"]

    def test_the_keys_that_scripts_rely_on(self):
        self.write("cave.vug", CAVE)
        self.expect(0, "build", "cave.vug", "-o", "out")
        scene = json.loads(self.expect(0, "measure", "cave.vug", "--json").out)
        for key in self.KEYS:
            self.assertIsNotNone(scene[key], key)
        self.assertEqual(scene["productions"], 3)
        file = json.loads(self.expect(0, "measure", "out/cave.ply", "--json").out)
        grid = json.loads(self.expect(0, "measure", "out/cave.vdb", "--json").out)
        for key in self.KEYS:
            self.assertIn(key, file)
            self.assertIn(key, grid)
        for key in ["area", "volume", "vertices", "triangles", "components", "genus", "bounds"]:
            self.assertEqual(scene[key], file[key], key)
        table = self.expect(0, "measure", "cave.vug").out
        for key in self.KEYS:
            self.assertRegex(table, rf"(?m)^{key} +\S")

    def test_a_torus(self):
        self.write("ring.vug", "volume ring = level_set(torus(radius: 1m, tube: 30cm), voxel: 5cm)\n")
        report = json.loads(self.expect(0, "measure", "ring.vug", "--json").out)
        self.assertEqual((report["components"], report["genus"]), (1, 1))
        self.assertAlmostEqual(report["volume"] / (2 * math.pi**2 * 0.09), 1, delta=0.02)
        self.assertAlmostEqual(report["area"] / (4 * math.pi**2 * 0.3), 1, delta=0.02)

    def test_one_of_several_meshes(self):
        self.write("two.vug", BALL + "volume block = level_set(box(size: (1, 1, 1)), voxel: 10cm)\n"
                              "mesh a on rock {}\nmesh b on block {}\n")
        volumes = [json.loads(self.expect(0, "measure", "two.vug", "--json", "--mesh", m).out)["volume"]
                   for m in "ab"]
        self.assertGreater(volumes[0], 4)
        self.assertAlmostEqual(volumes[1], 1, delta=1e-3)


class Check(VugTest):
    def test_json(self):
        self.write("ball.vug", BALL)
        self.assertEqual(json.loads(self.expect(0, "check", "ball.vug", "--json").out),
                         {"file": "ball.vug", "fine": True, "diagnostics": []})
        self.write("ball.vug", BALL.replace("1m", "raduis: 1m"))
        result = self.vug("check", "ball.vug", "--json")
        self.assertEqual((result.code, result.err), (2, ""))
        self.assertEqual(json.loads(result.out)["diagnostics"],
                         [{"severity": "error", "file": "ball.vug", "line": 1, "column": 32,
                           "end_line": 1, "end_column": 38, "message": "'sphere' has no parameter 'raduis'",
                           "hint": "did you mean 'radius'?"}])

    def test_one_name_for_declarations_of_several_kinds(self):
        self.write("shot.vug", BALL + "mesh main on rock {}\ncamera main { eye (0, 0, 5) }\n"
                                      "render main { size 8x4  spp 1  camera main }\n")
        self.assertIn("1 volume, 1 mesh, 0 objects, 0 places, 0 lights, 1 camera, 1 render",
                      self.expect(0, "check", "shot.vug").out)


class Build(VugTest):
    def test_formats_and_names(self):
        self.write("ball.vug", BALL + "mesh a on rock { format obj }\nmesh b on rock { format stl }\n")
        built = self.expect(0, "build", "ball.vug", "-o", "new/folder")
        self.assertEqual(built.out.split(),
                         [f"new/folder/{n}" for n in ("ball.vdb", "ball_a.obj", "ball_b.stl")])
        stl = (self.folder / "new/folder/ball_b.stl").read_bytes()
        [triangles] = struct.unpack_from("<I", stl, 80)
        self.assertEqual(len(stl), 84 + 50 * triangles)
        obj = (self.folder / "new/folder/ball_a.obj").read_text()
        self.assertEqual(sum(line.startswith("f ") for line in obj.splitlines()), triangles)

    def test_overrides(self):
        self.write("ball.vug", "param R = 1m\n" + BALL.replace("1m", "R"))
        sizes = []
        for override in [(), ("-D", "R=2"), ("-D", "R=200cm")]:
            report = self.expect(0, "measure", "ball.vug", "--json", *override).out
            sizes.append(round(json.loads(report)["bounds"][1][0], 1))
        self.assertEqual(sizes, [1, 2, 2])
        self.expect(2, "measure", "ball.vug", "-D", "R=2", "-D", "R=1")

    def test_files_of_a_scene_are_relative_to_it(self):
        self.write("shot/ball.vug", BALL)
        self.write("shot/use.vug", 'include "lib.vug"\n'
                                   "volume v = level_set(mesh(file: \"out/ball.ply\") + more, voxel: 20cm)\n")
        self.write("shot/lib.vug", "let more = box().translate((2, 0, 0))\n")
        self.write("shot/ball.vug", BALL + "mesh wall on rock {}\n")
        self.expect(0, "build", "shot/ball.vug", "-o", "shot/out")
        self.expect(0, "measure", "shot/use.vug")
        self.expect(0, "measure", "use.vug", cwd=self.folder / "shot")


if __name__ == "__main__":
    unittest.main()
