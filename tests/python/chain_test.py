# SPDX-License-Identifier: Apache-2.0
"""From text to files: Python writes the same bytes as the command."""
import json
import unittest
import warnings

import numpy
import vug
from case import BALL, Case

CAVE = """seed 3
param R = 1m  in 50cm..2m  "radius of a room"
param DIRT = 30%
param STAINED = true
let drift = if(STAINED, frame * 1cm, 0cm)

grammar hall {
  axiom Room*2 Melt
  Room -> + sphere(R) label +X
  Melt -> ~ DIRT box() label +Y
}

volume rock = level_set(hall.translate((drift, 0, 0)), voxel: 20cm)
volume mist = fog(sphere(R), voxel: 20cm)
mesh wall on rock { paint (0.5, 0.4, 0.3) }
cells skin on wall {
  spacing 20cm
  run life(begin: 1, steps: 4)
  files ["points", "grids", "csv"]
}
object body on skin {}
light sky = sky(radiance: (1, 1, 1))
camera main { eye (1, 1, 8) }
camera eyes { eye (1, 1, 8)  interaxial 6.5cm }
render main { size 40x24  spp 4  layers ["all"] }
"""
FLAGS = ["-D", "R=1.25", "-D", "DIRT=10%", "-D", "STAINED=false", "--seed", "5", "--frame", "2"]


