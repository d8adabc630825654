# SPDX-License-Identifier: Apache-2.0
"""The build of a cave: a worker job and the import of its result. Blender's file does not change before the
job has succeeded."""
import json
import os

import bpy

from . import folders, import_scene, ownership, parameters, properties, units
from .job import Job


def settings_of(collection):
    """The settings with which a cave is built, as JSON data."""
    cave = collection.vug
    return {"params": parameters.values(collection), "seed": cave.seed if cave.use_seed else None}


def set_to_built(collection):
    """Restores the parameters and the seed of the last build of a cave."""
    built = json.loads(collection.vug.built)
    parameters.restore(collection, built["params"])
    collection.vug.use_seed = built["seed"] is not None
    if built["seed"] is not None:
        collection.vug.seed = built["seed"]
    collection.vug.stale = ""


class CaveBuild:
    """Builds a new cave from `source`, or updates an existing collection. Call `step` repeatedly until it returns
    True; then `error` or `message` contains the result. A new cave may set the scene's `camera`, if the scene
    has none, and with it the `resolution`."""

    current = None  # one at a time: a build takes all cores

    def __init__(self, source="", collection=None, camera=True, resolution=True):
        cave = collection.vug if collection else None
        self.name = collection.name if collection else ""
        self.source = source or cave.source
        self.camera, self.resolution = camera, resolution
        self.error, self.message, self.cancelled, self.changed = "", "", False, 0
        self.tried = settings_of(collection) if collection else {}
        options = properties.preferences()
        order = {"source": os.path.abspath(bpy.path.abspath(self.source)),
                 "params": parameters.changed(collection) if collection else {},
                 "seed": self.tried.get("seed"),
                 "known": cave.known if cave and self.is_whole(collection) else ""}
        self.job = Job(order, bpy.path.abspath(options.python) if options else "",
                       bpy.path.abspath(options.package) if options else "")
        CaveBuild.current = self

    @staticmethod
    def is_whole(collection):
        return (collection.vug.metres_per_unit == units.metres_per_unit()
                and not ownership.missing(collection))

    @property
    def share(self):
        return self.job.share

    @property
    def what(self):
        return self.job.what

    def step(self, wait=0.0):
        if not self.cancelled and not self.job.poll(wait):
            return False
        try:
            if not self.cancelled:
                self.finish()
        except (OSError, ValueError, KeyError, RuntimeError) as error:
            self.error = str(error)
        finally:
            if self.error:
                self.mark_stale()
            self.end()
        return True

    def mark_stale(self):
        """Keeps the cave as it was built and marks it as out of date; the error lists the changed parameters."""
        collection = bpy.data.collections.get(self.name) if self.name else None
        if not collection:
            return
        before = json.loads(collection.vug.built or "{}").get("params", {})
        others = [f"{name} = {text_of(value)}" for name, value in self.tried["params"].items()
                  if name in before and before[name] != value]
        if others:
            self.error += f"; changed since the last build: {', '.join(others)}"
        collection.vug.stale = self.error

    def cancel(self):
        self.cancelled = True
        self.end()

    def end(self):
        self.job.close()
        if CaveBuild.current is self:
            CaveBuild.current = None

    def finish(self):
        job = self.job
        if job.error:
            self.error = job.error
            return
        if job.same:
            self.message = "nothing has changed"
            self.mark_built(bpy.data.collections.get(self.name))
            return
        collection = bpy.data.collections.get(self.name) if self.name else None
        if self.name and not collection:
            self.error = f"the cave '{self.name}' no longer exists"
            return
        made = None
        if not collection:
            made = collection = bpy.data.collections.new(job.scene["name"])
            collection.vug.folder = folders.new_folder(collection.name)
        try:
            importer = import_scene.import_into(collection, job.scene, job.done["files"], job.folder + "/set")
        except BaseException:
            if made:
                bpy.data.collections.remove(made)
            raise
        if made:
            collection.vug.source = self.source
            bpy.context.scene.collection.children.link(collection)
            if self.camera:
                importer.use_camera(bpy.context.scene, self.resolution)
        self.name, self.changed = collection.name, importer.changed
        self.mark_built(collection)
        self.message = f"{self.name}: {self.changed} meshes updated" + "".join(
            f"; {each}" for each in job.done["warnings"])

    def mark_built(self, collection):
        """Records the built settings; changes made during the build are not included."""
        if collection:
            now = settings_of(collection)
            collection.vug.built = json.dumps({**now, "params": {**now["params"], **self.tried.get("params", {})}})
            collection.vug.stale = ""


def text_of(value):
    return f"{value:.6g}" if isinstance(value, float) else str(value)
