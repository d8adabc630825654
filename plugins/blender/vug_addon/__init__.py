"""Caves of Vug in Blender: .vug scenes with their parameters as sliders, and blocked-out meshes back."""
bl_info = {
    "name": "Vug",
    "description": "Caves grown out of grammars, from .vug scenes",
    "author": "Vug",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Add > Vug Cave; View3D > Sidebar > Vug; File > Export > Vug Field",
    "category": "Add Mesh",
}

from . import folders, operators, panel, properties  # noqa: E402  Blender reads bl_info first

PARTS = (properties, operators, panel, folders)


def register():
    for part in PARTS:
        part.register()


def unregister():
    for part in reversed(PARTS):
        part.unregister()
