# SPDX-License-Identifier: Apache-2.0
"""The sidebar panel of the 3D view with a cave's parameters."""
import textwrap

import bpy

from . import parameters, properties, units
from .cave_build import CaveBuild


class VUG_PT_cave(bpy.types.Panel):
    bl_idname, bl_label = "VUG_PT_cave", "Vug"
    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "Vug"

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        if CaveBuild.current:
            layout.label(text=f"{CaveBuild.current.what} {CaveBuild.current.share:.0%}")
            layout.operator("vug.cancel", icon="X")
        collection = properties.active_cave(context)
        if not collection:
            layout.operator("vug.add", icon="MESH_ICOSPHERE")
            self.draw_exchange()
            return
        layout.label(text=collection.name, icon="OUTLINER_COLLECTION")
        if parameters.variants(collection):
            layout.operator_menu_enum("vug.variant", "variant", text="Variant")
        column = layout.column()
        for module, sliders in parameters.groups(collection).items():
            part = column.box() if module else column
            if module:
                part.label(text=module)
            for label, key in sliders:
                part.prop(collection, f'["{bpy.utils.escape_identifier(key)}"]', text=label)
        if collection.vug.stale:
            box = layout.box()
            box.alert = True
            for line in textwrap.wrap(collection.vug.stale, 40):
                box.label(text=line)
            box.operator("vug.revert", icon="LOOP_BACK")
        if collection.vug.metres_per_unit != units.metres_per_unit(context.scene):
            layout.label(text="The unit scale has changed: Update", icon="ERROR")
        column.prop(collection.vug, "use_seed")
        if collection.vug.use_seed:
            column.prop(collection.vug, "seed")
        row = layout.row(align=True)
        row.operator("vug.update", icon="FILE_REFRESH").cave = collection.name
        row.operator("vug.defaults", icon="LOOP_BACK")
        column = layout.column()
        column.prop(collection.vug, "source")
        column.prop(collection.vug, "folder")
        self.draw_exchange()

    def draw_exchange(self):
        for operator in ("vug.export_field", "vug.export_network", "vug.import_network"):
            self.layout.operator(operator)


def register():
    bpy.utils.register_class(VUG_PT_cave)


def unregister():
    bpy.utils.unregister_class(VUG_PT_cave)
