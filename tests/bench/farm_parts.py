#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the processor time of the parts of a farmed picture with that of the picture at once.

    tests/bench/farm_parts.py build/release/bin/vug data/scenes/grotto.vug -D voxel=12cm --size 320x180 --spp 100
    tests/bench/farm_parts.py build/release/bin/vug SCENE --parts 10 --spp 40

Options other than --parts are passed to `vug render` and `vug farm plan`. Times are user and system time of all
processes. The picture and the job begin with an empty store each; then both run again with the filled store. The
pictures must have the same bytes.
"""
import hashlib
import os
import pathlib
import resource
import subprocess
import sys
import tempfile


def processor_seconds(command, store, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, cwd=folder, env={**os.environ, "VUG_CACHE": str(store)}, capture_output=True,
                          text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stderr}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def digest(file):
    return hashlib.sha256(file.read_bytes()).hexdigest()


def main():
    arguments = sys.argv[1:]
    parts = "25"
    if "--parts" in arguments:
        at = arguments.index("--parts")
        parts = arguments[at + 1]
        del arguments[at:at + 2]
    if len(arguments) < 2:
        sys.exit(__doc__)
    program, scene = (pathlib.Path(each).resolve() for each in arguments[:2])
    options = arguments[2:]
    with tempfile.TemporaryDirectory(prefix="vug_farm_parts_") as name:
        folder = pathlib.Path(name)
        print(f"{'store':8} {'picture':>10} {parts + ' parts':>10} {'ratio':>7}")
        for store in ("empty", "filled"):
            alone = processor_seconds([program, "render", scene, "-o", "picture.exr", "--quiet", *options],
                                      folder / "store_of_picture", folder)
            job = folder / f"job_{store}"
            plan = processor_seconds([program, "farm", "plan", scene, "-o", job, "--parts", parts, "--quiet",
                                      *options], folder / "store_of_job", folder)
            run = plan + processor_seconds([program, "farm", "run", job], folder / "store_of_job", folder)
            merged = job / f"{scene.stem}.exr"
            if digest(merged) != digest(folder / "picture.exr"):
                sys.exit("the merged picture differs from the picture at once")
            print(f"{store:8} {alone:8.1f} s {run:8.1f} s {run / alone:7.2f}")
            if store == "empty":
                print(f"         of which the plan {plan:.1f} s")


if __name__ == "__main__":
    main()
