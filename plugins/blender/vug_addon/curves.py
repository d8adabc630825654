# SPDX-License-Identifier: Apache-2.0
"""Converts curves and armatures of Blender to networks, and networks to curves and armatures.

A point of a curve and an end of a bone are stations; its radius is half the width of the passage. Points at the same
place are one station, so splines and bones that meet there form a junction.
"""
import json

import bpy
from mathutils import Vector
from mathutils.geometry import interpolate_bezier

from . import networks, units

SAME = 1e-3  # metres between points that are one station
STATIONS = "vug_stations"  # property of a curve: the stations of its splines as JSON
OFFSET = "vug_offset"  # property of a curve or an armature: the place of its origin in the survey, metres


class Collector:
    """Collects stations by place, and legs."""

    def __init__(self, title):
        self.network = networks.Network(title=title)
        self.cells, self.used, self.pairs = {}, set(), set()

    def station(self, place, radius, known):
        """The number of the station at a place in metres. `known` is a dictionary with a name and maybe with walls
        and an entrance; the walls are scaled if the radius has changed."""
        cell = tuple(int(x // SAME) for x in place)
        for near in ((cell[0] + i, cell[1] + j, cell[2] + k) for i in (0, -1, 1) for j in (0, -1, 1)
                     for k in (0, -1, 1)):
            for i in self.cells.get(near, ()):
                if (Vector(self.network.stations[i].position) - place).length < SAME:
                    return i
        walls = known.get("walls")
        half = (walls[0] + walls[1]) / 2 if walls else 0
        walls = tuple(side * radius / half for side in walls) if half > 0 else (radius,) * 4
        name = networks.unique_name(known["name"], self.used)
        number = len(self.network.stations)
        self.network.stations.append(
            networks.Station(name, tuple(place), walls if radius > 0 else None, known.get("entrance", False)))
        self.cells.setdefault(cell, []).append(number)
        return number

    def leg(self, a, b):
        if a != b and (min(a, b), max(a, b)) not in self.pairs:
            self.pairs.add((min(a, b), max(a, b)))
            self.network.legs.append((a, b))


def points_of(spline):
    """Lists of (position, radius, whether it is a control point), closed if the spline is."""
    if spline.type == "NURBS":
        raise ValueError("a NURBS spline has no points on the curve: choose Set Spline Type, Bezier or Poly first")
    if spline.type == "POLY":
        points = [(Vector(point.co[:3]), point.radius, True) for point in spline.points]
        return points + points[:1] if spline.use_cyclic_u and len(points) > 2 else points
    knots = list(spline.bezier_points)
    out = [(knots[0].co.copy(), knots[0].radius, True)] if knots else []
    count = max(spline.resolution_u, 1)
    for a, b in zip(knots, knots[1:] + (knots[:1] if spline.use_cyclic_u and len(knots) > 1 else [])):
        if a.handle_right_type == b.handle_left_type == "VECTOR":
            between = []
        else:
            between = interpolate_bezier(a.co, a.handle_right, b.handle_left, b.co, count + 1)[1:-1]
        for i, place in enumerate(between, 1):
            share = i / (len(between) + 1)
            out.append((place, a.radius + (b.radius - a.radius) * share, False))
        out.append((b.co.copy(), b.radius, True))
    return out


def known_stations(thing):
    """The stations that were imported for each spline, if the curve still has as many points."""
    try:
        known = json.loads(thing.data.get(STATIONS, "[]"))
    except ValueError:
        return []
    counts = [len(spline.bezier_points) or len(spline.points) for spline in thing.data.splines]
    return known if isinstance(known, list) and [len(each) for each in known] == counts else []


def network_of_curve(thing):
    scale = units.metres_per_unit()
    size = scale * sum(thing.matrix_world.to_scale()) / 3
    known = known_stations(thing)
    collector = Collector(thing.name)
    for i, spline in enumerate(thing.data.splines):
        before, control, between = None, -1, 0
        for place, radius, is_control in points_of(spline):
            control, between = (control + 1, 0) if is_control else (control, between + 1)
            name = {"name": f"{thing.name}.{i + 1}.{control + 1}" + (f"-{between}" if between else "")}
            if is_control and known:
                name = known[i][control % len(known[i])]
            here = collector.station(thing.matrix_world @ place * scale, radius * size, name)
            if before is not None:
                collector.leg(before, here)
            before = here
    return collector.network


def network_of_armature(thing):
    scale = units.metres_per_unit()
    size = scale * sum(thing.matrix_world.to_scale()) / 3
    collector = Collector(thing.name)
    for bone in thing.data.bones:
        start = {"name": bone.get("vug_from", f"{bone.name}.start"), "walls": bone.get("vug_from_walls"),
                 "entrance": bool(bone.get("vug_from_entrance"))}
        end = {"name": bone.get("vug_to", bone.name), "walls": bone.get("vug_to_walls"),
               "entrance": bool(bone.get("vug_to_entrance"))}
        # A bone that continues its parent starts at the parent's end, whose name counts.
        if bone.parent and "vug_from" not in bone and (bone.head_local - bone.parent.tail_local).length * size < SAME:
            start = {"name": bone.parent.get("vug_to", bone.parent.name), "walls": bone.parent.get("vug_to_walls")}
        collector.leg(collector.station(thing.matrix_world @ bone.head_local * scale, bone.head_radius * size, start),
                      collector.station(thing.matrix_world @ bone.tail_local * scale, bone.tail_radius * size, end))
    return collector.network


def offset_of(thing):
    """The vector in metres from Blender's origin to that of the survey from which the object was made."""
    return tuple(thing.data.get(OFFSET, (0.0, 0.0, 0.0)))


def to_network(thing):
    """The network of a curve or an armature at its place in the scene, plus its offset. Raises ValueError for other
    objects."""
    if thing.type not in ("CURVE", "ARMATURE"):
        raise ValueError(f"'{thing.name}' is neither a curve nor an armature")
    network = network_of_curve(thing) if thing.type == "CURVE" else network_of_armature(thing)
    return networks.moved(network, offset_of(thing))


def radius_of(station, missing=1.0):
    """Half the width of the passage in metres."""
    return (station.walls[0] + station.walls[1]) / 2 if station.walls else missing


def properties_of(station):
    out = {"name": station.name}
    if station.walls:
        out["walls"] = list(station.walls)
    if station.entrance:
        out["entrance"] = True
    return out


def new_curve(network, name, offset):
    """A curve with a spline of straight pieces for each passage, thick as the passages are wide. The network has been
    moved by -offset."""
    scale = 1 / units.metres_per_unit()
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions, data.bevel_depth, data.bevel_resolution = "3D", 1, 2
    known = []
    for chain in networks.chains(network):
        spline = data.splines.new("POLY")
        closed = len(chain) > 3 and chain[0] == chain[-1]
        chain = chain[:-1] if closed else chain
        spline.use_cyclic_u = closed
        spline.points.add(len(chain) - 1)
        for point, i in zip(spline.points, chain):
            station = network.stations[i]
            point.co = (*(x * scale for x in station.position), 1)
            point.radius = radius_of(station) * scale
        known.append([properties_of(network.stations[i]) for i in chain])
    data[STATIONS], data[OFFSET] = json.dumps(known), offset
    return bpy.data.objects.new(name, data)


def new_armature(network, name, offset, context):
    """An armature with a bone for each leg; each continues one that ends where it starts. The network has been moved
    by -offset."""
    scale = 1 / units.metres_per_unit()
    data = bpy.data.armatures.new(name)
    data[OFFSET] = offset
    thing = bpy.data.objects.new(name, data)
    context.collection.objects.link(thing)
    context.view_layer.objects.active = thing
    bpy.ops.object.mode_set(mode="EDIT")
    bone_to = {}
    for chain in networks.chains(network):
        for a, b in zip(chain, chain[1:]):
            start, end = network.stations[a], network.stations[b]
            bone = data.edit_bones.new(end.name)
            bone.head, bone.tail = (Vector(station.position) * scale for station in (start, end))
            bone.head_radius, bone.tail_radius = radius_of(start) * scale, radius_of(end) * scale
            bone.parent = bone_to.get(a)
            bone_to.setdefault(b, bone)
            for key, station in (("vug_from", start), ("vug_to", end)):
                bone[key] = station.name
                if station.walls:
                    bone[f"{key}_walls"] = station.walls
                if station.entrance:
                    bone[f"{key}_entrance"] = True
    bpy.ops.object.mode_set(mode="OBJECT")
    return thing
