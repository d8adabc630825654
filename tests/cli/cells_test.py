# SPDX-License-Identifier: Apache-2.0
"""Cells in a scene: errors with their locations, outputs, the same bytes for any number of threads."""
import json
import unittest

import exr
from vug import VugTest, digest

SCENE = """volume rock = level_set(sphere(1m), voxel: 10cm)
mesh wall on rock {}
render main { size 16x12  spp 1 }
cells skin on %s { %s }
"""
GOOD = ("spacing 15cm  grid triangle  relax 3  run random_color(share: 10%), voronoi, crack(begin: 10), "
        "corrosion(begin: 20, loss: 10%, where: slope(from: 40deg, to: 70deg)), sprinkle(attribute: \"wet\")")


class Cells(VugTest):
    def refused(self, block, column, message, hint, on="wall", *args):
        self.write("s.vug", SCENE % (on, block))
        error = self.expect(2, "render", "s.vug", "-o", "s.exr", *args).err
        self.assertIn(f"s.vug:4:{column}: error: {message}", error)
        self.assertIn(f"hint: {hint}", error)
        self.assertEqual(error.count("error: "), 1, error)
        self.assertEqual(self.files(), ["s.vug"])

    def test_errors_in_the_text(self):
        at = len("cells skin on wall { ") + 1
        run = at + len("spacing 20cm  run ")
        self.refused("spacing 20cm  run vornoi", run, "there is no rule 'vornoi'", "did you mean 'voronoi'?")
        self.refused("spacing 20cm  run vornoi()", run, "unknown function 'vornoi'", "did you mean 'voronoi'?")
        self.refused("spacing 20cm  grid trangle  run maze", at + len("spacing 20cm  grid "), "there is no grid 'trangle'",
                     "did you mean 'triangle'?")
        self.refused("spacing 20cm  run maze", 15, "'cells' expects a mesh or level set after 'on', not the name 'wal'", "did you mean 'wall'?", "wal")
        for spacing in ("0", "0cm", "-2cm"):
            self.refused(f"spacing {spacing}  run maze", at, "the spacing of cells must be a length above 0", "for instance: spacing 2cm")
        self.refused("spacing 20cm", 7, "'cells' needs 'run'", "run: rules")
        self.refused("run maze", 7, "'cells' needs 'spacing'", "spacing: ")

    def test_unknown_attributes(self):
        at = len("cells skin on wall { spacing 20cm  run ") + 1
        first = "crack, corrosion(where: attribute(name: "
        self.refused(f'spacing 20cm  run {first}"crak"))', at + len(first) - len("name: "), "no rule of 'skin' creates an attribute 'crak'",
                     "did you mean 'crack'?")
        for rule in ('life, freeze(attribute: "aliv")', 'life, set(attribute: "lit", to: multiply([value(name: "aliv"), slope()]))'):
            self.write("s.vug", SCENE % ("wall", f"spacing 20cm  run {rule}"))
            error = self.expect(2, "check", "s.vug").err
            self.assertIn("no rule of 'skin' creates an attribute 'aliv'", error)
            self.assertIn("hint: did you mean 'alive'?", error)
            self.assertEqual(error.count("error: "), 1, error)
        self.write("s.vug", SCENE % ("wall", 'spacing 20cm  run sprinkle(attribute: "alive"), life'))
        self.assertIn("error: the attribute 'alive' is a number, not a whole number", self.expect(2, "check", "s.vug").err)

    def test_names_that_files_cannot_store(self):
        for name in ("my wet part", "", "2nd", "id", "x"):
            self.refused(f'spacing 20cm  run set(attribute: "{name}", to: 0.3)', 7, "", "use letters, digits and _")

    def test_whole_numbers_of_steps(self):
        self.write("s.vug", SCENE % ("wall", "spacing 20cm  run life  steps 2.5"))
        self.assertIn("s.vug:4:46: error: 'steps' expects a whole number, not 2.5", self.expect(2, "check", "s.vug").err)

    def test_a_misspelt_attribute_in_a_material_is_a_warning(self):
        for name, hint in (("crak", "did you mean 'crack'?"), ("crack", None), ("my_own", "known attributes: Cd, "), ('my_own", otherwise: "1', None)):
            material = f'material surface(color: layer(under: (1, 1, 1), over: (0, 0, 0), mask: attribute(name: "{name}")))'.replace('"1"', "1")
            self.write("s.vug", SCENE % ("wall", GOOD) + "object stone on skin { " + material + " }\n")
            error = self.expect(0, "check", "s.vug").err
            self.assertEqual(f"warning: unknown attribute '{name}'" in error, hint is not None, error)
            self.assertIn(f"hint: {hint}" if hint else "", error)

    def test_attributes_of_included_materials_may_belong_to_other_scenes(self):
        self.write("look.vug", 'material odd = surface(color: layer(under: (1, 1, 1), over: (0, 0, 0), mask: attribute(name: "my_own")))\n')
        self.write("s.vug", SCENE % ("wall", GOOD) + 'include "look.vug"\nobject stone on skin { material odd }\n')
        self.assertNotIn("warning", self.expect(0, "check", "s.vug").err)

    def test_a_misspelt_attribute_in_a_layer_is_a_warning(self):
        for name, told in (("crak", True), ("crack", False), ("my_own", True)):
            self.write("s.vug", SCENE % ("wall", GOOD) + 'render more { layers ["beauty", "attribute_%s"] }\n' % name)
            self.assertEqual(f"warning: unknown attribute '{name}'" in self.expect(0, "check", "s.vug").err, told, name)

    def test_cells_do_not_make_a_mesh_intersect_itself(self):
        # Two balls grow into each other at their intersection.
        for height in (0.5, -0.05):
            scene = SCENE.replace("sphere(1m)", "sphere(1m) + sphere(1m).translate((1.4, 0, 0))")
            self.write("s.vug", scene % ("wall", f'spacing 10cm  steps 1  run set(attribute: "height", to: {height})'))
            report = json.loads(self.expect(0, "measure", "s.vug", "--json").out)
            for fault in ("self_intersections", "folded_triangles", "zero_area_triangles"):
                self.assertEqual(report[fault], 0, (height, fault))

    def test_a_diverging_surface_is_rejected(self):
        self.refused('spacing 20cm  steps 1  run set(attribute: "height", to: 1000000)', 7, "cells displace the surface by up to 1e+06 m",
                     "'height' is in metres; 'move false' turns the displacement off")

    def test_a_vanished_surface_causes_a_warning(self):
        self.write("s.vug", SCENE % ("wall", 'spacing 20cm  holes true  steps 2  run set(attribute: "k", to: 1), '
                                             'freeze(attribute: "k", above: 0.5, as: transparent)'))
        self.assertIn("warning: nothing remains of the mesh 'skin'", self.expect(0, "build", "s.vug", "-o", "out").err)

    def test_cells_that_cannot_be_scattered_anew(self):
        for block in ("spacing 20cm  rescatter 2  move false  run maze", 'spacing 20cm  rescatter 2  from "x.vdb"  run maze'):
            self.refused(block, 7, "'rescatter' needs cells that move one mesh of a level set, without 'from'", "remove 'rescatter'")

    def test_water_that_enters_nowhere(self):
        dry = 'set(attribute: "source", to: 0)'
        self.refused(f"spacing 20cm  run {dry}, calcite(steps: 1)", 7, "no water enters: the attribute 'source' is 0 in all cells", "set 'source' above 0")
        self.refused(f"spacing 20cm  run {dry}, film", 7, "no water enters: the attribute 'source' is 0 in all cells", "set 'source' above 0")
        self.refused("spacing 20cm  run calcite(years: 1000000, steps: 1)", 7, "in a step of 1e+06 years more than", "use fewer 'years'")

    def test_points_beyond_the_end(self):
        self.write("s.vug", SCENE % ("wall", "spacing 20cm  steps 5  run life"))
        self.expect(0, "build", "s.vug", "-o", "out")
        self.write("t.vug", SCENE % ("wall", 'spacing 20cm  steps 3  from "out/s_skin.vdb"  run life'))
        self.assertIn("the points are already at step 5, but the run ends at step 3", self.expect(2, "build", "t.vug", "-o", "more").err)

    def test_exposure_is_computed_where_it_is_named(self):
        rule = 'spacing 20cm  run set(attribute: "light", to: value(name: "exposure"))'
        for block, there in ((rule, True), ("spacing 20cm  run moisture", False), ("spacing 20cm  run dust(shelter: 50%)", True)):
            self.write("s.vug", SCENE % ("wall", block))
            self.expect(0, "build", "s.vug", "-o", "out")
            head = (self.folder / "out/s.ply").read_bytes().split(b"end_header")[0].decode()
            self.assertEqual("property float exposure\n" in head, there, block)

    def test_invalid_numbers(self):
        for spacing in ("1m * log(-1)", "1m * (0 / 0)", "1m / 0"):
            self.write("s.vug", SCENE % ("wall", f"spacing {spacing}  run maze"))
            error = self.expect(2, "check", "s.vug").err
            self.assertRegex(error, r"^s\.vug:4:\d+: error: ")
            self.assertEqual(error.count("error: "), 1, error)

    def test_attributes_on_the_mesh(self):
        at = len("cells skin on wall { ") + 1
        self.refused("spacing 10m  run maze", at, "cells 10 m apart are larger than the object", "use a smaller spacing")
        self.refused("spacing 1e-6m  run maze", at, "1.34e+13 cells are more than can be indexed", "use a larger spacing")
        self.refused("spacing 0.5mm  run maze", at, "5.37e+07 cells would take about 18 GiB", "use a larger spacing", "wall",
                     "--max-memory", "300M")

    def test_objects_without_a_mesh_get_no_cell_attributes(self):
        self.write("s.vug", SCENE % ("wall", GOOD) + "object ball on skin { direct true }\n")
        self.assertIn("s.vug:5:8: error: 'ball' has a cell layer", self.expect(2, "check", "s.vug").err)

    def test_the_mesh_is_written_with_cell_attributes(self):
        self.write("s.vug", SCENE % ("wall", GOOD))
        self.expect(0, "build", "s.vug", "-o", "out")
        self.assertEqual(self.files(), ["out/s.ply", "out/s.vdb", "out/s_skin.vdb", "s.vug"])
        head = (self.folder / "out/s.ply").read_bytes().split(b"end_header")[0].decode()
        for name in ("red", "seed", "crack", "potential", "wet", "transparent"):
            self.assertIn(f"property float {name}\n", head)
        self.write("two.vug", (SCENE % ("wall", GOOD)) + "cells film on skin { spacing 30cm  run sprinkle(attribute: \"dust\") }\n"
                   "object ball on film {}\n")
        self.expect(0, "build", "two.vug", "-o", "two")
        self.assertEqual(sorted(p.name for p in (self.folder / "two").iterdir()), ["two.ply", "two.vdb", "two_film.vdb", "two_skin.vdb"])
        head = (self.folder / "two/two.ply").read_bytes().split(b"end_header")[0].decode()
        self.assertIn("property float dust\n", head)
        self.assertIn("property float crack\n", head)

    def test_evenness_is_measured(self):
        self.write("s.vug", SCENE % ("wall", "spacing 12cm  harmonise squared  run corrosion(share: 20%, loss: 100%)"))
        report = json.loads(self.expect(0, "measure", "s.vug", "--cells", "skin", "--json").out)
        self.assertEqual(report["on"], {"wall": report["cells"]})
        self.assertAlmostEqual(report["cells"], 4 * 3.14159 / 0.12 ** 2, delta=0.1 * report["cells"])
        self.assertEqual(report["components"], 1)
        self.assertEqual(sum(report["links"].values()), report["cells"])
        self.assertEqual(sum(report["states"].values()), report["cells"])
        self.assertGreaterEqual(report["five_to_seven"], 0.97)
        self.assertEqual(len(report["harmonising"]), 30)
        self.assertLess(report["variation"], 0.6 * report["harmonising"][0]["variation"])
        self.write("p.vug", SCENE % ("wall", "spacing 12cm  harmonise paper  run corrosion(share: 20%, loss: 100%)"))
        paper = json.loads(self.expect(0, "measure", "p.vug", "--cells", "skin", "--json").out)
        self.assertGreater(paper["variation"], report["variation"])
        self.assertIn("five_to_seven: ", self.expect(0, "measure", "s.vug", "--cells", "skin").out)
        self.assertIn("did you mean 'skin'?", self.expect(2, "measure", "s.vug", "--cells", "skim").err)
        self.assertIn("--cells requires a scene", self.expect(2, "measure", "s.ply", "--cells", "skin").err)

    def test_several_objects(self):
        self.write("s.vug", SCENE.replace("render", "volume other = level_set(box(size: (2, 0.4, 2)).translate((0, -1, 0)), voxel: 10cm)\n"
                                          "render") % ("wall, other", "spacing 15cm  run sprinkle(attribute: \"wet\")"))
        self.expect(0, "build", "s.vug", "-o", "out")
        self.assertEqual(self.files(), ["out/s.vdb", "out/s_skin.vdb", "out/s_skin_other.ply", "out/s_skin_wall.ply", "s.vug"])
        for name in ("wall", "other"):
            self.assertIn(b"property float wet\n", (self.folder / f"out/s_skin_{name}.ply").read_bytes())

    def test_meshes_from_files(self):
        self.write("ball.vug", "volume rock = level_set(sphere(1m), voxel: 10cm)\nmesh wall on rock { format obj }\n")
        self.expect(0, "build", "ball.vug", "-o", "in")
        lines = (self.folder / "in/ball.obj").read_text().splitlines()
        faces = [n for n, line in enumerate(lines) if line.startswith("f ")]
        self.write("holed.obj", "\n".join(lines[:faces[100]] + lines[faces[100] + 1:]) + "\n")
        self.write("file.vug", "mesh shell { file \"holed.obj\"  scale 2  paint layer(under: (1, 0, 0), over: (0, 1, 0), mask: slope()) }\n"
                   "cells skin on shell { spacing 20cm  refine false  steps 60  run random_color(share: 5%), voronoi, crack(begin: 20) }\n"
                   "object bunny on skin { material lambert(albedo: (0.6, 0.6, 0.6)) }\nrender main { size 16x12  spp 1 }\n")
        report = json.loads(self.expect(0, "measure", "file.vug", "--cells", "skin", "--json").out)
        self.assertEqual(report["components"], 1)
        self.assertAlmostEqual(report["cells"], 4 * 3.14159 * 4 / 0.2 ** 2, delta=0.1 * report["cells"])
        self.expect(0, "render", "file.vug", "-o", "file.exr")
        self.expect(0, "build", "file.vug", "-o", "out")
        self.assertIn("out/file.ply", self.files())
        mesh = json.loads(self.expect(0, "info", "out/file.ply", "--json").out)
        self.assertGreaterEqual(mesh["triangles"], len(faces) - 1)  # coarse meshes are subdivided
        self.assertAlmostEqual(mesh["bounds"][1][1], 2, delta=0.01)
        self.assertIn("crack 1", mesh["attributes"])
        measured = json.loads(self.expect(1, "measure", "out/file.ply", "--json").out)
        self.assertEqual(measured["boundary_edges"], 3)
        self.write("worn.vug", (self.folder / "file.vug").read_text() + "volume solid on skin { voxel 10cm }\n")
        self.assertIn("worn.vug:5:8: error: a mesh with 3 open edges does not bound a solid", self.expect(2, "build", "worn.vug", "-o", "out").err)
        self.write("inside.vug", "mesh shell { file \"turned.obj\" }\ncells skin on shell { spacing 20cm  run voronoi }\n")
        first = lines[faces[0]].split()
        turned = lines[:faces[0]] + [" ".join([first[0], first[2], first[1], first[3]])] + lines[faces[0] + 1:]
        self.write("turned.obj", "\n".join(turned) + "\n")
        self.assertIn("inside.vug:2:7: error: the polygons of the object disagree about the outside",
                      self.expect(2, "build", "inside.vug", "-o", "out").err)

    def test_voxels_larger_than_cells_cause_a_warning(self):
        self.write("s.vug", SCENE % ("wall", "spacing 5cm  run maze"))
        self.assertIn("s.vug:4:7: warning: the voxels of 'rock' are larger than the cells",
                      self.expect(0, "build", "s.vug", "-o", "out").err)

    def test_same_bytes_of_displaced_and_cut_meshes(self):
        self.write("s.vug", """volume left = level_set(box().translate((-0.5, 0, 0)), voxel: 5cm)
volume right = level_set(box().translate((0.5, 0, 0)), voxel: 5cm)
cells rain on left, right { spacing 5cm  steps 12  files ["csv"]
  run sprinkle(attribute: "height", value: -0.04, share: 10%, radius: 12cm), melting }
volume worn on rain { voxel 4cm }
cells rust on worn { spacing 5cm  holes true  run corrosion(share: 80%, loss: 50%, where: noise(noise: fbm(scale: 30cm), from: 0, to: 0.1)) }
""")
        made = set()
        for threads in (1, 2, 5, 8):
            self.expect(0, "build", "s.vug", "-o", f"out{threads}", "--threads", threads)
            names = sorted(p.name for p in (self.folder / f"out{threads}").iterdir() if p.suffix in (".ply", ".vdb"))
            made.add(tuple((name, digest(self.folder / f"out{threads}" / name)) for name in names))
        self.assertEqual(len(made), 1)
        self.assertIn("s_rain_left.ply", dict(next(iter(made))))
        report = json.loads(self.expect(1, "measure", "out1/s_rust.ply", "--json").out)
        self.assertGreater(report["boundary_edges"], 20)
        self.assertEqual(report["nonmanifold_edges"] + report["misoriented_edges"], 0)
        grids = json.loads(self.expect(0, "info", "out1/s.vdb", "--json").out)["grids"]
        worn, = [grid for grid in grids if grid["name"] == "worn"]
        self.assertEqual((worn["class"], worn["voxel_size"][0]), ("level set", 0.04))

    def test_cells_finer_than_a_pixel_are_averaged(self):
        # 156 random cells per pixel: their mean is 0.5 with a standard error of 0.5 / sqrt(156), plus render noise.
        self.write("s.vug", """volume rock = level_set(box(size: (5, 4, 1)), voxel: 4cm)
cells skin on rock { spacing 4cm  relax 0  run sprinkle(attribute: "mark", share: 50%) }
camera main { kind orthographic  eye (0, 0, 5)  target (0, 0, 0)  width 4m }
render main { size 8x6  spp 256  layers ["beauty", "attribute_mark"] }
""")
        self.expect(0, "render", "s.vug", "-o", "s.exr")
        part, = exr.read(self.folder / "s.exr")
        name, = [name for name, _ in part.channels if "mark" in name]
        values = part.pixels[name]
        self.assertEqual(len(values), 48)
        mean = sum(values) / 48
        self.assertAlmostEqual(mean, 0.5, delta=0.03)
        spread = (sum((v - mean) ** 2 for v in values) / 47) ** 0.5
        self.assertLess(spread, 0.5 / 156 ** 0.5 * 1.5, "one sample a pixel would spread by 0.3")
        self.assertGreater(spread, 0.005)

    def test_same_bytes_of_surfaces_that_grow(self):
        self.write("grow.vug", """let slope = box(size: (60cm, 20cm, 60cm)).rotate(axis: (1, 0, 0), angle: 12deg)
volume rock = level_set(displace(slope, noise: fbm(scale: 8cm, octaves: 2), amount: 2cm), voxel: 2cm)
mesh bare on rock {}
cells skin on bare { spacing 2cm  steps 8  rescatter 2  run calcite(years: 2, smooth: 2cm) }
volume grown on skin {}
mesh stone on grown {}
""")
        made = set()
        for threads in (1, 2, 7):
            self.expect(0, "build", "grow.vug", "-o", f"out{threads}", "--threads", threads)
            made.add((digest(self.folder / f"out{threads}/grow_skin.ply"), digest(self.folder / f"out{threads}/grow_stone.ply")))
        self.assertEqual(len(made), 1)
        # Closed, without folds and without intersections.
        self.expect(0, "measure", "grow.vug", "--mesh", "stone")
        self.expect(0, "measure", "grow.vug", "--mesh", "skin")

    def test_same_bytes(self):
        self.write("s.vug", SCENE % ("wall", GOOD))
        made = set()
        for threads in (1, 2, 5, 8):
            self.expect(0, "build", "s.vug", "-o", f"out{threads}", "--threads", threads)
            self.expect(0, "render", "s.vug", "-o", f"out{threads}/s.exr", "--threads", threads)
            made.add((digest(self.folder / f"out{threads}/s.ply"), digest(self.folder / f"out{threads}/s.exr")))
        self.assertEqual(len(made), 1)
        self.expect(0, "build", "s.vug", "-o", "other", "--seed", "5")
        self.assertNotEqual(digest(self.folder / "other/s.ply"), digest(self.folder / "out1/s.ply"))


if __name__ == "__main__":
    unittest.main()
