# SPDX-License-Identifier: Apache-2.0
"""The add-on in the real Blender: installs its zip and uses it from a script. in_addon.py runs inside
Blender. Two processes of Blender run; the second opens the file that the first has saved."""
import os
import pathlib
import subprocess
import sys
import unittest
import zipfile

from external_tools import HERE, VugTest, require_blender

ZIP = pathlib.Path(os.environ.get("VUG_ADDON", ""))

# An off-centre ball with colours and water that vary with height, stones in three places, fog, lights
# of each kind that a file can store, a sky, and a cloud with colours and temperature.
SCENE = """param R = 70cm  in 50cm..1m  "radius of the ball"
param LEAN = 10deg  in 0deg..45deg  "how far stones lean"
param WET = true  "water on it"
param SHARE = 50%  in 0%..100%  "of the colour"
volume rock = level_set(sphere(R).translate((1, 2, 3)), voxel: 5cm)
volume stone = level_set(box(size: (0.5, 0.5, 0.5)).rotate(axis: (0, 0, 1), angle: LEAN), voxel: 5cm)
volume mist = fog(sphere(1m), voxel: 25cm)
mesh wall on rock { paint layer(under: (0.8, 0.4, 0.02), over: (0.1, 0.2, 0.9), mask: height(from: 1.5, to: 2.5)) }
mesh pebble on stone {}
object wall on wall { material surface(color: (SHARE, 1, 1), roughness: 0.6, coat: if(WET, height(from: 1.5, to: 2.5), 0)) }
object glow on pebble { emission (2, 1, 0.5) }
place heap { of glow at [(3, 0, 0), (4, 1, 0), pose(position: (5, 0, -1), yaw: 45deg, scale: 2)] }
camera main { eye (0, 2, 6) target (0, 2, 0) fov 60deg }
camera plan { kind orthographic eye (0, 9, 0) target (0, 0, 0) up (0, 0, -1) width 8m }
light ball = sphere(center: (0, 3, 0), radius: 10cm, power: 100)
light window = rect(center: (0, 4, 0), width: 1m, height: 50cm, radiance: (3, 2, 1))
light torch = spot(center: (1, 4, 0), angle: 60deg, edge: 0.2)
light sun = sun(elevation: 30deg, irradiance: (3, 2, 1))
light heaven = daylight(elevation: 30deg)
medium air on mist { kind cloud  extinction 2/m  g 0.25  temperature 1500
  albedo layer(under: (0.9, 0.5, 0.1), over: (0.1, 0.5, 0.9), mask: height(from: -1m, to: 1m)) }
render main { size 320x160 spp 1 }
"""
# A card cut to a leaf, and one with an opacity of a quarter.
LEAF = """mesh blade { of leaf(length: 1m, width: 20cm, rows: 4, card: true) }
object cut on blade { material surface(thin: true, color: (0.1, 0.3, 0.05), subsurface: 1, through: 0.5, opacity: leaf_blade()) }
object pane on blade { material surface(thin: true, color: (0.1, 0.3, 0.05), specular: 0, opacity: 0.25) }
object veil on blade { material surface(thin: true, specular: 0, opacity: attribute(name: "leaf_along")) }
"""

KIT = """param edge = 20cm  in 10cm..1m  "edge of a block"
def block(at) = box(size: edge * (1, 1, 1)).translate(at)
"""
BLOCKS = """include "kit.vug" as rocks
include "kit.vug" as pebbles { edge 10cm }
param HIGH = 1m
volume heap = level_set(rocks.block((0, HIGH, 0)) + pebbles.block((2m, HIGH, 0)), voxel: 2cm)
mesh heap on heap {}
"""


class Addon(VugTest):
    def prepare(self):
        self.write("cave.vug", SCENE)
        # So fine that there is time to cancel it.
        self.write("slow.vug", SCENE.replace("voxel: 5cm", "voxel: 4mm"))
        self.write("bad.vug", SCENE.replace("fog(sphere", "fog(spere"))
        self.write("stones.vug", SCENE)
        self.write("leaf.vug", LEAF)
        self.write("kit.vug", KIT)
        self.write("blocks.vug", BLOCKS)

    def blender(self, part):
        program = require_blender()
        own = {f"BLENDER_USER_{name}": str(self.folder / name.lower())
               for name in ("CONFIG", "SCRIPTS", "DATAFILES")}
        # Blender's Python searches for packages next to the first python3 in the path.
        path = f"{os.path.dirname(program)}:{os.environ['PATH']}"
        done = subprocess.run(
            [program, "--background", "--factory-startup", "--python-exit-code", "1", "--python",
             HERE / "in_addon.py", "--", part, self.folder, ZIP],
            capture_output=True, text=True, timeout=600, env={**os.environ, **own, "PATH": path})
        print("\n".join(line for line in done.stdout.splitlines() if line.startswith(("ok ", "# "))),
              file=sys.stderr)
        self.assertEqual(done.returncode, 0, done.stdout[-20000:] + done.stderr[-5000:])
        self.assertIn("\nALL GOOD\n", done.stdout, done.stdout + done.stderr)

    def test_from_the_zip_to_a_reloaded_file(self):
        self.blender("use")
        self.blender("again")
        # The export of Blender's cube is a solid of the cube's size.
        self.expect(0, "build", "cube.vug", "-o", "out", "-q")
        measured = self.expect(0, "measure", "cube.vug", "--json", "-q").out
        volume = float(measured.split('"volume":')[1].split(",")[0].split("}")[0])
        self.assertAlmostEqual(volume, 6, delta=6 * 5e-3)

    def test_the_zip_contains_only_the_add_on(self):
        with zipfile.ZipFile(ZIP) as zipped:
            names = [name for name in zipped.namelist() if not name.endswith("/")]
        wanted = sorted(f"vug_addon/{path.name}" for path in
                        (HERE.parents[1] / "plugins/blender/vug_addon").glob("*.py"))
        self.assertEqual(sorted(names), wanted)


if __name__ == "__main__":
    require_blender()
    if not ZIP.is_file():
        print("SKIPPED: the add-on is not built")
        sys.exit(0)
    unittest.main()
