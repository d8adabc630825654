# SPDX-License-Identifier: Apache-2.0
"""The vug command of tests/cli, and the external programs that read its files."""
import json
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "cli"))
from vug import SOURCE, VugTest  # noqa: E402, F401

# A coloured cube of 1 m that stands on the ground, off-centre so that mirrored axes are detected; balls
# of 60 cm in three places; fog; cameras of both kinds; a light of each kind.
SCENE = """seed 3
volume rock = level_set(box(size: (1, 1, 1)).translate((1, 0.5, 2)), voxel: 5cm)
volume stone = level_set(sphere(30cm), voxel: 5cm)
volume mist = fog(sphere(1m).translate((0, 2, 0)), voxel: 20cm)
mesh wall on rock { paint layer(under: (0.8, 0.4, 0.02), over: (0.1, 0.2, 0.9), mask: height(from: 0.1, to: 0.9)) }
mesh pebble on stone {}
object wall on wall { material surface(color: (0.5, 1, 1), roughness: 0.6, coat: height(from: 0.1, to: 0.9)) }
object glow on pebble { emission (2, 1, 0.5) }
place heap { of glow at [(3, 0, 0), (4, 1, 0), pose(position: (5, 0, -1), yaw: 45deg, scale: 2)] }
camera main { eye (0, 2, 6) target (0, 2, 0) fov 60deg }
camera plan { kind orthographic eye (0, 9, 0) target (0, 0, 0) up (0, 0, -1) width 8m }
light ball = sphere(center: (0, 3, 0), radius: 10cm, power: 100)
light window = rect(center: (0, 4, 0), width: 1m, height: 50cm)
light lens = disk(center: (0, 4, 1), radius: 20cm)
light torch = spot(center: (1, 4, 0), angle: 60deg, edge: 0.2)
light sun = sun(elevation: 30deg, irradiance: (3, 2, 1))
light heaven = daylight(elevation: 30deg)
render main { size 320x160 spp 1 }
"""


def skip(reason):
    print(f"SKIPPED: {reason}")
    sys.exit(0)


def require_blender():
    program = os.environ.get("VUG_BLENDER", "")
    if not shutil.which(program):
        skip("Blender is missing (Debian's package blender)")
    return program


def require_node():
    """Node and the folder where tools/dev/install_node_packages has put the readers."""
    program, packages = os.environ.get("VUG_NODE", ""), os.environ.get("VUG_NODE_PACKAGES", "")
    if not shutil.which(program):
        skip("Node is missing (Debian's package npm installs it)")
    if not (pathlib.Path(packages) / "complete").exists():
        skip("readers of glTF and USD are not installed: tools/dev/install_node_packages does it")
    return program, pathlib.Path(packages)


def node(script, *arguments):
    """The JSON output of a script of this folder, which runs in the folder of the packages that it imports."""
    program, packages = require_node()
    copy = packages / script
    copy.write_bytes((HERE / script).read_bytes())
    done = subprocess.run([program, copy, *map(str, arguments)], capture_output=True, text=True, timeout=300)
    if done.returncode != 0:
        raise AssertionError(f"{script} failed:\n{done.stdout}\n{done.stderr}")
    return json.loads(done.stdout.splitlines()[-1])
