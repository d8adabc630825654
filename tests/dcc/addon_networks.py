# SPDX-License-Identifier: Apache-2.0
"""Checks of the add-on in Blender: curves and armatures as networks, and back."""
import os

import bpy
import numpy

from addon_helpers import equal, near, refused

folder = os.getcwd()


def parsed(file):
    from vug_addon import svx_reader
    with open(f"{folder}/{file}", encoding="utf-8") as text:
        return svx_reader.parse(text.read(), file)


def by_name(network):
    return {station.name: station for station in network.stations}


def legs_of(network):
    return sorted(tuple(sorted(network.stations[end].name for end in leg)) for leg in network.legs)


def fork():
    """A curve of two straight splines that share a point, turned and moved."""
    data = bpy.data.curves.new("Fork", "CURVE")
    data.dimensions = "3D"
    for points in (((0, 0, 0, 2), (10, 0, -1, 3), (20, 0, -1, 1)), ((10, 0, -1, 3), (10, 8, -3, 1.5))):
        spline = data.splines.new("POLY")
        spline.points.add(len(points) - 1)
        for point, (x, y, z, radius) in zip(spline.points, points):
            point.co, point.radius = (x, y, z, 1), radius
    thing = bpy.data.objects.new("Fork", data)
    thing.location, thing.rotation_euler = (100, 0, 5), (0, 0, numpy.pi / 2)
    bpy.context.collection.objects.link(thing)
    bpy.context.view_layer.objects.active = thing
    bpy.context.view_layer.update()
    return thing


def curve_to_network():
    thing = fork()
    equal(bpy.ops.vug.export_network(filepath=f"{folder}/fork", voxel=0.5), {"FINISHED"})
    network = parsed("fork.svx")
    stations = by_name(network)
    equal(sorted(stations), ["Fork.1.1", "Fork.1.2", "Fork.1.3", "Fork.2.2"])
    near(stations["Fork.1.2"].position, (100, 10, 4), 1e-5)
    near(stations["Fork.2.2"].position, (92, 10, 2), 1e-5)
    near(stations["Fork.1.2"].walls, (3, 3, 3, 3), 1e-5)
    equal(legs_of(network), [("Fork.1.1", "Fork.1.2"), ("Fork.1.2", "Fork.1.3"), ("Fork.1.2", "Fork.2.2")])
    import vug
    box = vug.load("fork.vug").build().level_set("air").bounds
    # Vug's z is Blender's -y. The widest place is at the junction.
    assert box[0][0] < 92 and box[1][0] > 102 and box[0][2] < -20 and box[1][2] > 0, box
    with open("fork.vug", "a") as scene:
        scene.write("# edited\n")
    bpy.ops.vug.export_network(filepath=f"{folder}/fork.svx")
    assert open("fork.vug").read().endswith("# edited\n"), "an edited scene is kept"
    thing.scale = (2, 2, 2)
    bpy.context.view_layer.update()
    bpy.ops.vug.export_network(filepath=f"{folder}/fork.svx")
    near(by_name(parsed("fork.svx"))["Fork.2.2"].walls[0], 3, 1e-5)
    bpy.data.objects.remove(thing)


def bezier():
    """Pieces between the points follow the curve."""
    bpy.ops.curve.primitive_bezier_circle_add(radius=10)
    thing = bpy.context.object
    equal(bpy.ops.vug.export_network(filepath=f"{folder}/circle.svx"), {"FINISHED"})
    network = parsed("circle.svx")
    equal(len(network.stations), len(network.legs))
    assert len(network.stations) > 20
    for station in network.stations:
        near(numpy.linalg.norm(station.position), 10, 0.05)
    thing.data.splines[0].type = "NURBS"
    refused(bpy.ops.vug.export_network, "NURBS", "Set Spline Type", filepath=f"{folder}/circle.svx")
    bpy.data.objects.remove(thing)


SURVEY = """*title "Far"
*fix mouth 450000 5050000 612.5
*entrance mouth
*data cartesian from to easting northing altitude
mouth a.fork 10 0 -2
a.fork a.end 8 1 0
a.fork b.1 0 9 -1
b.1 b.2 3 9 -1
b.2 a.fork -3 -18 2
*data passage station left right up down
mouth 1 2 1.5 0.5
a.fork 2 2 3 1
"""


