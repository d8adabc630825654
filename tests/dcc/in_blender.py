# SPDX-License-Identifier: Apache-2.0
"""Runs inside Blender: imports a set of vug export and prints the resulting data as JSON.

blender --background --factory-startup --python in_blender.py -- FOLDER NAME VOLUME
"""
import json
import sys

import bpy
import numpy

# Debian 12 combines Blender 3.4 with a numpy that has removed a name that Blender's glTF importer uses.
if "bool" not in numpy.__dict__:
    numpy.bool = bool

folder, name, volume = sys.argv[sys.argv.index("--") + 1:]


def vectors(items, attribute):
    values = numpy.empty(3 * len(items), dtype=numpy.float64)
    items.foreach_get(attribute, values)
    return values.reshape(-1, 3)


def measures(mesh):
    """Bounds, the volume enclosed by the triangles, and the agreement of their normals with those of the vertices."""
    points = vectors(mesh.vertices, "co")
    mesh.calc_loop_triangles()
    corners = numpy.empty(3 * len(mesh.loop_triangles), dtype=numpy.int64)
    mesh.loop_triangles.foreach_get("vertices", corners)
    a, b, c = (points[corners.reshape(-1, 3)[:, k]] for k in range(3))
    across = numpy.cross(b - a, c - a)
    return {"vertices": len(points), "triangles": len(a),
            "low": points.min(0).tolist(), "high": points.max(0).tolist(),
            "volume": float((a * across).sum() / 6), "points": points, "across": across,
            "middles": (a + b + c) / 3}


def plain(found):
    return {key: value for key, value in found.items() if not isinstance(value, numpy.ndarray)}


bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=f"{folder}/{name}.glb")
out = {"version": bpy.app.version_string, "objects": {}, "lights": {}, "cameras": {}}
for thing in bpy.data.objects:
    out["objects"][thing.name] = {"type": thing.type, "place": [list(row) for row in thing.matrix_world]}
for light in bpy.data.lights:
    out["lights"][light.name] = {"type": light.type, "energy": light.energy, "color": list(light.color)}
for camera in bpy.data.cameras:
    out["cameras"][camera.name] = {"type": camera.type, "angle_y": camera.angle_y,
                                   "ortho_scale": camera.ortho_scale}

wall = bpy.data.objects["wall"].data
ours = measures(wall)
colors = wall.color_attributes[0]
values = numpy.empty(4 * len(colors.data), dtype=numpy.float64)
colors.data.foreach_get("color", values)
vertices = numpy.empty(len(wall.loops), dtype=numpy.int64)
wall.loops.foreach_get("vertex_index", vertices)
out["wall"] = {**plain(ours), "domain": colors.domain,
               "colors": [[*ours["points"][v].tolist(), *values.reshape(-1, 4)[i, :3].tolist()]
                          for i, v in enumerate(vertices) if i % 7 == 0]}

bpy.ops.object.volume_import(filepath=f"{folder}/{name}_{volume}.vdb", directory=folder,
                             files=[{"name": f"{name}_{volume}.vdb"}])
imported = bpy.context.object
imported.data.grids.load()
out["grids"] = [grid.name for grid in imported.data.grids]
surface = bpy.data.objects.new("surface", bpy.data.meshes.new("surface"))
bpy.context.collection.objects.link(surface)
modifier = surface.modifiers.new("mesh", "VOLUME_TO_MESH")
modifier.object, modifier.threshold, modifier.resolution_mode = imported, 0, "GRID"
modifier.grid_name = "surface"
theirs = measures(surface.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh())
out["surface"] = plain(theirs)
# Compares the outward directions of some of their triangles with those of our nearest triangles.
step = max(1, len(theirs["middles"]) // 200)
agree = []
for i in range(0, len(theirs["middles"]), step):
    if numpy.linalg.norm(theirs["across"][i]) < 1e-10:  # its vertices coincide at a sample on the surface
        continue
    near = ((ours["middles"] - theirs["middles"][i]) ** 2).sum(1).argmin()
    pair = theirs["across"][i], ours["across"][near]
    agree.append(float(pair[0] @ pair[1] / numpy.sqrt((pair[0] @ pair[0]) * (pair[1] @ pair[1]) + 1e-30)))
out["agree"] = agree
print("\nFOUND " + json.dumps(out))
