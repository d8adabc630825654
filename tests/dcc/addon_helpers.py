# SPDX-License-Identifier: Apache-2.0
"""Shared code for the checks of the add-on in Blender."""
import os

import bpy
import numpy


def equal(got, wanted, what=""):
    assert got == wanted, f"{what}: {got!r} in place of {wanted!r}"


def near(got, wanted, most, what=""):
    assert numpy.abs(numpy.asarray(got) - numpy.asarray(wanted)).max() <= most, (
        f"{what}: {got} in place of {wanted}")


def refused(operator, *words, **arguments):
    try:
        operator(**arguments)
    except RuntimeError as error:
        for word in words:
            assert word in str(error), f"'{word}' is not in: {error}"
        return
    raise AssertionError(f"{operator} {arguments} was not refused")


def values(items, member, width):
    out = numpy.empty(len(items) * width, numpy.float32)
    items.foreach_get(member, out)
    return out.reshape(-1, width)


def corners(mesh):
    out = numpy.empty(len(mesh.loops), numpy.int32)
    mesh.loops.foreach_get("vertex_index", out)
    return out.reshape(-1, 3)


def volume_of(mesh):
    points, (a, b, c) = values(mesh.vertices, "co", 3), corners(mesh).T
    return float((points[a] * numpy.cross(points[b], points[c])).sum() / 6)


def print_of(collection):
    """Everything that can change in a cave, and the number of data blocks in the file."""
    out = [len(bpy.data.objects), len(bpy.data.meshes), len(bpy.data.materials), len(bpy.data.volumes),
           collection.vug.known, sorted(collection.keys())]
    for thing in collection.objects:
        out.append((thing.name, [tuple(row) for row in thing.matrix_world]))
        if thing.type == "MESH":
            out.append((values(thing.data.vertices, "co", 3).tobytes(), corners(thing.data).tobytes()))
    return out


def resident():
    """Resident memory in megabytes."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


def cave():
    return bpy.data.collections["cave"]


def thing(name):
    return next(each for each in cave().objects if each["vug_name"] == name)


def nothing_is_built():
    from vug_addon.cave_build import CaveBuild
    bpy.ops.vug.update(cave="cave")
    build = CaveBuild(collection=cave())
    while not build.step(wait=0.1):
        pass
    equal((build.message, build.changed, build.share), ("nothing has changed", 0, 0))
