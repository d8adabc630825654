# SPDX-License-Identifier: Apache-2.0
"""vug export writes files for other programs; vug recipe prints the scene that rebuilds a file."""
import json
import os
import struct
import subprocess
import unittest

from vug import BALL, VugTest, digest

SCENE = """seed 3
param R = 1m in 50cm..2m

grammar cave {
  axiom Room*2
  Room -> + sphere(R) label random
}

volume rock = level_set(cave, voxel: 20cm)
volume mist = fog(sphere(R), voxel: 25cm)
mesh wall on rock { paint layer(under: (0.5, 0.4, 0.3), over: (0.1, 0.2, 0.1), mask: slope(from: 30deg, to: 60deg)) }
object wall on wall { material surface(roughness: 0.6) }
camera main { eye (0, 2, 6) target (0, 0, 0) }
light ball = sphere(center: (0, 3, 0), power: 100)
render main { size 16x9 spp 1 }
"""
PROGRAMS = {"blender": ["glb"], "gltf": ["glb"], "houdini": ["usda"], "maya": ["usda"],
            "meshes": ["obj", "ply"], "unreal": ["usda"], "usd": ["usda"]}


def buffer_of(glb):
    data = glb.read_bytes()
    [text] = struct.unpack_from("<I", data, 12)
    return data[20 + text:]


