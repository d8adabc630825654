# SPDX-License-Identifier: Apache-2.0
"""Runs inside Blender: installs the add-on's zip and uses it.

blender --background --factory-startup --python in_addon.py -- use|again FOLDER ZIP
"""
import os
import shutil
import sys

import bpy
import numpy

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
part, folder, zipped = sys.argv[sys.argv.index("--") + 1:]
os.chdir(folder)
from addon_files import memory, reloads, save, sweeps  # noqa: E402  it looks where it is
from addon_networks import networks  # noqa: E402
from addon_helpers import (cave, corners, equal, near, nothing_is_built, print_of, refused, thing,  # noqa: E402
                           values, volume_of)


def install():
    bpy.ops.preferences.addon_install(filepath=zipped)
    bpy.ops.preferences.addon_enable(module="vug_addon")


def empty():
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    bpy.ops.preferences.addon_enable(module="vug_addon")


def adds():
    scene = bpy.context.scene
    equal((scene.camera, scene.render.resolution_x), (None, 1920))
    equal(bpy.ops.vug.add(filepath=f"{folder}/cave.vug"), {"FINISHED"})
    equal((scene.camera, scene.render.resolution_x, scene.render.resolution_y), (thing("main"), 320, 160))
    types = [each.type for each in cave().objects]
    equal({kind: types.count(kind) for kind in set(types)},
          {"MESH": 4, "CAMERA": 2, "LIGHT": 4, "VOLUME": 3})
    equal(len({each.data for each in cave().objects if each.type == "MESH"}), 2, "shared meshes")
    near(thing("heap.2").matrix_world.translation, (4, 0, 1), 1e-6)
    equal([grid.name for grid in thing("rock volume").data.grids], ["surface"])
    equal(sorted(grid.name for grid in thing("mist volume").data.grids), ["color", "density", "temperature"])
    equal((thing("rock volume").hide_render, thing("mist volume").hide_render), (True, False))


def parameters():
    equal(cave()["R"], 0.7)
    ui = cave().id_properties_ui("R").as_dict()
    near((ui["min"], ui["max"], ui["default"]), (0.5, 1, 0.7), 1e-12)
    equal(ui["description"], "radius of the ball")
    equal((cave()["WET"], cave()["SHARE"]), (1, 0.5))
    near(cave().id_properties_ui("LEAN").as_dict()["max"], numpy.pi / 4, 1e-9)
    equal(cave().id_properties_ui("LEAN").as_dict()["subtype"], "ANGLE")


def geometry():
    mesh = thing("wall").data
    points = values(mesh.vertices, "co", 3)
    near((points.min(0), points.max(0)), ((0.3, -3.7, 1.3), (1.7, -2.3, 2.7)), 2e-3, "bounds, z up")
    near(volume_of(mesh), 4 / 3 * numpy.pi * 0.7**3, 0.01)
    import vug  # Blender's attributes equal those of Vug, in the same order
    ours = vug.load("cave.vug").build().mesh("wall")
    x, y, z = ours.positions.T
    equal(numpy.array_equal(points, numpy.stack([x, -z, y], 1)), True, "positions")
    equal(numpy.array_equal(corners(mesh), ours.triangles), True, "triangles")
    equal(mesh.validate(), False, "faults that Blender finds")
    mesh.calc_normals_split()
    ways = values(mesh.loops, "normal", 3)
    out = points[corners(mesh).ravel()] - (1, -3, 2)
    out /= numpy.linalg.norm(out, axis=1)[:, None]
    assert (ways * out).sum(1).min() > 0.99, "normals"


