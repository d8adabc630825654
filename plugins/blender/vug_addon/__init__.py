# SPDX-License-Identifier: Apache-2.0
"""Vug in Blender: .vug scenes with their parameters as sliders, export of meshes as fields, and of curves as networks."""
bl_info = {
    "name": "Vug",
    "description": "Caves grown from grammars, from .vug scenes",
    "author": "Vug",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Add > Vug Cave; View3D > Sidebar > Vug; File > Export > Vug Field, Vug Network",
    "category": "Add Mesh",
}

from . import folders, network_operators, operators, panel, properties  # noqa: E402  Blender reads bl_info first

MODULES = (properties, operators, network_operators, panel, folders)


def register():
    for module in MODULES:
        module.register()


def unregister():
    for module in reversed(MODULES):
        module.unregister()
