# SPDX-License-Identifier: Apache-2.0
"""Metres and Blender's units: Vug uses metres, a scene of Blender has a unit scale."""
import bpy


def metres_per_unit(scene=None):
    """Length of one unit of the scene in metres. Without a unit system, a unit is a metre, as Blender displays
    it."""
    settings = (scene or bpy.context.scene).unit_settings
    return 1.0 if settings.system == "NONE" else settings.scale_length