class Export(VugTest):
    def setUp(self):
        super().setUp()
        self.write("cave.vug", SCENE)

    def test_a_set_for_every_program(self):
        listed = json.loads(self.expect(0, "list", "program", "--json").out)
        self.assertEqual([each["name"] for each in listed], list(PROGRAMS))
        for program, endings in PROGRAMS.items():
            said = self.expect(0, "export", "cave.vug", "-o", program, "--for", program)
            names = ["cave_rock.vdb", "cave_mist.vdb", *(f"cave.{ending}" for ending in endings)]
            self.assertEqual(said.out.split(), [f"{program}/{name}" for name in names])
            self.assertEqual(sorted(os.listdir(self.folder / program)), sorted(names))
            for name in names:
                about = json.loads(self.expect(0, "info", f"{program}/{name}", "--json").out)
                self.assertEqual(about["metadata"]["vug:recipe"], SCENE, name)

    def test_requested_axes_and_units(self):
        self.expect(0, "export", "cave.vug", "-o", "o", "--up", "z", "--unit", "cm")
        text = (self.folder / "o/cave.usda").read_text()
        self.assertIn("    metersPerUnit = 0.01\n    upAxis = \"Z\"\n", text)
        about = json.loads(self.expect(0, "info", "o/cave_rock.vdb", "--json").out)
        self.assertEqual(about["metadata"]["vug:upAxis"], "z")
        self.assertAlmostEqual(about["grids"][0]["voxel_size"][0], 20)

    def test_exported_distances_are_exact(self):
        def distance(file):
            about = json.loads(self.expect(0, "info", file, "--json").out)
            return next(grid["metadata"].get("vug:distance") for grid in about["grids"] if grid["class"] == "level set")
        solid = "level_set(box(size: (1, 1, 1)) - sphere(60cm), voxel: 10cm"
        self.write("a.vug", f"volume rock = {solid})\n")
        self.write("b.vug", f"volume rock = {solid}, distance: bound)\n")
        for scene, exported, built in [("a", "exact", None), ("b", "bound", "bound")]:
            self.expect(0, "export", f"{scene}.vug", "-o", "o", "-q")
            self.assertEqual(distance(f"o/{scene}_rock.vdb"), exported)
            self.expect(0, "build", f"{scene}.vug", "-o", "o", "-q")
            self.assertEqual(distance(f"o/{scene}.vdb"), built)

    def test_drafts_say_so_in_their_recipe(self):
        self.write("a.vug", "volume rock = level_set(box() - sphere(60cm), voxel: 10cm)\nmesh skin on rock {}\n")
        self.expect(0, "build", "a.vug", "-o", "final", "-q")
        self.expect(0, "build", "a.vug", "-o", "draft", "-q", "--quality", "draft")
        self.assertNotEqual((self.folder / "draft/a.ply").read_bytes(), (self.folder / "final/a.ply").read_bytes())
        self.assertIn("--quality draft", self.expect(0, "recipe", "draft/a.ply").err)
        self.assertIn("draft", self.expect(2, "build", "a.vug", "-o", "o", "--quality", "low").err)

    def test_pyopenvdb_reads_clouds(self):
        if subprocess.run(["/usr/bin/python3", "-c", "import pyopenvdb"], capture_output=True).returncode != 0:
            self.skipTest("pyopenvdb is not installed")
        self.write("mist.vug", "volume banks = fog(sphere(1m), voxel: 10cm)\n"
                   "medium mist on banks { kind cloud  temperature 1800  temperature_mask height(from: -1m, to: 1m)\n"
                   "  albedo layer(under: (0.9, 0.5, 0.1), over: (0.1, 0.5, 0.9), mask: height(from: -1m, to: 1m)) }\n"
                   "volume rock = level_set(box(size: (4, 1, 4)).translate((0, -1.5, 0)), voxel: 20cm)\n")
        self.expect(0, "export", "mist.vug", "-o", "o", "--for", "blender", "-q")
        script = ("import json, pyopenvdb as v\n"
                  "grids = {g.name: g for g in v.readAll('o/mist_banks.vdb')[0]}\n"
                  "at = {n: [g.getConstAccessor().getValue((0, y, 0)) for y in (-5, 0, 5)] for n, g in grids.items()}\n"
                  "print(json.dumps({n: [g.gridClass, at[n]] for n, g in grids.items()}))\n")
        said = subprocess.run(["/usr/bin/python3", "-c", script], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)
        found = json.loads(said.stdout)
        self.assertEqual(sorted(found), ["color", "density", "temperature"])
        self.assertEqual({grid_class for grid_class, _ in found.values()}, {"fog volume"})
        for i, y in enumerate((-0.5, 0, 0.5)):  # voxels keep their axes; the transform rotates them
            t = (y + 1) / 2
            t = t * t * (3 - 2 * t)
            self.assertAlmostEqual(found["temperature"][1][i], 1800 * t, delta=0.1)
            for got, low, high in zip(found["color"][1][i], (0.9, 0.5, 0.1), (0.1, 0.5, 0.9)):
                self.assertAlmostEqual(got, low + t * (high - low), delta=1e-5)

    def test_the_same_bytes_again(self):
        for threads in (1, 2, 5, 8):
            for program in ("blender", "unreal"):
                self.expect(0, "export", "cave.vug", "-o", f"o{threads}", "--for", program,
                            "--threads", threads)
        for path in (self.folder / "o1").iterdir():
            files = [self.folder / f"o{threads}" / path.name for threads in (1, 2, 5, 8)]
            self.assertEqual(len(set(map(digest, files))), 1, path.name)

    def test_omissions_are_reported(self):
        self.write("sky.vug", BALL + "light heaven = daylight(elevation: 30deg)\ncamera round { kind panoramic }\n")
        said = self.expect(0, "export", "sky.vug", "-o", "o", "--for", "blender", "--lod", "2")
        round_ = "omitted: the camera 'round', which is panoramic\n"
        self.assertIn("note: the sky 'heaven': glTF cannot express it, only Vug's add-on for Blender reads it "
                      "(sky.glb)\n", said.err)
        self.assertIn(round_, said.err)
        self.assertNotIn("volume", said.err)  # it is exported as a separate file
        # Omissions are reported even with --quiet; notes are not.
        self.assertEqual(self.expect(0, "export", "sky.vug", "-o", "o", "--for", "blender", "-q").err, round_)
        self.assertEqual([path.name for path in sorted((self.folder / "o").glob("*.exr"))], ["sky_heaven.exr"])
        self.assertIn(b'"file":"sky_heaven.exr"', (self.folder / "o/sky_lod2.glb").read_bytes())

    def test_levels_end_when_no_triangles_remain(self):
        said = self.expect(0, "export", "cave.vug", "-o", "o", "--for", "blender", "--lod", "8")
        there = sorted(path.name for path in (self.folder / "o").glob("cave_lod*.glb"))
        last = len(there)
        self.assertEqual(there, [f"cave_lod{n}.glb" for n in range(1, last + 1)])
        self.assertTrue(2 <= last < 8, last)
        self.assertIn(f"level {last} is the last: no mesh can be decimated further\n", said.err)

    def test_points_and_meshes_of_cells(self):
        self.write("skin.vug", "volume rock = level_set(sphere(1m), voxel: 10cm)\nmesh wall on rock {}\n"
                   'cells skin on wall { spacing 15cm  run life(steps: 2)  files ["points"] }\n')
        self.expect(0, "export", "skin.vug", "-o", "o", "--for", "blender", "-q")
        data = (self.folder / "o/skin_skin_points.ply").read_bytes()
        head, body = data.split(b"end_header\n", 1)
        names = [line.split()[1:] for line in head.decode().splitlines() if line.startswith("property ")]
        self.assertIn(["int", "id"], names)
        count = int(head.split(b"element vertex ")[1].split()[0])
        size = 4 * sum(kind in ("int", "float") for kind, *_ in names)
        self.assertEqual(len(body), count * size)
        at = 4 * names.index(["int", "id"])
        ids = [struct.unpack_from("<i", body, size * i + at)[0] for i in range(count)]
        self.assertEqual(ids, list(range(count)))
        self.assertIn(b'"name":"wall"', (self.folder / "o/skin.glb").read_bytes())

    def test_refusals(self):
        self.assertIn("did you mean 'blender'?",
                      self.expect(2, "export", "cave.vug", "-o", "o", "--for", "blendr").err)
        self.vug("export", "cave.vug", "-o", "o", "--up", "x")
        self.assertFalse((self.folder / "o").exists())
        (self.folder / "o/cave.usda").mkdir(parents=True)
        self.assertIn("it is a folder", self.expect(2, "export", "cave.vug", "-o", "o").err)
        self.assertEqual(os.listdir(self.folder / "o"), ["cave.usda"])

    def test_binary_usd(self):
        for program in ("houdini", "maya", "unreal", "usd"):
            said = self.expect(0, "export", "cave.vug", "-o", program, "--for", program, "--usd-format", "usdc")
            self.assertEqual(said.out.split()[-1], f"{program}/cave.usdc")
            self.assertFalse((self.folder / program / "cave.usda").exists())
            about = json.loads(self.expect(0, "info", f"{program}/cave.usdc", "--json").out)
            self.assertEqual(about["metadata"]["vug:recipe"], SCENE)
        self.assertEqual(self.expect(0, "recipe", "usd/cave.usdc").out, SCENE)
        self.assertIn("files for blender are not USD", self.expect(
            2, "export", "cave.vug", "-o", "o", "--for", "blender", "--usd-format", "usdc").err)
        self.vug("export", "cave.vug", "-o", "o", "--usd-format", "usdz")
        self.assertFalse((self.folder / "o").exists())
        # A file without its end has no table of contents.
        whole = (self.folder / "usd/cave.usdc").read_bytes()
        self.write("half.usdc", whole[:len(whole) // 2])
        self.assertIn("truncated or damaged", self.expect(2, "recipe", "half.usdc").err)
        self.write("text.usdc", "#usda 1.0\n")
        self.assertIn("not a binary USD file", self.expect(2, "recipe", "text.usdc").err)

    def test_a_full_disk_leaves_the_old_files(self):
        for program, name in (("usd", "cave.usda"), ("blender", "cave.glb"), ("meshes", "cave.ply"), ("maya", "cave.usdc")):
            folder = self.folder / program
            more = ["--usd-format", "usdc"] if name.endswith("usdc") else []
            self.expect(0, "export", "cave.vug", "-o", program, "--for", program, *more)
            before = {path.name: digest(path) for path in folder.iterdir()}
            # A limit on the size of files makes the disk look full for large files.
            limit = (folder / name).stat().st_size // 2
            said = self.vug("export", "cave.vug", "-o", program, "--for", program, "-D", "R=1.1m", *more,
                            preexec_fn=lambda most=limit: set_file_limit(most))
            self.assertEqual(said.code, 3, said.err)
            self.assertIn(f"cannot write '{program}/cave", said.err)
            self.assertEqual(sorted(before), sorted(os.listdir(folder)))
            self.assertEqual(before[name], digest(folder / name))


def set_file_limit(limit):
    import resource
    import signal
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))


