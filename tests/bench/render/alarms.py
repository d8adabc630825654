#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Counts the alarms of `vug diff`: renders of one scene that differ only by their samples must pass; a
picture that is one percent darker and one with another material must fail.

    tests/bench/render/alarms.py build/release/bin/vug counts.txt [--renders 100] [--alarm 0.01]

Every verdict is appended to counts.txt at once, and a later run continues after the last line. The renders
share one reference, as in regression tests, so their alarms are slightly more correlated than if each
render had its own.
"""
import argparse
import collections
import json
import os
import pathlib
import subprocess
import sys
import tempfile

SCENE = """
param LIGHT = 1 in 0..2 "part of the lamp's light"
seed 5
volume walls = level_set(shell(displace(box(size: (4, 3, 4)), noise: fbm(scale: 1.2, octaves: 3), amount: 15cm), thickness: 25cm), voxel: 10cm)
volume stones = level_set(sphere(50cm).translate((-0.7, -1.1, -0.4)) + box(size: (0.6, 0.9, 0.6)).translate((0.9, -1.1, 0.2)), voxel: 5cm)
mesh wall on walls {}
mesh stone on stones {}
material rock = lambert(albedo: (0.5, 0.45, 0.4))
material wet  = surface(color: (0.45, 0.36, 0.28), coat: 0.6, coat_roughness: 0.25)
material dry  = surface(color: (0.45, 0.36, 0.28))
object around on wall { material rock }
object things on stone { material MATERIAL }
camera main { eye (0, 0, 1.6)  target (0, -0.4, 0)  fov 75deg }
light lamp = sphere(center: (1, 0.7, 0.3), radius: 15cm, radiance: LIGHT * (20, 16, 12))
render main { size 64x48  spp 256  integrator path(max_bounces: 2) }
"""


def verdicts(path):
    return dict(line.split(None, 1) for line in path.read_text().splitlines()) if path.exists() else {}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("vug", type=pathlib.Path)
    parser.add_argument("counts", type=pathlib.Path)
    parser.add_argument("--renders", type=int, default=100)
    parser.add_argument("--alarm", type=float, default=0.01)
    parser.add_argument("--nice", type=int, default=19, help="how far behind other work it stands")
    options = parser.parse_args()
    os.nice(options.nice)
    vug = options.vug.resolve()
    known = verdicts(options.counts)

    with tempfile.TemporaryDirectory(prefix="vug_alarms_") as room:
        room = pathlib.Path(room)
        for name in ("wet", "dry"):
            (room / f"{name}.vug").write_text(SCENE.replace("MATERIAL", name))

        def render(to, samples, scene="wet", light=1.0):
            subprocess.run([vug, "render", f"{scene}.vug", "-o", to, "--sample-seed", str(samples), "-D",
                            f"LIGHT={light}", "--quiet"], cwd=room, check=True, stdout=subprocess.DEVNULL)

        def judge(name, *how, **what):
            if name in known:
                return
            if not (room / "reference.exr").exists():
                render("reference.exr", 0)
            render("test.exr", *how, **what)
            said = subprocess.run([vug, "diff", "reference.exr", "test.exr", "--alarm", str(options.alarm), "--layer",
                                   "beauty", "--quiet", "--json", "verdict.json"], cwd=room, stdout=subprocess.DEVNULL)
            if said.returncode not in (0, 1):
                sys.exit(f"vug diff failed on {name}")
            known[name] = "same" if said.returncode == 0 else "different"
            with options.counts.open("a") as counts:
                counts.write(f"{name} {known[name]}\n")

        for i in range(5):  # each is compared with the reference and has its own samples
            judge(f"darker{i}", 5000 + i, light=0.99)
            judge(f"swapped{i}", 6000 + i, scene="dry")
        for i in range(options.renders):
            judge(f"reseed{i}", 1 + i)

    tally = collections.Counter((name.rstrip("0123456789"), verdict) for name, verdict in known.items())
    print(json.dumps({f"{kind} {verdict}": n for (kind, verdict), n in sorted(tally.items())}))
    alarms, allowed = tally["reseed", "different"], options.alarm * options.renders
    good = alarms <= allowed and not tally["darker", "same"] and not tally["swapped", "same"]
    print(f"{alarms} alarms in {options.renders} renders, {allowed:g} allowed")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