def network_to_curve():
    """Names, walls and places survive as a curve and as an armature, at the precision of Blender's numbers."""
    with open(f"{folder}/far.svx", "w") as text:
        text.write(SURVEY)
    before = parsed("far.svx")
    for kind in ("CURVE", "ARMATURE"):
        equal(bpy.ops.vug.import_network(filepath=f"{folder}/far.svx", kind=kind), {"FINISHED"})
        thing = bpy.context.object
        equal((thing.type, thing.name), (kind, "far"))
        if kind == "CURVE":
            equal(sorted(len(spline.points) for spline in thing.data.splines), [2, 2, 3])
            equal(sum(spline.use_cyclic_u for spline in thing.data.splines), 1)
            near(thing.data.splines[0].points[0].radius, 1.5, 1e-6)
            near(max(abs(x) for spline in thing.data.splines for point in spline.points for x in point.co[:3]), 9, 1.1)
        else:
            equal(len(thing.data.bones), 5)
            assert any(bone.parent for bone in thing.data.bones)
        equal(bpy.ops.vug.export_network(filepath=f"{folder}/near.svx"), {"FINISHED"})
        after = parsed("near.svx")
        equal(legs_of(after), legs_of(before), kind)
        for name, station in by_name(before).items():
            again = by_name(after)[name]
            near(again.position, station.position, 1e-5, f"{kind} {name}")
            equal(again.entrance, station.entrance)
            if station.walls:
                near(again.walls, station.walls, 1e-5, f"{kind} {name}")
        assert "recenter" not in open("near.vug").read(), "the scene has the same origin"
        os.remove("near.vug")
        if kind == "CURVE":  # a wider passage scales all walls; another number of points makes new names
            thing.data.splines[0].points[0].radius = 3
            bpy.ops.vug.export_network(filepath=f"{folder}/near.svx")
            near(by_name(parsed("near.svx"))["mouth"].walls, (2, 4, 3, 1), 1e-5)
            thing.data.splines[0].points.add(1)
            thing.data.splines[0].points[-1].co = (50, 50, 50, 1)
            bpy.ops.vug.export_network(filepath=f"{folder}/near.svx")
            assert "far.1.3" in by_name(parsed("near.svx")), "new names"
        bpy.data.objects.remove(thing)


def scaled():
    """In a scene in centimetres, the survey is still in metres."""
    bpy.context.scene.unit_settings.scale_length = 0.01
    bpy.ops.vug.import_network(filepath=f"{folder}/far.svx")
    points = [point for spline in bpy.context.object.data.splines for point in spline.points]
    near(max(point.radius for point in points), 200, 1e-3)
    bpy.ops.vug.export_network(filepath=f"{folder}/near.svx")
    near(by_name(parsed("near.svx"))["a.end"].position, (450018, 5050001, 610.5), 1e-4)
    bpy.context.scene.unit_settings.scale_length = 1
    bpy.data.objects.remove(bpy.context.object)


def faults():
    with open(f"{folder}/bad.svx", "w") as text:
        text.write("1 2 10 0 0\n*include other\n")
    refused(bpy.ops.vug.import_network, "bad.svx:2: *include", filepath=f"{folder}/bad.svx")
    refused(bpy.ops.vug.import_network, "cannot read", filepath=f"{folder}/none.svx")
    refused(bpy.ops.vug.import_network, "choose a .svx file", filepath=folder)
    data = bpy.data.curves.new("Point", "CURVE")
    thing = bpy.data.objects.new("Point", data)
    bpy.context.collection.objects.link(thing)
    bpy.context.view_layer.objects.active = thing
    refused(bpy.ops.vug.export_network, "the network has no legs", filepath=f"{folder}/point.svx")
    refused(bpy.ops.vug.export_network, "must end in .svx", filepath=f"{folder}/point.obj")
    assert not os.path.exists("point.svx")
    bpy.data.objects.remove(thing)


def networks():
    for check in (curve_to_network, bezier, network_to_curve, scaled, faults):
        check()