def attributes():
    mesh = thing("wall").data
    height = values(mesh.vertices, "co", 3)[:, 2]
    t = numpy.clip(height - 1.5, 0, 1)
    t = (t * t * (3 - 2 * t))[:, None]
    wanted = ((1 - t) * (0.8, 0.4, 0.02) + t * (0.1, 0.2, 0.9)) * (0.5, 1, 1)
    color = mesh.attributes["Cd"]
    equal((color.domain, color.data_type), ("POINT", "FLOAT_COLOR"))
    near(values(color.data, "color", 4)[:, :3], wanted, 1 / 255, "colours")
    near(values(mesh.attributes["wetness"].data, "value", 1), t, 1 / 255, "wetness")
    nodes = thing("wall").material_slots[0].material.node_tree.nodes
    named = {node.attribute_name for node in nodes if node.type == "ATTRIBUTE"}
    equal(named, {"Cd", "wetness"})
    near(next(node for node in nodes if node.type == "BSDF_PRINCIPLED").inputs["Roughness"].default_value,
         0.6, 1e-6)
    shine = next(node for node in thing("heap.1").material_slots[0].material.node_tree.nodes
                 if node.type == "EMISSION")
    near(numpy.array(shine.inputs["Color"].default_value[:3]) * shine.inputs["Strength"].default_value,
         (2, 1, 0.5), 1e-5)


def lights():
    near(thing("ball").data.energy, 100, 0.01)
    near(thing("ball").data.shadow_soft_size, 0.1, 1e-6)
    sun = thing("sun").data
    near(numpy.array(sun.color) * sun.energy, (3, 2, 1), 1e-4)
    window = thing("window").data
    equal((window.type, window.shape), ("AREA", "RECTANGLE"))
    near((window.size, window.size_y), (1, 0.5), 1e-6)
    near(numpy.array(window.color) * window.energy, 4 * 0.5 * numpy.array((3, 2, 1)), 1e-4)
    near(thing("main").data.angle_x, numpy.pi / 3, 1e-5)
    near(thing("plan").data.ortho_scale, 8, 1e-5)


def sky():
    world = bpy.context.scene.world
    equal((world.name, world["vug_sky"]), ("cave sky", "cave"))
    picture = next(node.image for node in world.node_tree.nodes if node.type == "TEX_ENVIRONMENT")
    equal(tuple(picture.size), (512, 256))
    assert os.path.samefile(os.path.dirname(bpy.path.abspath(picture.filepath)),
                            bpy.path.abspath(cave().vug.folder)), picture.filepath
    # A world edited by the user is kept; Blender's default world is replaced.
    own = bpy.data.worlds.new("an artist's")
    own.use_nodes = True
    own.node_tree.nodes.new("ShaderNodeTexSky")
    bpy.context.scene.world = own
    cave()["R"] = 0.71
    bpy.ops.vug.update()
    equal(bpy.context.scene.world.name, "an artist's")
    bpy.context.scene.world = bpy.data.worlds.new("plain")
    cave()["R"] = 0.7
    bpy.ops.vug.update()
    equal(bpy.context.scene.world, world)
    equal(sum("vug_sky" in each for each in bpy.data.worlds), 1)


def cloud():
    nodes = thing("mist volume").data.materials[0].node_tree.nodes
    body = next(node for node in nodes if node.type == "PRINCIPLED_VOLUME")
    near((body.inputs["Density"].default_value, body.inputs["Anisotropy"].default_value), (2, 0.25), 1e-6)
    equal(body.inputs["Density Attribute"].default_value, "density")
    named = sorted(node.attribute_name for node in nodes if node.type == "ATTRIBUTE")
    equal(named, ["color", "density", "temperature"])
    equal(sum(node.type == "EMISSION" for node in nodes), 1)


def slider():
    before = print_of(cave())
    equal(bpy.ops.vug.update(), {"FINISHED"})
    equal(print_of(cave()) == before, True, "nothing has changed")
    pebble = thing("heap.1").data["vug_digest"]
    thing("heap.1").location.x += 1  # an edit by an artist
    cave()["R"] = 0.9
    equal(bpy.ops.vug.update(), {"FINISHED"})
    near(volume_of(thing("wall").data), 4 / 3 * numpy.pi * 0.9**3, 0.02)
    equal(thing("heap.1").data["vug_digest"], pebble, "a mesh that has not changed")
    near(thing("heap.1").location.x, 4, 1e-6, "what an artist has moved")
    equal([len(each) for each in (cave().objects, bpy.data.meshes, bpy.data.materials, bpy.data.volumes)],
          [13, 2, 3, 3])
    cave()["WET"] = 0
    cave()["SHARE"] = 0.25
    equal(bpy.ops.vug.update(), {"FINISHED"})
    near(values(thing("wall").data.attributes["Cd"].data, "color", 4)[:, 0].max(), 0.2, 1 / 255)
    cave()["SHARE"] = 2.0
    before = print_of(cave())
    refused(bpy.ops.vug.update, "SHARE")
    equal(print_of(cave()) == before, True, "after a value out of its range")
    bpy.ops.vug.defaults()
    equal(cave()["SHARE"], 0.5)