class Recipe(VugTest):
    def prepare(self):
        self.write("cave.vug", SCENE)
        self.expect(0, "export", "cave.vug", "-o", "set", "--for", "blender", "-D", "R=80cm", "--seed", 9)
        self.expect(0, "export", "cave.vug", "-o", "set", "--for", "usd", "-D", "R=80cm", "--seed", 9)
        self.expect(0, "build", "cave.vug", "-o", "set", "-D", "R=80cm", "--seed", 9)
        self.expect(0, "render", "cave.vug", "-o", "set/cave.exr", "-D", "R=80cm", "--seed", 9)

    def test_every_file_has_the_same_recipe(self):
        expected = SCENE.replace("seed 3", "seed 9").replace("= 1m in", "= 80cm in")
        files = sorted(path.name for path in (self.folder / "set").iterdir())
        files.remove("cave.png")  # it shows the scene but has no recipe
        for ending in ("vdb", "glb", "usda", "ply", "exr"):
            self.assertTrue(any(name.endswith(ending) for name in files), ending)
        for name in files:
            self.assertEqual(self.expect(0, "recipe", f"set/{name}").out, expected, name)

    def test_the_recipe_rebuilds_the_same_files(self):
        self.expect(0, "recipe", "set/cave.vdb", "-o", "again/cave.vug")
        self.expect(0, "export", "again/cave.vug", "-o", "new", "--for", "blender")
        self.assertEqual(buffer_of(self.folder / "set/cave.glb"), buffer_of(self.folder / "new/cave.glb"))
        self.expect(0, "build", "again/cave.vug", "-o", "new")
        for name in ("set/cave.ply", "new/cave.ply"):
            self.expect(0, "measure", name)
        old, new = [json.loads(self.expect(0, "measure", f"{folder}/cave.ply", "--json").out)
                    for folder in ("set", "new")]
        self.assertEqual({**old, "name": ""}, {**new, "name": ""})
        # Products of an unchanged text are identical.
        self.expect(0, "recipe", "new/cave.vdb", "-o", "third/cave.vug")
        self.expect(0, "build", "third/cave.vug", "-o", "third")
        for name in ("cave.vdb", "cave.ply"):
            self.assertEqual(digest(self.folder / "new" / name), digest(self.folder / "third" / name))

    def test_files_without_a_recipe_are_rejected(self):
        self.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        self.assertIn("contains no recipe", self.expect(2, "recipe", "a.obj").err)
        self.write("a.glb", b"glTF\x02\0\0\0\xff\xff\xff\xff\0\0\0\0JSON")
        self.expect(2, "recipe", "a.glb")
        self.write("a.usda", "def Xform {}\n")
        self.expect(2, "recipe", "a.usda")
        for suffix in ("vdb", "glb", "usda", "ply"):
            told = self.expect(2, "recipe", f"missing.{suffix}").err
            self.assertIn(f"cannot read 'missing.{suffix}': no such file", told)


if __name__ == "__main__":
    unittest.main()
