"""Closed meshes of Blender as fields of a scene: what was blocked out by hand, for a grammar to dress."""
import os

import numpy

from .whole import replacing


def triangles_of(thing, depsgraph):
    """Vertices in metres with y up and triangles, of the object with its modifiers, where it stands."""
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
    points = points.reshape(-1, 3) @ place[:3, :3].T + place[:3, 3]
    corners = corners.reshape(-1, 3)
    if numpy.linalg.det(place[:3, :3]) < 0:
        corners = corners[:, ::-1]
    return numpy.stack([points[:, 0], points[:, 2], -points[:, 1]], 1), corners


def require_closed(name, triangles):
    """ValueError where the triangles bound no solid."""
    if not len(triangles):
        raise ValueError(f"'{name}' has no faces")
    a = triangles.ravel().astype(numpy.int64)
    b = triangles[:, (1, 2, 0)].ravel().astype(numpy.int64)
    size = int(triangles.max()) + 1
    _, counts = numpy.unique(numpy.minimum(a, b) * size + numpy.maximum(a, b), return_counts=True)
    if (counts == 1).any():
        raise ValueError(f"'{name}' is open: {int((counts == 1).sum())} edges have a face on one side only; "
                         "fill its holes first")
    if (counts > 2).any():
        raise ValueError(f"'{name}' bounds no solid: {int((counts > 2).sum())} edges have more than two faces")
    if len(numpy.unique(a * size + b)) < len(a):
        raise ValueError(f"the faces of '{name}' look to different sides: recalculate its normals first")


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


def replace(path, data):
    with replacing(path) as beside, open(beside, "wb") as file:
        file.write(data)


def write(thing, depsgraph, path, voxel):
    """Writes the mesh, and beside it a scene where none of that name is: what an artist has made of it
    stays. Gives a sentence."""
    points, triangles = triangles_of(thing, depsgraph)
    require_closed(thing.name, triangles)
    volume = volume_of(points, triangles)
    if volume < 0:
        triangles, volume = triangles[:, ::-1], -volume
    replace(path, ply(points, triangles))
    text = os.path.splitext(path)[0] + ".vug"
    told = f"{len(triangles)} triangles around {volume:.6g} m3"
    if os.path.exists(text):
        return f"{told}; {os.path.basename(text)} is there already and stays"
    replace(text, scene(thing.name, os.path.basename(path), voxel).encode())
    return told