def stale():
    """Parameters that the scene rejects are named, and one operator reverts them."""
    bpy.ops.vug.update()
    equal((cave().vug.stale, bpy.ops.vug.revert.poll()), ("", True))
    cave()["R"], cave()["SHARE"], cave().vug.use_seed = 0.75, 2.0, True
    refused(bpy.ops.vug.update, "param 'SHARE' is 2", "changed since the last build: R = 0.75, SHARE = 2")
    assert "SHARE = 2" in cave().vug.stale, cave().vug.stale
    equal(bpy.ops.vug.revert(), {"FINISHED"})
    equal((cave()["R"], cave()["SHARE"], cave().vug.use_seed, cave().vug.stale), (0.7, 0.5, False, ""))
    cave()["SHARE"] = 2.0
    refused(bpy.ops.vug.update, "SHARE")
    cave()["SHARE"] = 0.5
    equal(bpy.ops.vug.update(), {"FINISHED"})
    equal(cave().vug.stale, "")


def deleted():
    """Deleted objects of the cave are restored; an artist's other changes are kept."""
    thing("heap.2").location.x = 7
    pebble = thing("heap.2").data
    bpy.data.objects.remove(thing("wall"))
    bpy.data.objects.remove(thing("heap.1"))
    bpy.data.lights.remove(thing("ball").data)
    del cave()["R"]
    pebble.materials.clear()
    equal(bpy.ops.vug.update(), {"FINISHED"})
    near(volume_of(thing("wall").data), 4 / 3 * numpy.pi * 0.7**3, 0.01)
    equal((cave()["R"], thing("ball").type), (0.7, "LIGHT"))
    near(cave().id_properties_ui("R").as_dict()["max"], 1, 1e-12)
    equal(thing("heap.1").data, pebble, "the mesh that the others share")
    equal(("vug_name" in pebble.materials[0], thing("heap.2").location.x), (True, 7))
    thing("wall").data.attributes.remove(thing("wall").data.attributes["Cd"])
    bpy.data.worlds.remove(next(each for each in bpy.data.worlds if "vug_sky" in each))
    os.remove(bpy.path.abspath(thing("mist volume").data.filepath))
    lost = thing("plan")
    del lost["vug_name"]
    equal(bpy.ops.vug.update(), {"FINISHED"})
    attributes()
    equal(bpy.context.scene.world["vug_sky"], "cave")
    assert os.path.exists(bpy.path.abspath(thing("mist volume").data.filepath))
    equal((thing("plan"), len(cave().objects)), (lost, 13))
    thing("heap.2").location.x = 4
    nothing_is_built()


