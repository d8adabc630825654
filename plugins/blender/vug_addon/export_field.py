# SPDX-License-Identifier: Apache-2.0
"""Exports closed meshes of Blender as fields of a scene, e.g. blocked-out shapes that a grammar details."""
import os

import bpy
import numpy

from . import units
from .atomic_file import replacing


def triangles_of(thing, depsgraph):
    """Vertices in metres with y up, and triangles, of the object with modifiers and transform applied."""
    evaluated = thing.evaluated_get(depsgraph)
    mesh = evaluated.to_mesh()
    try:
        mesh.calc_loop_triangles()
        points = numpy.empty(3 * len(mesh.vertices), numpy.float32)
        mesh.vertices.foreach_get("co", points)
        corners = numpy.empty(3 * len(mesh.loop_triangles), numpy.int32)
        mesh.loop_triangles.foreach_get("vertices", corners)
    finally:
        evaluated.to_mesh_clear()
    place = numpy.array(thing.matrix_world, numpy.float64)
    points = (points.reshape(-1, 3) @ place[:3, :3].T + place[:3, 3]) * units.metres_per_unit()
    corners = corners.reshape(-1, 3)
    if numpy.linalg.det(place[:3, :3]) < 0:
        corners = corners[:, ::-1]
    return numpy.stack([points[:, 0], points[:, 2], -points[:, 1]], 1), corners


def require_closed(name, triangles):
    """Raises ValueError unless the triangles bound a solid."""
    if not len(triangles):
        raise ValueError(f"'{name}' has no faces")
    a = triangles.ravel().astype(numpy.int64)
    b = triangles[:, (1, 2, 0)].ravel().astype(numpy.int64)
    size = int(triangles.max()) + 1
    _, counts = numpy.unique(numpy.minimum(a, b) * size + numpy.maximum(a, b), return_counts=True)
    if (counts == 1).any():
        raise ValueError(f"'{name}' is open: {int((counts == 1).sum())} edges have a face on one side only; "
                         "fill the holes first")
    if (counts > 2).any():
        raise ValueError(f"'{name}' does not bound a solid: {int((counts > 2).sum())} edges have more than two faces")
    if len(numpy.unique(a * size + b)) < len(a):
        raise ValueError(f"the faces of '{name}' are oriented inconsistently: recalculate its normals first")


def require_solid(name, points, triangles):
    """The volume enclosed by the triangles, positive if their normals point outwards. Raises ValueError for a
    flat mesh: twice the volume divided by the area approximates the thickness, which must exceed a millionth
    of the length, about the precision of 32 bits."""
    volume, area = volume_of(points, triangles), area_of(points, triangles)
    length = float(numpy.linalg.norm(points.max(0) - points.min(0)))
    if not numpy.isfinite(volume) or not numpy.isfinite(length):
        raise ValueError(f"'{name}' has vertices at infinity")
    if 2 * abs(volume) <= 1e-6 * length * area:
        raise ValueError(f"'{name}' encloses no volume: it is flat, or its parts cancel out; add thickness first")
    return volume


def area_of(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return float(numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum() / 2)


def volume_of(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return float((a * numpy.cross(b, c)).sum() / 6)


def ply(points, triangles):
    head = (f"ply\nformat binary_little_endian 1.0\ncomment from Blender, metres, y up\n"
            f"element vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
            f"element face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n")
    faces = numpy.empty(len(triangles), [("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, triangles
    return head.encode() + numpy.ascontiguousarray(points, "<f4").tobytes() + faces.tobytes()


def scene(title, file, voxel):
    return f"""# The solid of the mesh {title!a} of Blender; change it there and export again.
param voxel = {voxel:.6g}m  in {voxel / 8:.6g}m..{voxel * 16:.6g}m  "edge of a voxel"
let block = mesh("{file}")

volume rock = level_set(block, voxel: voxel)
mesh wall on rock {{}}
"""


def file_of(path, extension, example):
    """The path of the output file. Raises ValueError if it is not usable."""
    path = bpy.path.abspath(path)
    name, folder = os.path.basename(path), os.path.dirname(path)
    if not name or os.path.isdir(path):
        raise ValueError(f"choose a name for the file, such as {example}")
    end = os.path.splitext(name)[1]
    if end.lower() not in ("", extension):
        raise ValueError(f"'{name}' must end in {extension}, the format that the scene reads")
    if folder and not os.path.isdir(folder):
        raise ValueError(f"the folder '{folder}' does not exist")
    return path if end else path + extension


def replace(path, data):
    with replacing(path) as temporary, open(temporary, "wb") as file:
        file.write(data)


def write(thing, depsgraph, path, voxel):
    """Writes the mesh and, unless a scene of that name exists, a scene next to it; an edited scene is never
    overwritten. Returns a summary in one sentence."""
    path = file_of(path, ".ply", "block.ply")
    points, triangles = triangles_of(thing, depsgraph)
    require_closed(thing.name, triangles)
    volume = require_solid(thing.name, points, triangles)
    if volume < 0:
        triangles, volume = triangles[:, ::-1], -volume
    replace(path, ply(points, triangles))
    text = os.path.splitext(path)[0] + ".vug"
    message = f"{len(triangles)} triangles around {volume:.6g} m3"
    if (points.max(0) - points.min(0)).min() < 2 * voxel:
        message += f"; it is thinner than two voxels of {voxel:.6g} m and may have holes"
    if os.path.exists(text):
        return f"{message}; {os.path.basename(text)} exists and is kept"
    replace(text, scene(thing.name, os.path.basename(path), voxel).encode())
    return message
