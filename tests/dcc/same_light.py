#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Renders one scene with Vug and, through the add-on, with Blender's Cycles, and compares the light.

    PYTHONPATH=build/release/python tests/dcc/same_light.py cave out.png [--size 320x180] [--spp 256] [--runs 4]

Camera and lights are the same; the rock is Lambertian with varying colour. Prints the differences of the means of
red, green and blue and the number of blocks of 20x20 pixels that differ by more than three standard errors, which
are estimated from runs with different seeds; writes both pictures side by side. The exit code is 1 if the means
differ by more than 1 % or if more than 1 % of the blocks differ. `cave` is lit by three lights, none of which is
in the picture, `open` by a sky, which is in the picture. The cave's rock has flat shading: light between the
horizon of a facet and that of its smooth normal, which Cycles cuts off and Vug keeps, would be half a percent there.
"""
import argparse
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

import numpy
import vug

HERE = pathlib.Path(__file__).resolve().parent
BOUNCES = 6
# A visible sky has no noise, but the two renderers interpolate between its texels with different rounding.
LOOKUP = {"cave": 0, "open": 0.003}
RENDER = f"render main {{ size 320x180 spp 64 integrator path(max_bounces: {BOUNCES}) }}\n"
SCENES = {"cave": """seed 4
let walls = shell(displace(box(size: (7, 4, 8), rounding: 1), noise: fbm(scale: 2, octaves: 4), amount: 50cm), thickness: 20cm)
let pillar = displace(cylinder(radius: 0.5, height: 6), noise: fbm(scale: 1), amount: 20cm)
volume rock = level_set(walls + pillar.translate((-1.2, 0, -1)) + pillar.translate((1.4, 0, -2)), voxel: 6cm)
mesh wall on rock { paint layer(under: (0.5, 0.3, 0.2), over: (0.3, 0.45, 0.6), mask: height(from: -1, to: 1)) }
object wall on wall { flat true  material lambert(albedo: (0.9, 0.9, 0.9)) }
light lamp = sphere(center: (2.3, 0.4, 1.5), radius: 12cm, power: 60)
light window = rect(center: (-2, 1.2, 1.8), normal: (0.5, -0.6, -1), width: 80cm, height: 50cm, radiance: (6, 9, 14))
light panel = disk(center: (0.6, 1.4, 0.8), normal: (-0.3, -1, -0.4), radius: 30cm, radiance: (12, 7, 4))
camera main { eye (0, 0, 2.9) target (0, -0.3, -2) fov 70deg }
""", "open": """seed 4
let stones = sphere(0.9).translate((-1.3, 0.3, 0)) + box(size: (1, 2, 1)).translate((1.2, 0.6, -1))
volume ground = level_set(displace(half_space(), noise: fbm(scale: 2, octaves: 3), amount: 20cm) + stones,
                          voxel: 6cm, from: (-5, -0.5, -5), to: (5, 3, 5))
mesh land on ground { paint (0.6, 0.5, 0.4) }
object land on land { material lambert(albedo: (0.9, 0.9, 0.9)) }
light heaven = daylight(elevation: 25deg, azimuth: 130deg, gain: 0.1)
camera main { eye (0.5, 1.5, 6) target (0, 0.9, 0) fov 60deg }
"""}


def cycles(folder, size, spp, runs):
    program = shutil.which(os.environ.get("VUG_BLENDER", "blender"))
    if not program:
        print("SKIPPED: Blender is missing (Debian's package blender)")
        sys.exit(0)
    path = f"{os.path.dirname(program)}:{os.environ['PATH']}"
    subprocess.run([program, "--background", "--factory-startup", "--python-exit-code", "1", "--python",
                    HERE / "in_same_light.py", "--", folder, HERE.parents[1] / "plugins/blender",
                    *map(str, (*size, spp, runs, BOUNCES))],
                   check=True, stdout=subprocess.DEVNULL,
                   env={**os.environ, "PATH": path, "BLENDER_USER_DATAFILES": f"{folder}/data"})
    return numpy.stack([numpy.load(f"{folder}/cycles_{run}.npy") for run in range(runs)])


def ours(folder, size, spp, runs):
    build = vug.load(f"{folder}/same.vug").build()
    return numpy.stack([numpy.array(build.render(size=size, spp=spp, seed=run + 1)["beauty"], numpy.float64)
                        for run in range(runs)])


def blocks(values, size):
    rows, columns = values.shape[0] // size, values.shape[1] // size
    return values[:rows * size, :columns * size].reshape(rows, size, columns, size, 3).mean((1, 3))


def z_scores(a, b, size, lookup):
    """Z-scores of the blocks' means. Pixels are independent, so the variance of a block's mean follows from that
    of its pixels between runs."""
    variance = sum(blocks(each.var(0, ddof=1) / len(each), size) / size**2 for each in (a, b))
    means = blocks(a.mean(0), size), blocks(b.mean(0), size)
    return (means[0] - means[1]) / numpy.sqrt(variance + (lookup * means[1]) ** 2)


def write_png(path, linear):
    srgb = numpy.where(linear < 0.0031308, 12.92 * linear,
                       1.055 * numpy.maximum(linear, 1e-9) ** (1 / 2.4) - 0.055)
    pixels = (numpy.clip(srgb, 0, 1) * 255 + 0.5).astype(numpy.uint8)
    height, width = pixels.shape[:2]
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    pathlib.Path(path).write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
        chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scene", choices=SCENES)
    parser.add_argument("picture", nargs="?", help="a .png of both, side by side")
    parser.add_argument("--size", default="320x180")
    parser.add_argument("--spp", type=int, default=256, help="of all runs together")
    parser.add_argument("--runs", type=int, default=4)
    parser.add_argument("--block", type=int, default=20, help="pixels along a block")
    options = parser.parse_args()
    size, each = tuple(map(int, options.size.split("x"))), options.spp // options.runs
    with tempfile.TemporaryDirectory(prefix="vug_same_light_") as folder:
        pathlib.Path(folder, "same.vug").write_text(SCENES[options.scene] + RENDER)
        a = ours(folder, size, each, options.runs)
        b = cycles(folder, size, each, options.runs)
    means = a.mean((0, 1, 2)), b.mean((0, 1, 2))
    apart = means[0] / means[1] - 1
    z = z_scores(a, b, options.block, LOOKUP[options.scene])
    beyond = float((abs(z) > 3).any(-1).mean())
    print(f"mean radiance, Vug    {means[0]}\nmean radiance, Cycles {means[1]}")
    print(f"apart {100 * apart} %")
    print(f"blocks beyond 3 standard errors: {100 * beyond:.2f} % of {z.shape[0] * z.shape[1]}, "
          f"farthest {abs(z).max():.2f}, root of mean square {numpy.sqrt((z**2).mean()):.2f}")
    gap = numpy.ones((size[1], 4, 3))
    if options.picture:
        write_png(options.picture, numpy.concatenate([a.mean(0), gap, b.mean(0)], 1) * 0.25 / means[1].mean())
    return int(abs(apart).max() > 0.01 or beyond > 0.01)


sys.exit(main())
