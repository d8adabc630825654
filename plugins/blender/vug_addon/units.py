"""Metres and Blender's units: Vug counts in metres, a scene of Blender in units of its own length."""
import bpy


def metres_per_unit(scene=None):
    """What one unit of the scene is long. Where a scene has no system of units a unit is a metre, as
    Blender shows it then."""
    settings = (scene or bpy.context.scene).unit_settings
    return 1.0 if settings.system == "NONE" else settings.scale_length
