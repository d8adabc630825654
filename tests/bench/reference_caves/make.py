#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the reference caves of docs/performance.md: meshes, a fog volume and the scene files that name them.

    tests/bench/reference_caves/make.py FOLDER [--voxel 0.049]

Runs with Debian's Python (python3-numpy, python3-openvdb) in about a minute and 3 GB of memory. The result depends
only on the voxel size: all noise is lattice noise of seeded generators. Metres, z up. Files:

    cave.ply           a chamber with a tunnel, an alcove, columns and a one-metre shaft open to the sky
    cave_sealed.ply    the same with a lid over the shaft: light in a picture of it is a leak
    crystals_*.ply     1,500 emissive octahedra in three colours on the walls
    fog.vdb            rough fog, a FloatGrid 'density' in [0, 1] with voxels of 0.1 m
    cave_scene.json, cave_fog.json, cave_crystals.json
"""
import argparse
import json
import pathlib

import numpy as np
import pyopenvdb as vdb

SHAFT_TOP = 8.9  # the mesh is cut open at this height


class Lattice:
    """Trilinear lattice noise with smooth fractions over the grid whose axes are `axes`."""

    def __init__(self, seed, axes, low, high, lowest):
        self.random = np.random.default_rng(seed)
        self.axes, self.low, self.high, self.lowest = axes, low, high, lowest

    def __call__(self, frequency):
        size = [int(np.ceil((self.high[i] - self.low[i]) * frequency)) + 3 for i in range(3)]
        values = self.random.uniform(self.lowest, 1, size).astype(np.float32)
        for i in range(3):
            position = (self.axes[i] - self.low[i]) * frequency
            cell = np.floor(position).astype(int)
            fraction = (position - cell).astype(np.float32)
            weight = fraction * fraction * (3 - 2 * fraction)
            weight = weight.reshape([-1 if axis == i else 1 for axis in range(3)])
            values = (np.take(values, cell, axis=i) * (1 - weight)
                      + np.take(values, cell + 1, axis=i) * weight)
        return values


def axes_of(low, high, voxel):
    count = np.ceil((high - low) / voxel).astype(int)
    return [(low[i] + voxel * np.arange(count[i], dtype=np.float32)).astype(np.float32) for i in range(3)]


def cave_distance(axes, low, high, voxel):
    """Negative in air. Distances are only approximate; the mesh is their zero set."""
    x, y, z = axes[0][:, None, None], axes[1][None, :, None], axes[2][None, None, :]

    def ellipsoid(center, radii):
        q = sum(((p - c) / r) ** 2 for p, c, r in zip((x, y, z), center, radii))
        return (np.sqrt(q) - 1) * min(radii)

    def capsule(a, b, radius_a, radius_b):
        a, b = np.array(a, np.float32), np.array(b, np.float32)
        d = b - a
        t = np.clip(((x - a[0]) * d[0] + (y - a[1]) * d[1] + (z - a[2]) * d[2]) / d.dot(d), 0, 1)
        length = np.sqrt((x - a[0] - t * d[0]) ** 2 + (y - a[1] - t * d[1]) ** 2 + (z - a[2] - t * d[2]) ** 2)
        return length - (radius_a + (radius_b - radius_a) * t)

    lattice = Lattice(20240501, axes, low, high, -1)
    noise = sum(amount * lattice(frequency) for frequency, amount in
                ((0.35, 0.9), (0.8, 0.45), (1.7, 0.22), (3.6, 0.11), (6.5, 0.05)))
    air = ellipsoid((0, 0, 0), (10, 5.5, 3.6))
    air = np.minimum(air, capsule((6, 1, 0), (11, 5.5, 1), 1.6, 1.1))
    air = np.minimum(air, ellipsoid((-9, 2.5, 0.5), (2.6, 2.6, 2.2)))
    air = air + noise * 0.85
    air = np.minimum(air, capsule((2.5, 1.0, 1.5), (3.2, 1.6, 9.9), 0.95, 0.75) + noise * 0.18)
    columns = ((-3, 1.5, .55, .35, -4, 4), (4.6, -2.2, .6, .3, -4, 4), (-6, -1.2, .7, .12, -4, -0.4),
               (0.5, 2.6, .5, .08, -4, -0.9), (-1.2, -1.8, .10, .55, 0.9, 4), (2.0, -1.0, .07, .45, 1.4, 4),
               (6.8, 0.6, .08, .6, 0.6, 4), (-4.8, 0.4, .06, .4, 1.3, 4))
    for cx, cy, radius_a, radius_b, bottom, top in columns:
        air = np.maximum(air, -(capsule((cx, cy, bottom), (cx, cy, top), radius_a, radius_b) + noise * 0.12))
    for i, p in enumerate((x, y, z)):  # keeps air away from the sides of the grid, except the top
        air = np.maximum(air, -(p - (low[i] + 4 * voxel)))
        if i < 2:
            air = np.maximum(air, -((high[i] - 4 * voxel) - p))
    return air.astype(np.float32)


def cave_mesh(voxel):
    low, high = np.array([-13., -8., -4.5]), np.array([13., 8., 9.5])
    grid = vdb.FloatGrid()
    grid.background = 3 * voxel
    grid.transform = vdb.createLinearTransform(voxelSize=voxel)
    distance = cave_distance(axes_of(low, high, voxel), low, high, voxel)
    grid.copyFromArray(np.clip(distance, -3 * voxel, 3 * voxel))
    positions, quads = grid.convertToQuads(0.0)
    positions = positions.astype(np.float64) + low
    triangles = np.vstack([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]).astype(np.int64)

    label = np.arange(len(positions))  # connected components: labels spread until nothing changes
    while True:
        smallest = label[triangles].min(1)
        spread = label.copy()
        np.minimum.at(spread, triangles.ravel(), np.repeat(smallest, 3))
        spread = spread[spread]
        spread = spread[spread]
        if (spread == label).all():
            break
        label = spread
    names, counts = np.unique(label, return_counts=True)
    chamber = label[triangles[:, 0]] == names[counts.argmax()]
    triangles = triangles[chamber & (positions[triangles][:, :, 2].max(1) <= SHAFT_TOP)]
    used = np.unique(triangles)
    renumbered = np.full(len(positions), -1)
    renumbered[used] = np.arange(len(used))
    # The quads face the rock; the triangles face the air.
    return positions[used].astype("<f4"), renumbered[triangles].astype("<i4")[:, [0, 2, 1]]


def write_ply(path, positions, triangles):
    faces = np.empty(len(triangles), dtype=[("n", "u1"), ("v", "<i4", 3)])
    faces["n"], faces["v"] = 3, triangles
    header = ("ply\nformat binary_little_endian 1.0\n"
              f"element vertex {len(positions)}\nproperty float x\nproperty float y\nproperty float z\n"
              f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n")
    path.write_bytes(header.encode() + np.asarray(positions, "<f4").tobytes() + faces.tobytes())
    print(f"{path.name}: {len(positions)} vertices, {len(triangles)} triangles")


def write_sealed(path, positions, triangles):
    n = len(positions)
    lid = np.array([[0, -1.5, 8.5], [6, -1.5, 8.5], [6, 4.5, 8.5], [0, 4.5, 8.5]], "<f4")
    write_ply(path, np.vstack([positions, lid]),
              np.vstack([triangles, np.array([[n, n + 1, n + 2], [n, n + 2, n + 3]], "<i4")]))


def write_crystals(folder, positions, triangles):
    random = np.random.default_rng(7)
    corners = positions.astype(float)[triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(normal, axis=1)
    normal /= area[:, None]
    middle = corners.mean(1)
    weight = area * ((middle[:, 2] < 5) & (area > 0))
    weight /= weight.sum()
    for name in ("blue", "green", "amber"):
        points, faces = [], []
        for t in random.choice(len(triangles), 500, p=weight, replace=False):
            up = normal[t]
            x = np.cross(up, [.3, .5, .8])
            x /= np.linalg.norm(x)
            y = np.cross(up, x)
            radius = random.uniform(.012, .03)
            length = random.uniform(2., 4.) * radius
            center = middle[t] + up * length * 0.7
            base = len(points)
            points += [center + x * radius, center + y * radius, center - x * radius, center - y * radius,
                       center + up * length, center - up * length * 0.6]
            for i in range(4):
                j = (i + 1) % 4
                faces += [(base + i, base + j, base + 4), (base + j, base + i, base + 5)]
        write_ply(folder / f"crystals_{name}.ply", np.array(points, "<f4"), np.array(faces, "<i4"))


def write_fog(path):
    voxel, low, high = 0.10, np.array([-12., -7., -4.2]), np.array([12.5, 7., 3.5])
    axes = axes_of(low, high, voxel)
    lattice = Lattice(11, axes, low, high, 0)
    density = 0.5 * lattice(.6) + .3 * lattice(1.4) + .2 * lattice(3.1)
    density = np.clip((density - 0.35) * 2.2, 0, 1) * np.clip((1.2 - axes[2]) / 2.5, 0, 1)[None, None, :]
    density[density < 0.02] = 0
    # The axes are in the wrong order in memory, which turns ground mist into a rough fog. It stays as it is because the
    # published figures were measured with it.
    density = np.ravel(density, order="F").reshape(density.shape)
    grid = vdb.FloatGrid()
    grid.name, grid.gridClass, grid.saveFloatAsHalf = "density", vdb.GridClass.FOG_VOLUME, True
    grid.copyFromArray(density.astype(np.float32))
    grid.transform = vdb.createLinearTransform(voxelSize=voxel)
    grid.transform.translate(tuple(float(x) for x in low))
    vdb.write(str(path), grids=[grid])
    print(f"{path.name}: {grid.activeVoxelCount()} voxels")


def write_scenes(folder):
    cave = {
        "mesh": "cave.ply", "albedo": [0.5, 0.42, 0.34],
        "camera": {"eye": [-5.2, -2.6, 0.2], "target": [4.0, 1.2, 0.5], "up": [0, 0, 1], "hfov_deg": 70.0},
        "lights": [
            {"center": [0.6, -3.4, 0.2], "normal": [0.1, 1.0, 0.1], "up": [0, 0, 1], "size": [0.2, 0.2],
             "radiance": [60, 38, 18]},
            {"center": [8.5, 2.6, 1.0], "normal": [-1.0, -0.2, -0.2], "up": [0, 0, 1], "size": [0.15, 0.3],
             "radiance": [30, 36, 50]},
            {"center": [-8.5, 2.0, 0.5], "normal": [0.6, -1.0, 0.1], "up": [0, 0, 1], "size": [0.1, 0.1],
             "radiance": [80, 50, 22]}],
        "sky": [9, 11, 14],
        "portals": [{"center": [3.15, 1.55, 8.85], "normal": [0, 0, -1], "up": [0, 1, 0], "size": [2.6, 2.6]}]}
    dark = {"sky": [0, 0, 0], "portals": []}
    fog = {"vdb": "fog.vdb", "grid": "density", "scale": 0.3, "albedo": 0.9, "g": 0.4}
    crystals = [{"mesh": f"crystals_{name}.ply", "radiance": radiance} for name, radiance in
                (("blue", [0.6, 1.6, 4.0]), ("green", [0.7, 3.0, 1.0]), ("amber", [4.0, 1.8, 0.5]))]
    for name, scene in (("cave_scene", cave), ("cave_fog", {**cave, **dark, "volume": fog}),
                        ("cave_crystals", {**cave, **dark, "lights": [], "emissive_meshes": crystals})):
        (folder / f"{name}.json").write_text(json.dumps(scene, indent=1) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--voxel", type=float, default=0.049, help="metres; 0.049 gives a million triangles")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    mesh = cave_mesh(options.voxel)
    write_ply(options.folder / "cave.ply", *mesh)
    write_sealed(options.folder / "cave_sealed.ply", *mesh)
    write_crystals(options.folder, *mesh)
    write_fog(options.folder / "fog.vdb")
    write_scenes(options.folder)


main()
