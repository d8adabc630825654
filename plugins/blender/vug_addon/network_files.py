# SPDX-License-Identifier: Apache-2.0
"""Writes a curve or an armature as the network of a cave, with a scene that uses it, and reads networks."""
import os

from . import curves, export_field, networks, svx_reader, svx_writer


def scene(title, file, keeps_place, voxel):
    place = "" if keeps_place else ", recenter: false"
    return f"""# Passages along the object {title!a} of Blender; change it there and export again.
param voxel = {voxel:.6g}m  in {voxel / 8:.6g}m..{voxel * 16:.6g}m  "edge of a voxel"
network plan = survey(file: "{file}"{place})

volume air = level_set(passages(of: plan), voxel: voxel)
mesh wall on air {{}}
"""


def write(thing, path, voxel):
    """Writes the survey and, unless a scene of that name exists, a scene next to it; an edited scene is never
    overwritten. Returns a summary in one sentence."""
    path = export_field.file_of(path, ".svx", "cave.svx")
    network = curves.to_network(thing)
    export_field.replace(path, svx_writer.svx_text(network).encode())
    text = os.path.splitext(path)[0] + ".vug"
    message = f"{len(network.stations)} stations and {len(network.legs)} legs"
    if os.path.exists(text):
        return f"{message}; {os.path.basename(text)} exists and is kept"
    keeps_place = any(curves.offset_of(thing))
    export_field.replace(text, scene(thing.name, os.path.basename(path), keeps_place, voxel).encode())
    return message


def read(path, recenter):
    """The network of a survey file, and the offset by which it was moved towards the origin. Raises ValueError and
    OSError."""
    with open(path, encoding="utf-8", errors="replace") as file:
        network = svx_reader.parse(file.read(), os.path.basename(path))
    offset = networks.rounded_middle(network) if recenter else (0.0, 0.0, 0.0)
    return networks.moved(network, [-x for x in offset]), offset