class Chain(Case):
    def setUp(self):
        super().setUp()
        self.write("cave.vug", CAVE)
        self.scene = vug.load("cave.vug", R=1.25, DIRT="10%", STAINED=False, seed=5, frame=2)

    def test_contents_of_a_scene(self):
        self.assertEqual([path.name for path in self.scene.files], ["cave.vug"])
        self.write("twice.vug", 'volume a = level_set(mesh("a.ply") + mesh("a.ply"), voxel: N)\nparam N = 1m')
        vug.loads(BALL).build().mesh().save("a.ply")
        self.assertEqual([path.name for path in vug.load("twice.vug", N="2m").files], ["a.ply", "twice.vug"])
        vug.loads(BALL).build().mesh().save("ball.ply")
        self.write("walls.vug", 'let walls = mesh("ball.ply")')
        self.write("all.vug", 'include "walls.vug"\nvolume rock = level_set(walls, voxel: 1m)')
        names = sorted(path.name for path in vug.load("all.vug").files)
        self.assertEqual(names, ["all.vug", "ball.ply", "walls.vug"])

    def test_products(self):
        self.vug("build", "cave.vug", "-o", "theirs", *FLAGS)
        build = self.scene.build()
        paths = build.save("ours")
        self.assertEqual(sorted(p.name for p in paths),
                         ["cave.ply", "cave.vdb", "cave_skin.csv", "cave_skin.vdb"])
        for path in paths:
            self.assert_same_files(path, f"theirs/{path.name}")
        build.save("grids.vdb")
        build.mesh("skin").save("mesh.ply")
        skin = build.cells("skin")
        skin.save("points.vdb")
        skin.save("table.csv")
        for ours, theirs in [("grids.vdb", "cave.vdb"), ("mesh.ply", "cave.ply"),
                             ("points.vdb", "cave_skin.vdb"), ("table.csv", "cave_skin.csv")]:
            self.assert_same_files(ours, f"theirs/{theirs}")

    def test_measures(self):
        ours = self.scene.build().measure()
        theirs = json.loads(self.vug("measure", "cave.vug", "--json", *FLAGS))
        del ours["build_seconds"], theirs["build_seconds"]
        self.assertEqual(ours, theirs)
        self.assertEqual(self.scene.build().measure_cells("skin"),
                         json.loads(self.vug("measure", "cave.vug", "--cells", "skin", "--json", *FLAGS)))
        mesh = vug.read_mesh(self.scene.build().save("ours")[1])
        del theirs["volume_cells"], theirs["productions"]
        self.assertEqual({k: v for k, v in mesh.measure().items() if k in theirs}, theirs)

    def test_meshes_that_were_read_keep_their_recipe(self):
        self.scene.build().mesh().save("first.ply")
        vug.read_mesh("first.ply").save("second.obj")
        again = vug.scene_of("second.obj")
        self.assertEqual((again.seed, again.params["R"].value), (5, 1.25))

    def test_levels_of_detail(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            paths = self.scene.export("ours", "gltf", lod=2)
        self.assertLessEqual({"cave.glb", "cave_lod1.glb", "cave_lod2.glb"}, {path.name for path in paths})
        self.vug("export", "cave.vug", "-o", "theirs", "--for", "gltf", "--lod", "2", *FLAGS)
        for path in paths:
            self.assert_same_files(path, f"theirs/{path.name}")
        with self.assertRaisesRegex(ValueError, "lod must be from 0 to 8"):
            self.scene.export("ours", "gltf", lod=9)

    def test_trees(self):
        tree = self.scene.derivations["hall"]
        self.assertEqual(str(tree), self.vug("tree", "cave.vug", *FLAGS))
        self.assertEqual(tree.data(), json.loads(self.vug("tree", "cave.vug", "--json", *FLAGS)))
        self.assertEqual(tree.svg(), self.vug("tree", "cave.vug", "--svg", *FLAGS))
        self.assertEqual(tree.productions, 3)

    def test_pictures(self):
        self.vug("render", "cave.vug", "-o", "theirs.exr", *FLAGS)
        image = self.scene.render("main")
        self.assertEqual((image.width, image.height), (40, 24))
        image.save("ours.exr")
        image.save("ours.png")
        self.assert_same_files("ours.exr", "theirs.exr")
        self.assert_same_files("ours.png", "theirs.png")
        self.assertEqual(image.metadata["vug:recipe"], self.scene.recipe)

    def test_every_option_of_a_picture(self):
        options = dict(camera="main", size=(30, 20), spp=2, crop=(2, 3, 20, 18), seed=9, exposure=1.5,
                       layers=["beauty", "Z", "variance", "albedo", "N"], denoise=True, deep=True,
                       full_float=True, multi_part=True, tiled=True, working_space="acescg",
                       view="standard")
        self.scene.render("main", **options).save("ours.deep.exr")
        image = self.scene.build(threads=1).render("main", **options)
        image.save("ours.exr")
        image.save("ours.png")
        self.assertEqual(image.origin, (2, 3))
        self.vug("render", "cave.vug", "-o", "theirs.exr", "--render", "main", "--camera", "main", "--size", "30x20", "--spp",
                 2, "--crop", "2,3,20,18", "--sample-seed", 9, "--exposure", 1.5, "--layers",
                 "beauty,Z,variance,albedo,N", "--denoise", "--deep", "--float", "--multi-part",
                 "--tiled", "--working-space", "acescg", "--view", "standard", *FLAGS)
        for end in ["exr", "png", "deep.exr"]:
            self.assert_same_files(f"ours.{end}", f"theirs.{end}")

    def test_stereo(self):
        self.vug("render", "cave.vug", "-o", "theirs.exr", "--camera", "eyes", "--noise", "0.3", *FLAGS)
        image = self.scene.render(camera="eyes", noise=0.3)
        image.save("ours.exr")
        image.save("ours.png")
        self.assert_same_files("ours.exr", "theirs.exr")
        self.assert_same_files("ours.png", "theirs.png")
        self.assertEqual(list(image.views), ["left", "right"])
        self.assertFalse(numpy.array_equal(image.views["left"]["beauty"], image.views["right"]["beauty"]))
        left = self.scene.render(camera="eyes", noise=0.3, eye="left")
        self.assertTrue(numpy.array_equal(left["beauty"], image["beauty"]))
        self.assertEqual(left.views, {})
        image.views["left"].save("left.exr")
        self.assertTrue(vug.diff("left.exr", left).same)

    def test_both_views_of_stereo_pictures_are_compared(self):
        options = dict(camera="eyes", layers=["beauty", "variance"], full_float=True)
        one, other = self.scene.render(**options), self.scene.render(seed=99, **options)
        one.save("one.exr")
        other.save("other.exr")
        said = self.vug("diff", "one.exr", "other.exr")
        for pair in ((one, other), ("one.exr", other), (one, "other.exr")):
            self.assertEqual(str(vug.diff(*pair)), said)
        self.assertIn("\nsignificance of right, ", said)
        self.assertTrue(vug.diff("one.exr", one).same)
        self.assertNotIn("of right", str(vug.diff(one.views["right"], other.views["right"])))
        with self.assertRaisesRegex(vug.Error, "is a stereo image"):
            vug.diff(one, other.views["left"])

    def test_export(self):
        for program in [kind.name for kind in vug.catalogue.find("program")]:
            self.vug("export", "cave.vug", "-o", f"theirs {program}", "--for", program, *FLAGS)
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # omissions depend on the program
                paths = self.scene.export(f"ours {program}", program)
            self.assertEqual(sorted(p.name for p in paths),
                             sorted(p.name for p in (self.folder / f"theirs {program}").iterdir()))
            for path in paths:
                self.assert_same_files(path, f"theirs {program}/{path.name}")
        plain = vug.loads(BALL)
        plain.export("plain", "blender")  # a volume and a sky: nothing is lost, so there is no warning
        with self.assertWarnsRegex(vug.SceneWarning, r"omitted: the camera 'main': the file contains only a mesh \(scene.ply\)"):
            plain.export("plain", "meshes")
        for wrong in ({"up": "x"}, {"unit": "mm"}):
            with self.assertRaises(ValueError):
                self.scene.export("out", **wrong)
        with self.assertRaises(vug.Error):
            self.scene.export("out", "blendr")

    def test_files_contain_their_scene(self):
        scene = self.scene.with_(STAINED=True)  # makes the scene depend on the frame
        build = scene.build()
        build.render(spp=1).save("picture.exr")
        for file in [*build.save("ours")[:2], "picture.exr"]:
            again = vug.scene_of(file)
            self.assertEqual((again.seed, again.frame), (5, 2), file)
            self.assertEqual({name: p.value for name, p in again.params.items()},
                             {name: p.value for name, p in scene.params.items()}, file)
            self.assertTrue(numpy.array_equal(again.build().mesh().positions, build.mesh().positions), file)
        with self.assertRaises(vug.Error):
            vug.scene_of("cave.vug.txt")

    def test_diff(self):
        one, two = self.scene.render(spp=1), self.scene.with_(R=1.5).render(spp=1)
        self.assertTrue(vug.diff(one, one).same)
        verdict = vug.diff(one, two, limits={"rmse": 1e-6})
        self.assertFalse(verdict.same)
        self.assertIn("rmse", str(verdict))
        self.assertFalse(verdict.data()["same"])
        one.save("one.exr")
        self.assertTrue(vug.diff("one.exr", one).same)


class Motion(Case):
    def test_blur(self):
        self.write("fly.vug", BALL.replace("sphere(R)", "sphere(R).translate((frame * 10cm, 0, 0))")
                   .replace("eye (0, 0, 4)", "eye (frame * 20cm, 0, 4)  shutter 0.5"))
        self.vug("render", "fly.vug", "-o", "theirs.exr", "--frame", 3)
        vug.load("fly.vug", frame=3).render().save("ours.exr")
        self.assert_same_files("ours.exr", "theirs.exr")


class Parts(Case):
    def test_includes_relative_to_a_folder(self):
        self.write("lib/part.vug", "let part = sphere(1m)\n")
        text = 'include "part.vug"\nvolume rock = level_set(part, voxel: 20cm)\n'
        scene = vug.loads(text, base=self.folder / "lib")
        self.assertEqual(scene.volumes, ["rock"])
        self.assertGreater(scene.build().level_set().active_voxels, 100)
        with self.assertRaises(vug.Error):
            vug.loads(text)

    def test_units_of_light(self):
        scene = vug.loads("param L = 800lm in 1lm..5000lm\nparam C = srgb(\"#c0a080\")\n"
                          "light bulb = sphere(radiance: C, lumen: L)\n")
        self.assertEqual(scene.params["L"].dimension, "luminous flux")
        self.assertEqual(scene.with_(L=1000).params["L"].value, 1000)
        self.assertEqual(scene.with_(L="2000lm").params["L"].value, 2000)
        self.assertAlmostEqual(scene.params["C"].value[1], 0.35153, places=5)
        with self.assertRaisesRegex(vug.Error, "param 'L' is a luminous flux, not a power"):
            scene.with_(L="3W")

    def test_overrides(self):
        scene = vug.loads(BALL + "param P = (1, 2, 3)\nparam NAME = \"x.ply\"\nparam A = 30deg\n"
                          "let used = sphere(A / 1rad).translate(P)\n"
                          "volume more = level_set(used, voxel: 1m)\n"
                          "volume file = level_set(mesh(file: NAME), voxel: 1m)\n",
                          NAME=self.ball_file(), P=(1, 2.5, numpy.float32(4)), A=numpy.pi / 2)
        self.assertEqual(scene.params["P"].value, (1, 2.5, 4))
        self.assertEqual(scene.params["P"].default, (1, 2, 3))
        self.assertAlmostEqual(scene.params["A"].value, numpy.pi / 2)
        self.assertEqual(scene.params["A"].dimension, "angle")
        radius = scene.params["R"]
        self.assertEqual((radius.value, radius.low, radius.high, radius.doc, radius.type),
                         (1, 0.5, 2, "its radius", "number"))
        again = scene.with_({"R": numpy.int64(2)}, seed=4).with_(A="45deg")
        self.assertEqual((again.params["R"].value, again.seed), (2, 4))
        self.assertEqual(scene.params["R"].value, 1)
        self.assertAlmostEqual(again.build().mesh("wall").bounds[1][0], 2, delta=0.02)

    def ball_file(self):
        vug.loads(BALL).build().mesh().save("ball.ply")
        return self.folder / "ball.ply"


if __name__ == "__main__":
    unittest.main()
