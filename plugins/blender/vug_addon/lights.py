# SPDX-License-Identifier: Apache-2.0
"""Lights and cameras equivalent to Vug's. Blender's watts are those of a light that emits in all directions as
it does along its axis. docs/guides/export.md describes the lights in exported files.

`scale` is the number of Blender units per metre. Watts are multiplied by its square, so that the illumination
does not depend on the unit scale, as in Blender itself."""
import math

LUMEN_PER_WATT = 683  # of each colour; as the file is written
FILM = 36  # millimetres


def kind_of(about):
    extras = about.get("extras", {})
    if about["type"] == "directional":
        return "SUN"
    if about["type"] == "point":
        return "POINT"
    spot = about.get("spot", {})
    flat = spot.get("innerConeAngle", 0) == 0 and spot.get("outerConeAngle", 0) > 1.57079
    return "AREA" if "vug:width" in extras or (flat and "vug:radius" in extras) else "SPOT"


def fill_light(light, about, scale):
    extras = about.get("extras", {})
    axis = about.get("intensity", 1) / LUMEN_PER_WATT  # W/sr along the axis; of a sun W/m2
    watts = axis * scale**2
    light.color = about.get("color", (1, 1, 1))
    if hasattr(light, "use_soft_falloff"):
        light.use_soft_falloff = False
    if light.type == "SUN":
        light.energy = axis
        light.angle = extras.get("vug:angle", 0)
    elif light.type == "AREA":
        light.energy = 4 * watts  # an area light of Cycles has a radiance of energy / (4 area)
        light.shape = "RECTANGLE" if "vug:width" in extras else "DISK"
        width = extras.get("vug:width", 2 * extras.get("vug:radius", 0.5))
        light.size, light.size_y = scale * width, scale * extras.get("vug:height", width)
    else:
        light.energy = 4 * math.pi * watts
        light.shadow_soft_size = scale * extras.get("vug:radius", 0)
        if light.type == "SPOT":
            outer = about["spot"].get("outerConeAngle", math.pi / 4)
            light.spot_size = 2 * outer
            light.spot_blend = 1 - about["spot"].get("innerConeAngle", 0) / outer


def fill_camera(camera, about, scale):
    camera.sensor_fit, camera.sensor_width = "HORIZONTAL", FILM
    if about["type"] == "orthographic":
        camera.type = "ORTHO"
        view = about["orthographic"]
        camera.ortho_scale = 2 * view["xmag"] * scale
    else:
        camera.type = "PERSP"
        view = about["perspective"]
        camera.angle_x = 2 * math.atan(math.tan(view["yfov"] / 2) * view["aspectRatio"])
    camera.clip_start, camera.clip_end = scale * view["znear"], scale * view["zfar"]
    extras = about.get("extras", {})
    camera.dof.use_dof = "vug:aperture" in extras
    if camera.dof.use_dof:
        camera.dof.focus_distance = scale * extras["vug:focus"]
        camera.dof.aperture_fstop = camera.lens / 1000 / (scale * extras["vug:aperture"])
