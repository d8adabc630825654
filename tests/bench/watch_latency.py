#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Seconds from a saved scene to its picture on disk, for edits of the grotto in `vug watch`.

    tests/bench/watch_latency.py build/release/bin/vug [option of vug watch]...

Prints for each edit the time until the first unfinished picture and until the complete one, the processor time, which
other programs do not change, and what was built.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

SCENE = pathlib.Path(__file__).resolve().parents[2] / "data/scenes/grotto.vug"
OPTIONS = ["-D", "voxel=12cm", "--size", "320x180", "--spp", "4", "--no-page"]
EDITS = [  # name, old text, new text; each edit starts from the text of the last one
    ("comment", "# The demo:", "# The demonstration:"),
    ("exposure", "exposure 0.5", "exposure 0.6"),
    ("lamp", "radiance: (60, 28, 9.5)", "radiance: (80, 28, 9.5)"),
    ("camera", "eye (-6.9, 1.5, 1.9)", "eye (-6.7, 1.5, 1.9)"),
    ("material", "lambert(albedo: (0.06, 0.02, 0.018))", "lambert(albedo: (0.02, 0.06, 0.018))"),
    ("person", "translate((2.4, 0.55, -2.6))", "translate((2.2, 0.55, -2.6))"),
    ("one block of the heap", "azimuth: 37deg, seed: 4, floor: -15cm", "azimuth: 37deg, seed: 5, floor: -15cm"),
    ("all: thickness of the beds", "thickness: 85cm, ledge", "thickness: 80cm, ledge"),
]


def main():
    program, *options = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "grotto.vug"
        text = SCENE.read_text()
        scene.write_text(text)
        picture = scene.with_suffix(".png")
        watch = subprocess.Popen([str(pathlib.Path(program).resolve()), "watch", str(scene), "-o", str(picture), *OPTIONS,
                                  *options], stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)

        def processor_seconds():
            fields = pathlib.Path(f"/proc/{watch.pid}/stat").read_text().rsplit(")", 1)[1].split()
            return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

        def row(name, begin, before=0):
            first = None
            for line in watch.stderr:
                if first is None and line.startswith("unfinished picture"):
                    first = time.monotonic() - begin
                found = re.match(r"picture after .*?: (.*)", line)
                if found:
                    done = time.monotonic() - begin
                    spent = processor_seconds() - before
                    print(f"{name:28} {first or done:6.2f} s {done:7.2f} s {spent:7.2f} s  {found.group(1)}", flush=True)
                    return
            sys.exit("vug watch ended")

        print(f"{'edit':28} {'first':>8} {'complete':>9} {'processor':>9}")
        row("start", time.monotonic())
        for name, old, new in EDITS:
            if text.count(old) != 1:
                sys.exit(f"the scene does not contain '{old}' once")
            text = text.replace(old, new)
            new_file = scene.with_suffix(".new")
            new_file.write_text(text)
            begin, before = time.monotonic(), processor_seconds()
            new_file.rename(scene)
            row(name, begin, before)
        watch.terminate()
        watch.wait()


if __name__ == "__main__":
    main()
