# SPDX-License-Identifier: Apache-2.0
"""Several pictures of one scene, the parts that they show, and variants."""
import os
import unittest

import exr
from vug import VugTest, digest

SCENE = """param RADIUS = 1m  in 10cm..2m
volume rock = level_set(sphere(RADIUS), voxel: 10cm)
volume wall = level_set(box(size: (6, 6, 0.5)).translate((0, 0, -2)), voxel: 20cm)
mesh rock_mesh on rock {}
mesh wall_mesh on wall {}
object stone on rock_mesh {}
object screen on wall_mesh {}
light key = sphere(center: (0, 3, 3), radius: 20cm, radiance: (90, 90, 90))
light fill = sphere(center: (3, 0, 3), radius: 20cm, radiance: (30, 0, 0))
medium mist = haze(extinction: 3%/m)
medium smoke = haze(extinction: 60%/m)
camera main { eye (0, 0, 6) }
camera side { eye (6, 0, 1) }
render main { size 32x20  spp 4  air none }
render side { size 16x16  spp 4  lights [fill]  objects [stone]  air smoke }
variant small { RADIUS 40cm }
"""


class Renders(VugTest):
    def setUp(self):
        super().setUp()
        self.write("s.vug", SCENE)

    def render(self, *args, code=0):
        return self.expect(code, "render", "s.vug", *args)

    def test_a_choice_is_required(self):
        err = self.render("-o", "a.exr", code=2).err
        self.assertIn("the scene has 2 renders, and none is chosen", err)
        self.assertIn("main (camera 'main', 32x20), side (camera 'side', 16x16)", err)
        self.assertIn("did you mean 'side'?", self.render("-o", "a.exr", "--render", "sid", code=2).err)
        self.assertNotIn("a.exr", self.files())

    def test_elements_of_loops(self):
        self.write("loop.vug", """volume ball[r in [1m, 2m]] = level_set(sphere(r), voxel: 20cm)
mesh ball[i in 0..1] on ball[i] {}
object ball[i in 0..1] on ball[i] {}
light key[y in [3, 4]] = sphere(center: (0, y, 3), radius: 20cm, radiance: (90, 90, 90))
camera view[z in [6, 9]] { eye (0, 0, z) }
render view[i in 0..1] { size 8x8  spp 1  layers "beauty", "cryptomatte"  lights [key[i]]  objects [ball[i]] }
""")
        self.assertIn("view[0] (camera 'view[0]', 8x8)", self.expect(2, "render", "loop.vug", "-o", "a.exr").err)
        self.expect(0, "render", "loop.vug", "-o", "a.exr", "--render", "all")
        self.assertTrue({"a_view[0].exr", "a_view[1].exr"} <= set(self.files()))
        self.expect(0, "render", "loop.vug", "-o", "b.exr", "--render", "view[1]")
        self.assertEqual(digest(self.folder / "b.exr"), digest(self.folder / "a_view[1].exr"))
        about = self.expect(0, "info", "b.exr").out
        self.assertIn('"ball[1]"', about)
        self.assertNotIn('"ball[0]"', about)
        self.expect(0, "build", "loop.vug", "-o", "out")
        self.assertTrue({"out/loop_ball[0].ply", "out/loop_ball[1].ply"} <= set(self.files()))

    def test_several_pictures_share_one_build(self):
        run = self.render("-o", "a.exr", "--render", "all", "--products", "out")
        self.assertEqual(run.out.split()[:4], ["a_main.exr", "a_main.png", "a_side.exr", "a_side.png"])
        stages = [line.split(":")[0] for line in run.err.splitlines() if "_mesh" in line]  # printed if they take long
        self.assertEqual(len(stages), len(set(stages)), run.err)
        for name in ("main", "side"):
            self.render("-o", f"{name}.exr", "--render", name)
            for end in ("exr", "png"):
                self.assertEqual(digest(self.folder / f"a_{name}.{end}"), digest(self.folder / f"{name}.{end}"))
        self.render("-o", "b.exr", "--render", "side", "--render", "main")
        self.assertEqual(digest(self.folder / "b_side.exr"), digest(self.folder / "side.exr"))

    def test_only_the_selected_part_takes_part(self):
        self.render("-o", "side.exr", "--render", "side")
        self.write("part.vug", "\n".join(
            line for line in SCENE.split("\n")
            if "wall" not in line and "key" not in line and "mist" not in line and "render main" not in line)
            .replace("  lights [fill]  objects [stone]  air smoke", ""))
        self.expect(0, "render", "part.vug", "-o", "part.exr")
        whole, part = (exr.read(self.folder / name)[0] for name in ("side.exr", "part.exr"))
        self.assertEqual(whole.pixels["R"], part.pixels["R"])
        self.assertGreater(max(whole.pixels["R"]), 0)
        self.render("-o", "other.exr", "--render", "side", "--air", "none", "--lights", "key,fill")
        self.assertNotEqual(digest(self.folder / "side.exr"), digest(self.folder / "other.exr"))
        err = self.render("-o", "c.exr", "--render", "side", "--lights", "kei", code=2).err
        self.assertIn("--lights: the scene has no light 'kei'", err)
        self.assertIn("did you mean 'key'?", err)

    def test_frames_of_several_pictures(self):
        run = self.render("-o", "f.##.exr", "--frames", "1..2", "--render", "all")
        self.assertEqual([name for name in run.out.split() if name.endswith("exr")],
                         ["f_main.01.exr", "f_side.01.exr", "f_main.02.exr", "f_side.02.exr"])
        (self.folder / "f_side.02.exr").unlink()
        run = self.render("-o", "f.##.exr", "--frames", "1..2", "--render", "all", "--resume")
        self.assertEqual(run.out.split(), ["f_side.02.exr", "f_side.02.png"])

    def test_parts_belong_to_one_picture(self):
        err = self.render("--part", "a.part", "--render", "all", code=2).err
        self.assertIn("belong to one picture, but 2 renders are chosen", err)
        self.assertIn("--render main", err)
        for i in (1, 2):
            self.render("--part", f"{i}.part", "--tile", f"{i}/2", "--render", "side")
        self.expect(0, "merge", "1.part", "2.part", "-o", "merged.exr")
        self.render("-o", "side.exr", "--render", "side")
        self.assertEqual(digest(self.folder / "merged.exr"), digest(self.folder / "side.exr"))
        self.render("--part", "3.part", "--tile", "1/2", "--render", "side", "--lights", "key")
        self.assertNotEqual(self.expect(2, "merge", "3.part", "2.part", "-o", "m.exr").err, "")

    def test_variants_set_parameters(self):
        self.expect(0, "measure", "s.vug", "--mesh", "rock_mesh", "--variant", "small")
        self.expect(0, "build", "s.vug", "--variant", "small", "-o", "out")
        recipe = self.expect(0, "recipe", "out/s.vdb")
        self.assertIn("param RADIUS = 40cm", recipe.out)
        self.expect(0, "build", "s.vug", "-D", "RADIUS=40cm", "-o", "same")
        self.assertEqual(digest(self.folder / "out/s_rock_mesh.ply"), digest(self.folder / "same/s_rock_mesh.ply"))
        err = self.expect(2, "check", "s.vug", "--variant", "tiny").err
        self.assertIn("--variant tiny: error: the scene has no variant 'tiny'", err)
        self.assertIn("its variants: small", err)

    def test_includes_are_found_below_the_data_folders(self):
        for name in ("rocks/lime.vug", "a/door.vug", "b/door.vug"):
            self.write("data/" + name, "let lime = 1m\n")
        self.write("i.vug", 'include "lime.vug"\nvolume rock = level_set(sphere(lime), voxel: 10cm)\n')
        os.environ["VUG_DATA"] = str(self.folder / "data")
        self.addCleanup(os.environ.pop, "VUG_DATA")
        self.expect(0, "check", "i.vug", "--strict")
        self.write("j.vug", 'include "door.vug"\n')
        self.assertIn("'door.vug' is the name of 2 files", self.expect(2, "check", "j.vug").err)

    def test_usd_contains_all_variants(self):
        self.expect(0, "export", "s.vug", "-o", "out", "--variants")
        text = (self.folder / "out/s.usda").read_text()
        shared, own = text.split('variantSet "variant" = {')
        self.assertIn('string variant = "default"', shared)
        self.assertEqual(own.count('def Xform "stone"'), 2)
        self.assertEqual(shared.count('def Xform "screen"'), 1)
        self.assertEqual(own.count('def Xform "screen"'), 0)
        for name in ("s_rock.vdb", "s_small_rock.vdb"):
            self.assertIn(f"@./{name}@", own)
            self.assertIn(name, [path.name for path in (self.folder / "out").iterdir()])
        err = self.expect(2, "export", "s.vug", "-o", "out", "--variants", "--for", "blender").err
        self.assertIn("--variants: files for blender have no variants", err)
        self.write("none.vug", "volume rock = level_set(sphere(1m), voxel: 20cm)\n")
        self.assertIn("the scene has no variants", self.expect(2, "export", "none.vug", "-o", "x", "--variants").err)


if __name__ == "__main__":
    unittest.main()
