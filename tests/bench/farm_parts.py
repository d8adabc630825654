#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the processor time of the parts of a farmed picture with that of the picture at once.

    tests/bench/farm_parts.py build/release/bin/vug data/scenes/grotto.vug -D voxel=12cm --size 320x180 --spp 100
    tests/bench/farm_parts.py build/release/bin/vug SCENE --parts 10 --spp 40

Options other than --parts and --stores are passed to `vug render` and `vug farm plan`. Times are user and system time
of all processes. The picture and the jobs begin with an empty store each; then all run again with the filled store. A
job runs in three ways: each task in a process of its own, in the chunks that the plan suggests, and as one chunk, which is
how `vug farm run JOB` runs it. The pictures must have the same bytes.

    tests/bench/farm_parts.py PROGRAM SCENE --stores filled    # without the measurement of empty stores
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


def taken(arguments, name, default):
    """The value of an option, which is removed from the arguments."""
    if name not in arguments:
        return default
    at = arguments.index(name)
    value = arguments[at + 1]
    del arguments[at:at + 2]
    return value


def chunks(job):
    """The calls of `vug farm run` in the ninja file of the job, in order."""
    lines = (job / "build.ninja").read_text().splitlines()
    calls = [line.split(" = ") for line in lines if line.startswith(("  id = ", "  ids = "))]
    return [("--task" if key.strip() == "id" else "--tasks", value) for key, value in calls]


def main():
    arguments = sys.argv[1:]
    parts = taken(arguments, "--parts", "25")
    stores = taken(arguments, "--stores", "empty,filled").split(",")
    if len(arguments) < 2:
        sys.exit(__doc__)
    program, scene = (pathlib.Path(each).resolve() for each in arguments[:2])
    options = arguments[2:]
    ways = {"single tasks": ["--chunk", "1"], "chunks": [], "one worker": []}
    with tempfile.TemporaryDirectory(prefix="vug_farm_parts_") as name:
        folder = pathlib.Path(name)
        if "empty" not in stores:
            small = list(options)
            for option in ("--size", "--spp"):
                taken(small, option, None)
            processor_seconds([program, "render", scene, "-o", "small.exr", "--quiet", "--size", "32x18", "--spp", "1",
                               *small], folder / "store_picture", folder)
        print(f"{'store':8} {'way':14} {'seconds':>8} {'ratio':>6} {'plan':>6} {'calls':>6}")
        for store in stores:
            alone = processor_seconds([program, "render", scene, "-o", "picture.exr", "--quiet", *options],
                                      folder / "store_picture", folder)
            print(f"{store:8} {'picture':14} {alone:8.1f}", flush=True)
            for way, chosen in ways.items():
                cache = folder / f"store_{way if 'empty' in stores else 'picture'}"
                job = folder / f"job_{store}_{way}".replace(" ", "_")
                plan = processor_seconds([program, "farm", "plan", scene, "-o", job, "--parts", parts, "--quiet",
                                          *chosen, *options], cache, folder)
                calls = [()] if way == "one worker" else chunks(job)
                run = plan + sum(processor_seconds([program, "farm", "run", job, *call], cache, folder)
                                 for call in calls)
                if digest(job / f"{scene.stem}.exr") != digest(folder / "picture.exr"):
                    sys.exit("the merged picture differs from the picture at once")
                print(f"{store:8} {way:14} {run:8.1f} {run / alone:6.2f} {plan:6.1f} {len(calls):6}", flush=True)


if __name__ == "__main__":
    main()
