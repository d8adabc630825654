# SPDX-License-Identifier: Apache-2.0
"""Operators that write curves and armatures as networks of caves, and read networks as curves or armatures."""
import os

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

from . import curves, network_files


class VUG_OT_export_network(bpy.types.Operator, ExportHelper):
    """Write the active curve or armature as the network of a cave: a survey (.svx) and a .vug scene that uses it. The
    radius of a point is half the width of the passage"""

    bl_idname, bl_label = "vug.export_network", "Curve to Vug Network"
    filename_ext = ".svx"
    filter_glob: StringProperty(default="*.svx", options={"HIDDEN"})
    voxel: FloatProperty(name="Voxel", default=0.25, min=1e-3,
                         description="Voxel size of the scene that is written with the network, in metres")

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type in ("CURVE", "ARMATURE")

    def execute(self, context):
        try:
            message = network_files.write(context.object, self.filepath, self.voxel)
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        except OSError as error:
            self.report({"ERROR"}, f"cannot write '{self.filepath}': {error.strerror}")
            return {"CANCELLED"}
        self.report({"INFO"}, message)
        return {"FINISHED"}


class VUG_OT_import_network(bpy.types.Operator, ImportHelper):
    """Add a curve or an armature along the legs of a cave survey (.svx)"""

    bl_idname, bl_label, bl_options = "vug.import_network", "Network to Curve", {"UNDO"}
    filename_ext = ".svx"
    filter_glob: StringProperty(default="*.svx", options={"HIDDEN"})
    kind: EnumProperty(name="As", items=[("CURVE", "Curve", "A spline for each passage"),
                                         ("ARMATURE", "Armature", "A bone for each leg")])
    recenter: BoolProperty(name="Recenter", default=True,
                           description="Put the middle of the survey, rounded to metres, into the origin; the export "
                                       "returns to the places of the survey")

    def execute(self, context):
        path = bpy.path.abspath(self.filepath)
        name = os.path.splitext(os.path.basename(path))[0]
        if not name or os.path.isdir(path):
            self.report({"ERROR"}, "choose a .svx file, which contains a survey")
            return {"CANCELLED"}
        try:
            network, offset = network_files.read(path, self.recenter)
        except ValueError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        except OSError as error:
            self.report({"ERROR"}, f"cannot read '{path}': {error.strerror}")
            return {"CANCELLED"}
        if context.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        if self.kind == "CURVE":
            thing = curves.new_curve(network, name, offset)
            context.collection.objects.link(thing)
        else:
            thing = curves.new_armature(network, name, offset, context)
        for other in context.selected_objects:
            other.select_set(False)
        thing.select_set(True)
        context.view_layer.objects.active = thing
        self.report({"INFO"}, f"{len(network.stations)} stations and {len(network.legs)} legs")
        return {"FINISHED"}


OPERATORS = (VUG_OT_export_network, VUG_OT_import_network)


def draw_export(menu, context):
    menu.layout.operator("vug.export_network", text="Vug Network (.svx + .vug)")


def draw_import(menu, context):
    menu.layout.operator("vug.import_network", text="Vug Network (.svx)")


def register():
    for each in OPERATORS:
        bpy.utils.register_class(each)
    bpy.types.TOPBAR_MT_file_export.append(draw_export)
    bpy.types.TOPBAR_MT_file_import.append(draw_import)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(draw_import)
    bpy.types.TOPBAR_MT_file_export.remove(draw_export)
    for each in reversed(OPERATORS):
        bpy.utils.unregister_class(each)
