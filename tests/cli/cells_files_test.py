# SPDX-License-Identifier: Apache-2.0
"""Files of cells: the outputs, other programs that read them, and killed runs that are resumed."""
import csv
import json
import os
import shutil
import signal
import subprocess
import time
import unittest

import exr
from vug import PROGRAM, VugTest, digest

SCENE = """seed 3
volume rock = level_set(sphere(1m), voxel: 5cm)
mesh wall on rock {}
cells crust on wall { spacing 8cm  %s
  run random_color(share: 5%%, from: (0.8, 0.4, 0.1), to: (0.8, 0.4, 0.1)), spreading_color, gray_scott,
      sprinkle(attribute: "v", share: 5%%), corrosion(begin: 20, share: 10%%, loss: 2%%)
  steps %s
}
"""

# Renders the colour grid of a volume as emission and prints the mean colour of a mesh.
BLENDER = """
import bpy
scene = bpy.context.scene
for each in list(bpy.data.objects): bpy.data.objects.remove(each)
volume = bpy.data.volumes.new("rock")
volume.filepath = "{folder}/s.vdb"
volume.grids.load()
print("grids", sorted((g.name, g.data_type, g.channels) for g in volume.grids))
shown = bpy.data.objects.new("rock", volume)
scene.collection.objects.link(shown)

material = bpy.data.materials.new("light")
material.use_nodes = True
nodes, links = material.node_tree.nodes, material.node_tree.links
nodes.clear()
source = nodes.new("ShaderNodeAttribute")
source.attribute_name = "crust_Cd"
emission = nodes.new("ShaderNodeEmission")
result = nodes.new("ShaderNodeOutputMaterial")
links.new(source.outputs["Color"], emission.inputs["Color"])
links.new(emission.outputs[0], result.inputs["Volume"])
shown.data.materials.append(material)
bpy.ops.import_mesh.ply(filepath="{folder}/s.ply")
mesh = bpy.context.object.data
colors = [value.color_srgb for value in mesh.color_attributes[0].data]
print("colours", *(sum(c[i] for c in colors) / len(colors) for i in range(3)))
bpy.data.objects.remove(bpy.context.object)
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
camera.data.type, camera.data.ortho_scale = "ORTHO", 3
camera.location = (0, -10, 0)
camera.rotation_euler = (1.5707963, 0, 0)
scene.collection.objects.link(camera)
scene.camera = camera
scene.world = None
scene.render.engine, scene.cycles.samples, scene.cycles.device = "CYCLES", 4, "CPU"
scene.cycles.use_denoising = False
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 32, 32, 100
settings = scene.render.image_settings
settings.file_format, settings.color_depth, settings.exr_codec = "OPEN_EXR", "32", "ZIP"
scene.render.filepath = "{folder}/seen_"
scene.frame_start = scene.frame_end = 1
bpy.ops.render.render(animation=True)
"""


