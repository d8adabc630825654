# SPDX-License-Identifier: Apache-2.0
"""Properties of a cave in the .blend, and the preferences of the add-on."""
import bpy
from bpy.props import BoolProperty, FloatProperty, IntProperty, PointerProperty, StringProperty


class VugCave(bpy.types.PropertyGroup):
    """Properties of a collection that contains a cave; `source` is empty in other collections."""

    source: StringProperty(name="Scene", subtype="FILE_PATH", description="The .vug file")
    use_seed: BoolProperty(name="Own Seed", description="Replace the scene's seed")
    seed: IntProperty(name="Seed", min=0, description="Each seed gives another cave of the same kind")
    folder: StringProperty(name="Volumes", subtype="DIR_PATH",
                           description="Folder of this cave's .vdb files")
    parameters: StringProperty(options={"HIDDEN"})  # declared parameters as JSON
    variants: StringProperty(options={"HIDDEN"})  # values of the variants' parameters as JSON
    metres_per_unit: FloatProperty(default=1, options={"HIDDEN"})  # unit scale of the last build
    owned: StringProperty(options={"HIDDEN"})  # imported objects; see ownership.py
    built: StringProperty(options={"HIDDEN"})  # settings of the last build; see cave_build.py
    stale: StringProperty(options={"HIDDEN"})  # error of the last update; empty if up to date
    known: StringProperty(options={"HIDDEN"})  # key of the imported result; see worker.py


class VugPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    python: StringProperty(
        name="Python", subtype="FILE_PATH",
        description="Python 3 for which Vug's package was built; empty: Blender's Python")
    package: StringProperty(
        name="Package", subtype="DIR_PATH",
        description="Folder that contains the package 'vug'; empty: the default search path")

    def draw(self, context):
        self.layout.prop(self, "python")
        self.layout.prop(self, "package")


def preferences():
    addon = bpy.context.preferences.addons.get(__package__)
    return addon.preferences if addon else None


def caves():
    return [each for each in bpy.data.collections if each.vug.source]


def active_cave(context):
    """The cave of the active object, else the active collection, else the only cave, or None."""
    thing = getattr(context, "object", None)
    candidates = [each for each in (thing.users_collection if thing else ()) if each.vug.source]
    if context.collection and context.collection.vug.source:
        candidates.append(context.collection)
    all_caves = caves()
    if not candidates and len(all_caves) == 1:
        candidates = all_caves
    return candidates[0] if candidates else None


def register():
    bpy.utils.register_class(VugCave)
    bpy.utils.register_class(VugPreferences)
    bpy.types.Collection.vug = PointerProperty(type=VugCave)


def unregister():
    del bpy.types.Collection.vug
    bpy.utils.unregister_class(VugPreferences)
    bpy.utils.unregister_class(VugCave)
