#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the noise of one or more programs on the scenes of this folder.

    tests/bench/noise/measure.py --work out --program before=old/vug --program after=build/release/bin/vug

The reference of a scene has four times the width and height and the samples of --reference per pixel, and is averaged
over 4 x 4 pixels: 16 times as many samples per pixel of the picture, and detail that a pixel of the picture cannot
resolve. References are kept in --work; the first program renders those that are missing. The measure of a pixel is the
error of its luminance, divided by the sum of the reference's luminance and a quarter of its log-average: the noise
that `noise` stops at. Columns: root mean square over all pixels, the same without the worst tenth of a percent, the
mean luminance relative to the reference, and the processor time of the program in seconds. Needs oiiotool and numpy.
"""
import argparse
import pathlib
import resource
import subprocess

import numpy

folder = pathlib.Path(__file__).resolve().parent
weights = numpy.array([0.2126, 0.7152, 0.0722])


def read(path, channels="R,G,B"):
    """The channels of an EXR as an array (height, width, 3)."""
    plain = path.with_suffix(".plain.exr")
    subprocess.run(["oiiotool", path, "--ch", channels, "--chnames", "R,G,B", "-d", "float", "--compression", "none",
                    "-o", plain], check=True)
    data = plain.read_bytes()
    plain.unlink()
    size = numpy.frombuffer(data, "<i4", 4, data.index(b"dataWindow\0box2i\0") + 21)
    width, height = size[2] - size[0] + 1, size[3] - size[1] + 1
    block = 8 + 12 * width  # line number, byte count, B, G, R
    lines = numpy.frombuffer(data[len(data) - height * block:], "u1").reshape(height, block)
    return lines[:, 8:].copy().view("<f4").reshape(height, 3, width).transpose(0, 2, 1)[:, :, ::-1].astype(float)


def render(program, scene, size, spp, seed, path, options=()):
    """Renders the scene unless the file exists; returns the processor time in seconds."""
    if path.exists():
        return float(path.with_suffix(".time").read_text())
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "render", scene, "--size", f"{size[0]}x{size[1]}", "--spp", str(spp), "--sample-seed",
                    str(seed), "--float", "--exposure", "auto", "-q", "-o", path, *options], check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime - before.ru_utime
    path.with_suffix(".time").write_text(f"{seconds:.2f}\n")
    return seconds


def averaged(picture):
    height, width, channels = picture.shape
    return picture.reshape(height // 4, 4, width // 4, 4, channels).mean(axis=(1, 3))


def errors(picture, reference):
    """The relative errors of all pixels, and the ratio of the means."""
    light, true = picture @ weights, reference @ weights
    lit = true[true > 0]
    key = numpy.exp(numpy.log(lit).mean()) if lit.size else 1
    return (light - true) / (true + key / 4), light.mean() / true.mean()


def summary(picture, reference):
    error, ratio = errors(picture, reference)
    squares = numpy.sort((error ** 2).ravel())
    kept = squares[:int(0.999 * squares.size)]
    return numpy.sqrt(squares.mean()), numpy.sqrt(kept.mean()), ratio


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", action="append", required=True, metavar="NAME=PATH")
    parser.add_argument("--work", type=pathlib.Path, required=True, help="folder for pictures")
    parser.add_argument("--scene", action="append", type=pathlib.Path, help="instead of all scenes of this folder")
    parser.add_argument("--size", default="128x72")
    parser.add_argument("--spp", type=int, default=32)
    parser.add_argument("--reference", type=int, default=32, help="samples per pixel of the larger reference")
    parser.add_argument("--runs", type=int, default=2, help="pictures with different seeds")
    parser.add_argument("--define", action="append", default=[], metavar="NAME=VALUE", help="as -D of vug render")
    options = parser.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    programs = [each.split("=", 1) for each in options.program]
    size = tuple(map(int, options.size.split("x")))
    scenes = options.scene or sorted(path for path in folder.glob("*.vug") if path.stem != "room")
    defines = [part for each in options.define for part in ("-D", each)]
    print(f"{'scene':24} {'program':10} {'error':>7} {'trimmed':>7} {'mean':>7} {'time':>6}")
    for scene in scenes:
        tag = "_".join([scene.stem, *options.define, options.size])
        path = options.work / f"{tag}_reference_{options.reference}.exr"
        render(programs[0][1], scene, (4 * size[0], 4 * size[1]), options.reference, 1000, path, defines)
        reference = averaged(read(path))
        for name, program in programs:
            rows = []
            for run in range(options.runs):
                picture = options.work / f"{tag}_{options.spp}_{name}_{run}.exr"
                seconds = render(program, scene, size, options.spp, run + 1, picture, defines)
                rows.append((*summary(read(picture), reference), seconds))
            whole, trimmed, ratio, seconds = numpy.array(rows).T
            print(f"{scene.stem:24} {name:10} {numpy.sqrt((whole ** 2).mean()):7.3f} "
                  f"{numpy.sqrt((trimmed ** 2).mean()):7.3f} {ratio.mean():7.3f} {seconds.mean():6.1f}", flush=True)


if __name__ == "__main__":
    main()
