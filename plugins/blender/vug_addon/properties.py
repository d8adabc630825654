"""What a cave keeps in the .blend, and where the add-on finds Vug."""
import bpy
from bpy.props import BoolProperty, FloatProperty, IntProperty, PointerProperty, StringProperty


class VugCave(bpy.types.PropertyGroup):
    """Of a collection that holds a cave; `source` is empty in all others."""

    source: StringProperty(name="Scene", subtype="FILE_PATH", description="The .vug file")
    use_seed: BoolProperty(name="Own Seed", description="Another seed than the scene's")
    seed: IntProperty(name="Seed", min=0, description="Another number, another cave of the same kind")
    folder: StringProperty(name="Volumes", subtype="DIR_PATH",
                           description="Where the .vdb files of this cave are kept")
    parameters: StringProperty(options={"HIDDEN"})  # what the scene has said of them, in JSON
    metres_per_unit: FloatProperty(default=1, options={"HIDDEN"})  # of the scene it was made for
    owned: StringProperty(options={"HIDDEN"})  # what it has brought; see ownership.py
    built: StringProperty(options={"HIDDEN"})  # what it was last built with; see cave_build.py
    stale: StringProperty(options={"HIDDEN"})  # why the last update failed; empty: all is up to date
    known: StringProperty(options={"HIDDEN"})  # the key of what Blender has; see worker.py


class VugPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    python: StringProperty(
        name="Python", subtype="FILE_PATH",
        description="The Python 3 that Vug's package is made for; empty: the one of Blender")
    package: StringProperty(
        name="Package", subtype="DIR_PATH",
        description="The folder that holds the package 'vug'; empty: where that Python looks by itself")

    def draw(self, context):
        self.layout.prop(self, "python")
        self.layout.prop(self, "package")


def preferences():
    addon = bpy.context.preferences.addons.get(__package__)
    return addon.preferences if addon else None


def caves():
    return [each for each in bpy.data.collections if each.vug.source]


def active_cave(context):
    """The one of the active object, else the active collection, else the only one; or None."""
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