class CellsFiles(VugTest):
    def prepare(self):
        self.write("s.vug", SCENE % ('files ["points", "grids", "csv"]', 60))
        self.expect(0, "build", "s.vug", "-o", "out")

    def info(self, file):
        return json.loads(self.expect(0, "info", file, "--json").out)

    def test_contents_of_a_table(self):
        about = self.info("out/s_crust.csv")
        self.assertEqual((about["type"], about["rows"]), ("table", self.info("out/s_crust.vdb")["grids"][0]["points"]["count"]))
        self.assertEqual(about["columns"][:4], ["id", "x", "y", "z"])

    def test_points_grids_and_table_are_written(self):
        self.assertEqual(self.files(), ["out/s.ply", "out/s.vdb", "out/s_crust.csv", "out/s_crust.vdb", "s.vug"])
        grid, = self.info("out/s_crust.vdb")["grids"]
        self.assertEqual(grid["name"], "crust")
        self.assertEqual(grid["metadata"]["vug:step"], 60)
        self.assertEqual(grid["metadata"]["vug:metersPerUnit"], 1.0)
        points = grid["points"]
        self.assertEqual(points["attributes"],
                         ["P vec3s fxpt16", "id int32 null", "N vec3s trnc", "pscale float trnc", "Cd vec3s trnc",
                          "seed int32 null", "u float null", "v float null", "potential float null"])
        with open(self.folder / "out/s_crust.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), points["count"])
        for state in points["groups"]:
            self.assertEqual(sum(row["state"] == state["name"] for row in rows), state["points"], state)
        for axis, name in enumerate("xyz"):
            values = [float(row[name]) for row in rows]
            self.assertAlmostEqual(min(values), points["bounds"][0][axis], delta=1e-4)
            self.assertAlmostEqual(max(values), points["bounds"][1][axis], delta=1e-4)
        names = [g["name"] for g in self.info("out/s.vdb")["grids"]]
        self.assertEqual(names, ["rock", "crust_Cd", "crust_seed", "crust_u", "crust_v", "crust_potential", "crust_transparent"])
        self.write("few.vug", SCENE % ("files []", 60))
        self.expect(0, "build", "few.vug", "-o", "few")
        self.assertEqual(sorted(os.listdir(self.folder / "few")), ["few.ply", "few.vdb"])

    def test_same_bytes_for_any_number_of_threads(self):
        for threads in (1, 5, 8):
            self.expect(0, "build", "s.vug", "-o", f"out{threads}", "--threads", threads)
            for name in ("s.ply", "s.vdb", "s_crust.csv", "s_crust.vdb"):
                self.assertEqual(digest(self.folder / f"out{threads}" / name), digest(self.folder / "out" / name), name)

    def test_a_table_is_places_for_others(self):
        self.write("stones.vug", 'volume pebble = level_set(sphere(3cm), voxel: 1cm)\nmesh stone on pebble {}\n'
                   'place all { of stone  at points(file: "out/s_crust.csv") }\n')
        self.expect(0, "check", "stones.vug")

    def test_tools_of_openvdb_read_them(self):
        if not shutil.which("vdb_print"):
            self.skipTest("vdb_print is not installed")
        for file, name in (("out/s_crust.vdb", "crust"), ("out/s.vdb", "crust_Cd")):
            run = subprocess.run(["vdb_print", file], cwd=self.folder, text=True, capture_output=True)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn(name, run.stdout)

    def test_pyopenvdb_reads_them(self):
        script = ("import pyopenvdb as v\n"
                  "print(v.readMetadata('out/s_crust.vdb')['vug:seed'])\n"
                  "for g in v.readAll('out/s.vdb')[0]: print(g.name, g.valueTypeName, g.activeVoxelCount())\n")
        if subprocess.run(["/usr/bin/python3", "-c", "import pyopenvdb"], capture_output=True).returncode != 0:
            self.skipTest("pyopenvdb is not installed")
        run = subprocess.run(["/usr/bin/python3", "-c", script], cwd=self.folder, text=True, capture_output=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        lines = run.stdout.split("\n")
        self.assertEqual(lines[0], "3")
        self.assertTrue(any(line.startswith("crust_Cd vec3s ") for line in lines), run.stdout)
        self.assertEqual(len({line.split()[2] for line in lines[1:-1]}), 1, "all in one band")

    @unittest.skipUnless(shutil.which("blender"), "Blender is not installed")
    def test_blender_shows_mesh_and_grids(self):
        script = self.write("show.py", BLENDER.format(folder=self.folder / "out"))
        run = subprocess.run(["blender", "--background", "--factory-startup", "--python", script], text=True,
                             capture_output=True)
        said = run.stdout + run.stderr
        self.assertNotIn("Traceback", said)
        self.assertIn("('crust_Cd', 'VECTOR_FLOAT', 3)", said)
        self.assertIn("('crust_u', 'FLOAT', 1)", said)
        self.assertIn("('rock', 'FLOAT', 1)", said)
        # The light of the volume has the hue of its colours.
        seen = {}
        for part in exr.read(self.folder / "out/seen_0001.exr"):
            seen.update(part.pixels)
        red, green, blue = (sum(seen[c]) for c in "RGB")
        self.assertGreater(red, 1)
        self.assertAlmostEqual(green / red, 0.5, delta=0.02)
        self.assertAlmostEqual(blue / red, 0.125, delta=0.02)
        # Blender 3.4 stores the vertex colours of a PLY as 8 bits and treats them as sRGB.
        told = [line.split()[1:] for line in said.splitlines() if line.startswith("colours ")]
        red, green, blue = (float(x) for x in told[0])
        self.assertGreater(red, 0.1)
        self.assertAlmostEqual(green / red, 0.5, delta=0.02)
        self.assertAlmostEqual(blue / red, 0.125, delta=0.02)

    def start(self, *args):
        return subprocess.Popen([PROGRAM, "build", "long.vug", "--checkpoint", "kept.vdb", *args], cwd=self.folder,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def stop_at(self, process, step, how):
        """Sends the signal once this number of steps is in the checkpoint."""
        kept = self.folder / "kept.vdb"
        deadline = time.monotonic() + 120
        while time.monotonic() < deadline and process.poll() is None:
            try:
                if kept.exists() and self.info("kept.vdb")["grids"][0]["metadata"]["vug:step"] >= step:
                    break
            except AssertionError:  # it does not exist yet
                continue
        self.assertIsNone(process.poll(), "it ended too early")
        process.send_signal(how)
        return process.communicate(timeout=60)[1]

    def test_a_resumed_run_writes_the_same_bytes(self):
        self.write("long.vug", SCENE % ('files ["points", "csv"]', 1000))
        self.expect(0, "build", "long.vug", "-o", "whole")
        process = self.start("--checkpoint-every", "0", "-o", "new")
        self.stop_at(process, 300, signal.SIGKILL)
        self.assertFalse((self.folder / "new/long_crust.vdb").exists())
        error = self.expect(2, "build", "long.vug", "-o", "new", "--checkpoint", "kept.vdb").err
        self.assertIn("the checkpoint 'kept.vdb' already exists", error)
        self.assertIn("hint: continue from it with --resume, or remove it", error)
        error = self.expect(2, "build", "long.vug", "-o", "new", "--seed", 4, "--checkpoint", "kept.vdb", "--resume").err
        self.assertIn("belongs to another scene", error)
        # A cancelled run saves its state.
        process = self.start("--resume", "-o", "new", "--checkpoint-every", "0")
        step = self.info("kept.vdb")["grids"][0]["metadata"]["vug:step"]
        said = self.stop_at(process, step + 50, signal.SIGINT)
        self.assertEqual(process.returncode, 3)
        self.assertRegex(said, r"'kept\.vdb' contains the work so far, \d+ of 1000 steps of 'crust'; the same command continues from it")
        self.expect(0, "build", "long.vug", "-o", "new", "--checkpoint", "kept.vdb", "--resume")
        self.assertFalse((self.folder / "kept.vdb").exists())
        for name in os.listdir(self.folder / "whole"):
            self.assertEqual(digest(self.folder / "new" / name), digest(self.folder / "whole" / name), name)

    def test_a_sequence_continues_from_frame_to_frame(self):
        self.write("f.vug", SCENE % ("", "20 * frame"))
        self.expect(0, "build", "f.vug", "-o", "seq", "--frames", "1..3")
        self.assertEqual(sorted(os.listdir(self.folder / "seq")),
                         sorted(f"{stem}.000{i}.{end}" for i in (1, 2, 3)
                                for stem, end in (("f", "vdb"), ("f", "ply"), ("f_crust", "vdb"))))
        self.expect(0, "build", "f.vug", "-o", "one", "--frame", "3")
        for name, other in (("f.ply", "f.0003.ply"), ("f_crust.vdb", "f_crust.0003.vdb")):
            self.assertEqual(digest(self.folder / "one" / name), digest(self.folder / "seq" / other), name)
        self.write("p.vug", SCENE % ("", "20 * frame") + "object ball on crust {}\ncamera main { eye (0, 0, 4) }\n"
                   "light bright = sky(radiance: (1, 1, 1))\nrender main { size 32x24  spp 1 }\n")
        self.expect(0, "render", "p.vug", "-o", "p.####.exr", "--frames", "2..3")
        self.expect(0, "render", "p.vug", "-o", "one.exr", "--frame", "3")
        self.assertEqual(digest(self.folder / "one.exr"), digest(self.folder / "p.0003.exr"))
        self.assertNotEqual(digest(self.folder / "one.exr"), digest(self.folder / "p.0002.exr"))
        self.expect(2, "build", "f.vug", "-o", "seq", "--frames", "1..3", "--frame", "3")
        self.expect(2, "build", "f.vug", "-o", "seq", "--frames", "3..1")

    def test_invalid_files_and_checkpoints(self):
        self.assertIn("--resume requires a checkpoint", self.expect(2, "build", "s.vug", "-o", "x", "--resume").err)
        self.assertIn("a checkpoint of cells is a VDB file of points",
                      self.expect(2, "build", "s.vug", "-o", "x", "--checkpoint", "kept.state").err)
        self.write("bad.vug", SCENE % ('files ["ply"]', 60))
        error = self.expect(2, "check", "bad.vug").err
        self.assertRegex(error, r"bad\.vug:\d+:\d+: error: unknown file of cells 'ply'")
        self.assertIn(error.splitlines()[1][error.splitlines()[2].index("^"):][:5], '"ply"')
        self.write("from.vug", SCENE % ('from "out/s.vdb"', 60))
        self.write("lost.vug", SCENE % ('from "lost.vdb"', 60))
        for verb in (("build", "-o", "x"), ("check",)):
            error = self.expect(2, verb[0], "from.vug", *verb[1:]).err
            self.assertIn("from.vug:4:7: error: 'out/s.vdb' contains no points", error)
            self.assertIn("cannot read 'lost.vdb'", self.expect(2, verb[0], "lost.vug", *verb[1:]).err)


if __name__ == "__main__":
    unittest.main()
