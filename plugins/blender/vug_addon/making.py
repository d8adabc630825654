"""A cave in the making: a job, and where its result goes. Nothing in Blender's file changes before the
job has ended well."""
import os

import bpy

from . import arrive, parameters, properties
from .job import Job


class Making:
    """Of a new cave from `source`, or of a cave's collection that is there. `step` now and then, until it
    gives True; then `error` or `told` says how it went."""

    current = None  # one at a time: a build takes all cores

    def __init__(self, source="", collection=None):
        cave = collection.vug if collection else None
        self.name = collection.name if collection else ""
        self.source = source or cave.source
        self.error, self.told, self.cancelled, self.changed = "", "", False, 0
        options = properties.preferences()
        order = {"source": os.path.abspath(bpy.path.abspath(self.source)),
                 "params": parameters.changed(collection) if collection else {},
                 "seed": cave.seed if cave and cave.use_seed else None,
                 "known": cave.known if cave else ""}
        self.job = Job(order, bpy.path.abspath(options.python) if options else "",
                       bpy.path.abspath(options.package) if options else "")
        Making.current = self

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
            self.end()
        return True

    def cancel(self):
        self.cancelled = True
        self.end()

    def end(self):
        self.job.close()
        if Making.current is self:
            Making.current = None

    def finish(self):
        job = self.job
        if job.error:
            self.error = job.error
            return
        if job.same:
            self.told = "nothing has changed"
            return
        collection = bpy.data.collections.get(self.name) if self.name else None
        if self.name and not collection:
            self.error = f"the cave '{self.name}' is gone"
            return
        made = None
        if not collection:
            made = collection = bpy.data.collections.new(job.scene["name"])
            collection.vug.folder = properties.folder_of_volumes(collection.name)
        try:
            self.changed = arrive.bring(collection, job.scene, job.done["files"], job.folder + "/set")
        except BaseException:
            if made:
                bpy.data.collections.remove(made)
            raise
        if made:
            collection.vug.source = self.source
            bpy.context.scene.collection.children.link(collection)
        self.name = collection.name
        left_out = [each for each in job.done["left_out"] if not expected(each)]
        self.told = f"{self.name}: {self.changed} meshes made" + "".join(f"; {each}" for each in left_out)


def expected(left_out):
    """What the file leaves out and the add-on brings nevertheless."""
    return any(part in left_out for part in (": it is in ", "depth of field of", "the size of the light",
                                             ": glTF has no skies"))
