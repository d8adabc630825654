# SPDX-License-Identifier: Apache-2.0
"""Conversion of arrays to Blender meshes."""
import bpy
import numpy

KINDS = {0: ("FLOAT", "value"), 3: ("FLOAT_VECTOR", "vector"), 4: ("FLOAT_COLOR", "color")}


def add_attribute(mesh, name, values):
    width = 0 if values.ndim == 1 else values.shape[1]
    if width == 3 and (name in ("Cd", "emission", "through") or name.endswith("color")):
        values = numpy.concatenate([values, numpy.ones((len(values), 1), values.dtype)], 1)
        width = 4
    if width == 2:
        values = numpy.concatenate([values, numpy.zeros((len(values), 1), values.dtype)], 1)
        width = 3
    kind, member = KINDS[width]
    made = mesh.attributes.new(name, kind, "POINT")
    made.data.foreach_set(member, numpy.ascontiguousarray(values, numpy.float32).ravel())


def add_missing(mesh, surface):
    """Restores attributes that were removed from the mesh."""
    for name, values in surface.attributes.items():
        if name not in mesh.attributes:
            add_attribute(mesh, name, values)


def fill(mesh, surface):
    """Replaces the geometry of the mesh by a surface; its materials are kept."""
    mesh.clear_geometry()
    for name in [each.name for each in mesh.attributes]:
        if name in surface.attributes:
            mesh.attributes.remove(mesh.attributes[name])
    triangles = len(surface.triangles)
    mesh.vertices.add(len(surface.positions))
    mesh.vertices.foreach_set("co", surface.positions.ravel())
    mesh.loops.add(3 * triangles)
    mesh.loops.foreach_set("vertex_index", surface.triangles.ravel())
    mesh.polygons.add(triangles)
    mesh.polygons.foreach_set("loop_start", numpy.arange(0, 3 * triangles, 3, dtype=numpy.int32))
    if bpy.app.version < (4, 0):  # later versions derive it from loop_start
        mesh.polygons.foreach_set("loop_total", numpy.full(triangles, 3, numpy.int32))
    mesh.polygons.foreach_set("use_smooth", numpy.full(triangles, surface.normals is not None))
    if len(surface.materials) > 1:
        mesh.polygons.foreach_set("material_index", surface.slots)
    mesh.update(calc_edges=True)
    for name, values in surface.attributes.items():
        add_attribute(mesh, name, values)
    if "Cd" in surface.attributes:
        mesh.attributes.active_color = mesh.attributes["Cd"]
    if surface.normals is not None:
        mesh.normals_split_custom_set_from_vertices(surface.normals)
        if hasattr(mesh, "use_auto_smooth"):
            mesh.use_auto_smooth = True
