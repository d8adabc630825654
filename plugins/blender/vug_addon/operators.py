# SPDX-License-Identifier: Apache-2.0
"""Operators: add, update and cancel caves, reset parameters, and export a mesh as a field."""
import os

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

from . import export_field, parameters, properties
from .cave_build import CaveBuild, set_to_built


class ReportsResult:
    """Reports the result of a CaveBuild."""

    def report_result(self, build):
        if build.cancelled:
            self.report({"INFO"}, "cancelled: nothing was changed")
            return {"CANCELLED"}
        if build.error:
            self.report({"ERROR"}, build.error)
            return {"CANCELLED"}
        self.report({"INFO"}, build.message)
        return {"FINISHED"}

    def run(self, build):
        """Runs a build to its end, for scripts and for Blender without a window."""
        while not build.step(wait=0.2):
            pass
        return self.report_result(build)


class VUG_OT_work(ReportsResult, bpy.types.Operator):
    """Wait for a build in the background and show its progress. This is a separate operator, because operators
    called by the file browser cannot be modal"""

    bl_idname, bl_label, bl_options = "vug.work", "Build Vug Cave", {"INTERNAL", "UNDO"}

    def invoke(self, context, event):
        self.build = CaveBuild.current
        if not self.build:
            return {"CANCELLED"}
        manager = context.window_manager
        manager.progress_begin(0, 100)
        self.timer = manager.event_timer_add(0.1, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self.build.cancel()
        if event.type != "TIMER" and not self.build.cancelled:
            return {"PASS_THROUGH"}
        context.window_manager.progress_update(100 * self.build.share)
        context.workspace.status_text_set(f"Vug: {self.build.what} {self.build.share:.0%}   Esc: cancel")
        for area in context.screen.areas if context.screen else ():
            if area.type == "VIEW_3D":
                area.tag_redraw()
        if not self.build.step():
            return {"PASS_THROUGH"}
        context.window_manager.event_timer_remove(self.timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)
        return self.report_result(self.build)


class VUG_OT_add(ReportsResult, bpy.types.Operator, ImportHelper):
    """Add a cave from a .vug scene"""

    bl_idname, bl_label, bl_options = "vug.add", "Vug Cave", {"UNDO"}
    filename_ext = ".vug"
    filter_glob: StringProperty(default="*.vug", options={"HIDDEN"})
    use_camera: BoolProperty(name="Camera", default=True,
                             description="Use the cave's first camera if the scene has none")
    use_resolution: BoolProperty(name="Resolution", default=True,
                                 description="Also use the picture size of that camera")
    chosen: BoolProperty(default=False, options={"HIDDEN", "SKIP_SAVE"})

    def invoke(self, context, event):
        self.chosen = True
        return ImportHelper.invoke(self, context, event)

    @classmethod
    def poll(cls, context):
        return CaveBuild.current is None

    def execute(self, context):
        path = bpy.path.abspath(self.filepath)
        if not os.path.basename(path) or os.path.isdir(path):
            self.report({"ERROR"}, "choose a .vug file, which contains the scene of a cave")
            return {"CANCELLED"}
        build = CaveBuild(source=self.filepath, camera=self.use_camera, resolution=self.use_resolution)
        if bpy.app.background or not self.chosen:
            return self.run(build)
        return bpy.ops.vug.work("INVOKE_DEFAULT") and {"FINISHED"}


class VUG_OT_update(ReportsResult, bpy.types.Operator):
    """Rebuild the cave with the current parameters, if anything has changed"""

    bl_idname, bl_label, bl_options = "vug.update", "Update", {"UNDO"}
    cave: StringProperty(name="Cave", description="Name of the collection; empty: the active cave",
                         options={"SKIP_SAVE"})

    @classmethod
    def poll(cls, context):
        return CaveBuild.current is None and bool(properties.caves())

    def begin(self, context):
        collection = bpy.data.collections.get(self.cave) if self.cave else properties.active_cave(context)
        if collection and collection.vug.source:
            return CaveBuild(collection=collection)
        self.report({"ERROR"}, "select a cave: one of its objects or its collection")
        return None

    def invoke(self, context, event):
        if bpy.app.background:
            return self.execute(context)
        return bpy.ops.vug.work("INVOKE_DEFAULT") and {"FINISHED"} if self.begin(context) else {"CANCELLED"}

    def execute(self, context):
        build = self.begin(context)
        return self.run(build) if build else {"CANCELLED"}


class VUG_OT_cancel(bpy.types.Operator):
    """Stop the running build; nothing changes"""

    bl_idname, bl_label = "vug.cancel", "Cancel"

    @classmethod
    def poll(cls, context):
        return CaveBuild.current is not None

    def execute(self, context):
        CaveBuild.current.cancel()
        return {"FINISHED"}


class VUG_OT_defaults(bpy.types.Operator):
    """Reset all parameters of the cave to the defaults of the scene"""

    bl_idname, bl_label, bl_options = "vug.defaults", "Defaults", {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return properties.active_cave(context) is not None

    def execute(self, context):
        parameters.reset(properties.active_cave(context))
        return {"FINISHED"}


variant_items = []  # Blender does not keep the strings of the items alive


def items_of_variants(operator, context):
    collection = properties.active_cave(context) if context else None
    names = parameters.variants(collection) if collection else ()
    variant_items[:] = [(name, name, f"Set the parameters to those of the variant '{name}'") for name in names]
    return variant_items


class VUG_OT_variant(bpy.types.Operator):
    """Set the parameters of the cave to those of a variant of the scene, and all others to their defaults"""

    bl_idname, bl_label, bl_options = "vug.variant", "Variant", {"REGISTER", "UNDO"}
    variant: EnumProperty(name="Variant", items=items_of_variants)

    @classmethod
    def poll(cls, context):
        collection = properties.active_cave(context)
        return collection is not None and bool(parameters.variants(collection))

    def execute(self, context):
        parameters.apply_variant(properties.active_cave(context), self.variant)
        return {"FINISHED"}


class VUG_OT_revert(bpy.types.Operator):
    """Reset all parameters to those of the last build"""

    bl_idname, bl_label, bl_options = "vug.revert", "As Built", {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        collection = properties.active_cave(context)
        return collection is not None and bool(collection.vug.built)

    def execute(self, context):
        set_to_built(properties.active_cave(context))
        return {"FINISHED"}


class VUG_OT_export_field(bpy.types.Operator, ExportHelper):
    """Write the active closed mesh as a solid for scenes: a .ply file and a .vug scene that uses it"""

    bl_idname, bl_label = "vug.export_field", "Vug Field"
    filename_ext = ".ply"
    filter_glob: StringProperty(default="*.ply", options={"HIDDEN"})
    voxel: FloatProperty(name="Voxel", default=0.05, min=1e-4,
                         description="Voxel size of the scene that is written with the mesh, in metres")

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "MESH"

    def execute(self, context):
        try:
            message = export_field.write(context.object, context.evaluated_depsgraph_get(), self.filepath, self.voxel)
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        except OSError as error:
            self.report({"ERROR"}, f"cannot write '{self.filepath}': {error.strerror}")
            return {"CANCELLED"}
        self.report({"INFO"}, message)
        return {"FINISHED"}


OPERATORS = (VUG_OT_work, VUG_OT_add, VUG_OT_update, VUG_OT_cancel, VUG_OT_defaults, VUG_OT_variant, VUG_OT_revert,
             VUG_OT_export_field)


def draw_add(menu, context):
    menu.layout.operator("vug.add", icon="MESH_ICOSPHERE")


def draw_export(menu, context):
    menu.layout.operator("vug.export_field", text="Vug Field (.ply + .vug)")


def register():
    for each in OPERATORS:
        bpy.utils.register_class(each)
    bpy.types.VIEW3D_MT_add.append(draw_add)
    bpy.types.TOPBAR_MT_file_export.append(draw_export)


def unregister():
    if CaveBuild.current:
        CaveBuild.current.cancel()
    bpy.types.TOPBAR_MT_file_export.remove(draw_export)
    bpy.types.VIEW3D_MT_add.remove(draw_add)
    for each in reversed(OPERATORS):
        bpy.utils.unregister_class(each)
