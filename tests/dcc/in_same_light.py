# SPDX-License-Identifier: Apache-2.0
"""Runs inside Blender: imports same.vug with the add-on and renders it with Cycles.

blender --background --factory-startup --python in_same_light.py -- FOLDER ADDON WIDTH HEIGHT SPP RUNS BOUNCES
"""
import sys

import bpy
import numpy

folder, addon, *numbers = sys.argv[sys.argv.index("--") + 1:]
width, height, spp, runs, bounces = map(int, numbers)
bpy.ops.wm.read_factory_settings(use_empty=True)
sys.dont_write_bytecode = True
sys.path.append(addon)
import vug_addon  # noqa: E402

vug_addon.register()
bpy.ops.vug.add(filepath=f"{folder}/same.vug")
scene = bpy.context.scene
scene.camera = bpy.data.objects["main"]
scene.render.engine = "CYCLES"
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
scene.render.threads_mode, scene.render.threads = "FIXED", 2
scene.render.image_settings.file_format, scene.render.image_settings.color_depth = "OPEN_EXR", "32"
cycles = scene.cycles
cycles.device, cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = "CPU", spp, False, False
cycles.max_bounces = cycles.diffuse_bounces = bounces
cycles.sample_clamp_indirect = cycles.sample_clamp_direct = cycles.light_sampling_threshold = 0
cycles.pixel_filter_type = "BOX"
cycles.filter_width = 1
for thing in bpy.data.objects:  # the shadow terminator offset hides facets of coarse meshes and is not physical
    if thing.type == "MESH":
        thing.cycles.shadow_terminator_offset = thing.cycles.shadow_terminator_geometry_offset = 0
for run in range(runs):
    cycles.seed = run + 1
    scene.render.filepath = f"{folder}/cycles_{run}.exr"
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    image.colorspace_settings.name = "Non-Color"
    pixels = numpy.empty(width * height * 4, numpy.float32)
    image.pixels.foreach_get(pixels)
    numpy.save(f"{folder}/cycles_{run}.npy", pixels.reshape(height, width, 4)[::-1, :, :3])
    bpy.data.images.remove(image)
