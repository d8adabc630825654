# SPDX-License-Identifier: Apache-2.0
"""Objects that a cave has added to Blender's file. Objects that an artist has deleted are restored by an update."""
import json
import os

import bpy

from . import parameters, sky

NAME = "vug_name"  # name of an object in its scene


def objects(collection):
    """Objects of the scene by name, including those in nested collections."""
    return {each[NAME]: each for each in collection.all_objects if NAME in each}


def note(collection):
    """Records the current objects of the cave."""
    things = {name: {"object": thing.name, "type": thing.type,
                     "attributes": [each.name for each in thing.data.attributes] if thing.type == "MESH" else []}
              for name, thing in objects(collection).items()}
    collection.vug.owned = json.dumps({"objects": things, "sky": sky.of(collection) is not None})


def noted(collection):
    return json.loads(collection.vug.owned or '{"objects": {}, "sky": false}')


def adopt(collection):
    """Restores the identifying property of objects that have lost it, by their names in Blender."""
    there = objects(collection)
    lost = {about["object"]: name for name, about in noted(collection)["objects"].items() if name not in there}
    for thing in collection.all_objects:
        if NAME not in thing and thing.name in lost:
            thing[NAME] = lost[thing.name]


def is_whole(thing, about):
    if thing is None or thing.type != about["type"]:
        return False
    if thing.type == "VOLUME":
        return os.path.isfile(bpy.path.abspath(thing.data.filepath))
    if thing.type == "MESH":
        return (all(name in thing.data.attributes for name in about["attributes"])
                and all(thing.data.materials) and len(thing.data.materials) > 0)
    return True


def missing(collection):
    """Names of recorded objects that are deleted or incomplete, and of missing parameters."""
    known, there = noted(collection), objects(collection)
    out = [name for name, about in known["objects"].items() if not is_whole(there.get(name), about)]
    if known["sky"] and sky.of(collection) is None:
        out.append("sky")
    return out + parameters.missing(collection)