def units():
    """A scene in centimetres: all coordinates are a hundred times as large, the cave's parameters remain metres."""
    settings = bpy.context.scene.unit_settings
    settings.scale_length = 0.01
    equal(bpy.ops.vug.update(), {"FINISHED"})
    points = values(thing("wall").data.vertices, "co", 3)
    near((points.min(0), points.max(0)), ((30, -370, 130), (170, -230, 270)), 0.2)
    near(thing("heap.3").matrix_world.translation, (500, 100, 0), 1e-3)
    near(thing("heap.3").scale, (2, 2, 2), 1e-5)
    near(thing("rock volume").matrix_world.to_scale(), (100, 100, 100), 1e-3)
    near((thing("ball").data.energy, thing("ball").data.shadow_soft_size), (100 * 1e4, 10), 0.1)
    window, sun = thing("window").data, thing("sun").data
    near((window.size, window.size_y), (100, 50), 1e-3)
    near(numpy.array(window.color) * window.energy / 1e4, 4 * 0.5 * numpy.array((3, 2, 1)), 1e-3)
    near(numpy.array(sun.color) * sun.energy, (3, 2, 1), 1e-4)
    near((thing("plan").data.ortho_scale, thing("main").data.clip_end), (800, 1e5), 0.1)
    near(thing("main").location, (0, -600, 200), 1e-2)
    equal(cave()["R"], 0.7)  # still in metres, and displayed as such
    assert "subtype" not in cave().id_properties_ui("R").as_dict() or \
        cave().id_properties_ui("R").as_dict()["subtype"] == "NONE"
    assert "(metres)" in cave().id_properties_ui("R").as_dict()["description"]
    nothing_is_built()
    bpy.ops.mesh.primitive_cube_add(size=200, location=(0, 0, 100))
    equal(bpy.ops.vug.export_field(filepath=f"{folder}/big.ply", voxel=0.1), {"FINISHED"})
    import vug
    mesh = vug.read_mesh("big.ply")
    near(mesh.bounds, ((-1, 0, -1), (1, 2, 1)), 1e-5)
    bpy.data.objects.remove(bpy.context.object)
    settings.system = "NONE"  # a unit is then a metre
    equal(bpy.ops.vug.update(), {"FINISHED"})
    geometry()
    settings.system, settings.scale_length = "METRIC", 1
    lights()
    nothing_is_built()


def cancel():
    from vug_addon.cave_build import CaveBuild
    before = print_of(cave())
    cave()["R"] = 0.95
    cave().vug.source = f"{folder}/slow.vug"
    build = CaveBuild(collection=cave())
    equal(bpy.ops.vug.update.poll(), False, "a second one meanwhile")
    while build.share == 0:
        assert not build.step(wait=0.05), f"it was too fast to stop: {build.error} {build.message}"
    pid, room = build.job.pid, build.job.folder
    equal(bpy.ops.vug.cancel(), {"FINISHED"})
    equal(build.step(), True)
    equal((CaveBuild.current, build.error, build.cancelled), (None, "", True))
    assert not os.path.exists(room) and not os.path.exists(f"/proc/{pid}"), "left behind"
    equal(print_of(cave()) == before, True, "after cancelling")
    cave().vug.source = f"{folder}/cave.vug"
    bpy.ops.vug.defaults()


def faults():
    before = print_of(cave())
    refused(bpy.ops.vug.add, "bad.vug:7:", "unknown function 'spere'", "sphere", filepath=f"{folder}/bad.vug")
    refused(bpy.ops.vug.add, "nowhere.vug", filepath=f"{folder}/nowhere.vug")
    refused(bpy.ops.vug.add, "choose a .vug file", filepath="")
    refused(bpy.ops.vug.add, "choose a .vug file", filepath=folder)
    equal(print_of(cave()) == before and len(bpy.data.collections) == 1, True, "after faults")
    options = bpy.context.preferences.addons["vug_addon"].preferences
    options.python = "/no/such/python"
    refused(bpy.ops.vug.add, "/no/such/python", filepath=f"{folder}/cave.vug")
    options.python = ""


def block_out():
    bpy.ops.mesh.primitive_cube_add(size=2, location=(5, 1, 2))
    cube = bpy.context.object
    cube.scale = (1, 0.5, -1.5)  # 2 m by 1 m by 3 m, mirrored
    bpy.context.view_layer.update()
    equal(bpy.ops.vug.export_field(filepath=f"{folder}/cube.ply", voxel=0.1), {"FINISHED"})
    import vug
    scene = vug.load("cube.vug")
    near(scene.build().level_set("rock").bounds, ((4, 0.5, -1.5), (6, 3.5, -0.5)), 0.5, "where it is")
    equal(bpy.ops.vug.export_field(filepath=f"{folder}/no_end", voxel=0.1), {"FINISHED"})
    assert os.path.exists("no_end.ply") and not os.path.exists("no_end")
    for path, *words in (("", "choose a name"), (f"{folder}/", "choose a name"), ("/proc", "choose a name"),
                         ("/proc/x.ply", "cannot write '/proc/x.ply'"), (f"{folder}/x.obj", "must end in .ply"),
                         (f"{folder}/no/x.ply", "does not exist")):
        refused(bpy.ops.vug.export_field, *words, filepath=path)
    cube.scale = (1, 0.5, 0)
    bpy.context.view_layer.update()
    refused(bpy.ops.vug.export_field, "'Cube' encloses no volume", filepath=f"{folder}/flat.ply")
    assert not os.path.exists("flat.ply")
    camera, bpy.context.scene.camera = bpy.context.scene.camera, None
    bpy.ops.vug.add(filepath=f"{folder}/cube.vug", use_camera=False)
    equal(bpy.context.scene.camera, None)
    bpy.context.scene.camera = camera
    wall = bpy.data.collections["cube"].objects["wall.001"].data
    near(volume_of(wall), 6, 6 * 5e-3)
    points = values(wall.vertices, "co", 3)
    near((points.min(0), points.max(0)), ((4, 0.5, 0.5), (6, 1.5, 3.5)), 1e-2)
    bpy.ops.mesh.primitive_plane_add()
    refused(bpy.ops.vug.export_field, "'Plane' is open: 4 edges", filepath=f"{folder}/plane.ply")
    assert not os.path.exists("plane.ply")
    bpy.data.objects.remove(bpy.context.object)


