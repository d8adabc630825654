# SPDX-License-Identifier: Apache-2.0
"""The package in the real Blender, which has loaded its own TBB, OpenVDB, Embree and OpenImageIO."""
import hashlib
import os
import shutil
import subprocess
import sys
import unittest

import vug
from case import BALL, Case

BLENDER = shutil.which("blender")

INSIDE = """
import hashlib, os
import bpy
import vug
seen = []
scene = vug.load("ball.vug")
build = scene.build(progress=lambda share, what: seen.append(what))
mesh, image = build.mesh(), build.render()
print("picture", hashlib.sha256(image["beauty"].tobytes()).hexdigest())
made = bpy.data.meshes.new("wall")
made.vertices.add(len(mesh.positions))
made.vertices.foreach_set("co", mesh.positions.ravel())
made.loops.add(3 * len(mesh.triangles))
made.loops.foreach_set("vertex_index", mesh.triangles.ravel().astype("int32"))
made.polygons.add(len(mesh.triangles))
made.polygons.foreach_set("loop_start", [3 * i for i in range(len(mesh.triangles))])
made.polygons.foreach_set("loop_total", [3] * len(mesh.triangles))
made.update(calc_edges=True)
print("valid", not made.validate(), len(made.vertices), len(made.polygons))
build.save("ball.vdb")
bpy.ops.object.volume_import(filepath=os.path.abspath("ball.vdb"))
grids = bpy.context.object.data.grids
grids.load()
print("grids", [g.name for g in grids])
try:
    scene.render(spp=100000, progress=lambda share, what: False)
except vug.Cancelled:
    print("cancelled")
print("stages", "rendering" in seen)
"""


@unittest.skipUnless(BLENDER, "Blender is missing")
class Blender(Case):
    def test_it_works_inside(self):
        self.write("ball.vug", BALL)
        self.write("inside.py", INSIDE)
        done = subprocess.run([BLENDER, "--background", "--factory-startup", "--python-exit-code", "7",
                               "--python", self.folder / "inside.py"],
                              capture_output=True, text=True, timeout=300,
                              env={**os.environ, "PWD": str(self.folder)})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        mesh = vug.load("ball.vug").build().mesh()
        picture = hashlib.sha256(vug.load("ball.vug").render()["beauty"].tobytes()).hexdigest()
        for line in (f"picture {picture}", f"valid True {len(mesh.positions)} {len(mesh.triangles)}",
                     "grids ['rock']", "cancelled", "stages True"):
            self.assertIn(line, done.stdout.splitlines(), done.stdout + done.stderr)


if __name__ == "__main__":
    if not BLENDER:
        print("SKIPPED: blender is not installed: nothing is known of the package inside it")
        sys.exit(0)
    unittest.main()
