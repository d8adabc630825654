# SPDX-License-Identifier: Apache-2.0
"""Environment lights as Blender's world: all domes of a scene in one world that belongs to the cave."""
import os

import bpy
from mathutils import Matrix, Quaternion

from .glb import TURN

NAME = "vug_sky"
# The middle of Vug's environment maps is straight ahead: -z with y up, +y with z up. Blender's is +x.
AHEAD = Matrix(((0, 1, 0), (-1, 0, 0), (0, 0, 1)))


def is_plain(world):
    """Whether a world is unmodified: Blender's default world is a uniform grey."""
    return not world.use_nodes or all(node.type in ("BACKGROUND", "OUTPUT_WORLD")
                                      for node in world.node_tree.nodes)


def lookup(rotation):
    """Rotation from directions in Blender's space to lookup directions in the environment map."""
    x, y, z, w = rotation
    turn = (TURN @ Quaternion((w, x, y, z)).to_matrix().to_4x4() @ TURN.inverted()).to_3x3()
    return AHEAD @ turn.inverted()


def background(tree, about, folder):
    """The radiance of a dome, as a shader output."""
    nodes, links = tree.nodes, tree.links
    shader = nodes.new("ShaderNodeBackground")
    shader.inputs["Color"].default_value = (*about["radiance"], 1)
    if "file" in about:
        place, mapping = nodes.new("ShaderNodeTexCoord"), nodes.new("ShaderNodeMapping")
        picture = nodes.new("ShaderNodeTexEnvironment")
        mapping.inputs["Rotation"].default_value = lookup(about.get("rotation", (0, 0, 0, 1))).to_euler()
        picture.image = bpy.data.images.load(os.path.join(folder, about["file"]), check_existing=True)
        picture.image.reload()  # the file may be from another build
        picture.image.colorspace_settings.name = "Non-Color"  # linear Rec.709, as Blender works in
        tint = nodes.new("ShaderNodeMixRGB")
        tint.blend_type = "MULTIPLY"
        tint.inputs["Fac"].default_value = 1
        tint.inputs["Color2"].default_value = (*about["radiance"], 1)
        links.new(place.outputs["Generated"], mapping.inputs["Vector"])
        links.new(mapping.outputs["Vector"], picture.inputs["Vector"])
        links.new(picture.outputs["Color"], tint.inputs["Color1"])
        links.new(tint.outputs["Color"], shader.inputs["Color"])
    return shader.outputs[0]


def fill(world, skies, folder):
    world.use_nodes = True
    tree = world.node_tree
    tree.nodes.clear()
    sum_ = None
    for about in skies:
        shine = background(tree, about, folder)
        if sum_:
            both = tree.nodes.new("ShaderNodeAddShader")
            tree.links.new(sum_, both.inputs[0])
            tree.links.new(shine, both.inputs[1])
            shine = both.outputs[0]
        sum_ = shine
    tree.links.new(sum_, tree.nodes.new("ShaderNodeOutputWorld").inputs["Surface"])


def of(collection):
    """The cave's world, or None."""
    return next((each for each in bpy.data.worlds if each.get(NAME) == collection.name), None)


def update_world(collection, skies, folder, changed):
    """Creates, updates or removes the world for the skies of the cave's scene. The Blender scene uses it unless
    it has a world made by the user. `changed(world, ...)` returns whether the data differ from the last call."""
    world = of(collection)
    if not skies:
        if world:
            bpy.data.worlds.remove(world)
        return
    if not world:
        world = bpy.data.worlds.new(f"{collection.name} sky")
        world[NAME] = collection.name
    times = [os.path.getmtime(os.path.join(folder, about["file"])) for about in skies if "file" in about]
    if changed(world, skies, folder, times):
        fill(world, skies, folder)
    scene = bpy.context.scene
    if not scene.world or NAME in scene.world or is_plain(scene.world):
        scene.world = world