def opacity():
    """Holes are cut; partially opaque surfaces transmit the rest of the light."""
    bpy.ops.vug.add(filepath=f"{folder}/leaf.vug", use_camera=False)
    leaf = bpy.data.collections["leaf"]
    cut, pane, veil = ([each for each in leaf.objects if each["vug_name"] == name][0] for name in ("cut", "pane", "veil"))
    assert len(cut.data.polygons) > 500 and len(pane.data.polygons) == 16

    def mix(thing):
        nodes = thing.data.materials[0].node_tree.nodes
        return next((node for node in nodes if node.type == "MIX_SHADER"), None)

    equal(mix(cut), None)
    nodes = {node.type: node for node in cut.data.materials[0].node_tree.nodes}
    near(nodes["BSDF_TRANSLUCENT"].inputs["Color"].default_value[:3], (0.05, 0.15, 0.025), 1e-5)
    near(nodes["BSDF_PRINCIPLED"].inputs["Base Color"].default_value[:3], (0.05, 0.15, 0.025), 1e-5)
    near(mix(pane).inputs[0].default_value, 0.25, 1e-6)
    equal([mix(pane).inputs[k].links[0].from_node.type for k in (1, 2)], ["BSDF_TRANSPARENT", "BSDF_DIFFUSE"])
    equal(mix(veil).inputs[0].links[0].from_node.attribute_name, "opacity")
    for thing_ in list(leaf.objects):
        bpy.data.objects.remove(thing_)
    bpy.data.collections.remove(leaf)


def modules():
    """Parameters of modules have sliders, which are grouped by module."""
    from vug_addon import folders, parameters as sliders
    bpy.ops.vug.add(filepath=f"{folder}/blocks.vug", use_camera=False)
    blocks = bpy.data.collections["blocks"]
    equal(sliders.groups(blocks), {"": [("HIGH", "HIGH")], "rocks": [("edge", "rocks.edge")],
                                   "pebbles": [("edge", "pebbles.edge")]})
    ui = blocks.id_properties_ui("rocks.edge").as_dict()
    near((ui["min"], ui["max"], ui["default"]), (0.1, 1, 0.2), 1e-12)
    equal(ui["description"], "edge of a block")
    blocks["rocks.edge"] = 0.4
    equal(bpy.ops.vug.update(cave="blocks"), {"FINISHED"})
    wall = next(each for each in blocks.objects if each["vug_name"] == "heap")
    near(volume_of(wall.data), 0.4**3 + 0.1**3, 2e-3)
    for each in list(blocks.objects):
        bpy.data.objects.remove(each)
    bpy.data.collections.remove(blocks)
    shutil.rmtree(os.path.join(folders.store(), "blocks"))


CHECKS = {"use": (install, empty, adds, parameters, geometry, attributes, lights, sky, cloud, slider, nothing_is_built,
                  stale, deleted, units, cancel, faults, block_out, opacity, modules, networks, save, sweeps, memory),
          "again": (reloads,)}
for check in CHECKS[part]:
    check()
    print(f"ok {check.__name__}", flush=True)
print("\nALL GOOD")
