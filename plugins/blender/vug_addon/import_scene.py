# SPDX-License-Identifier: Apache-2.0
"""Imports the output of a worker into a cave's collection. Existing data-blocks are updated in place if they
have changed, so that materials, modifiers and transforms added by an artist are preserved."""
import hashlib
import json
import os
import shutil

import bpy
from mathutils import Matrix

from . import geometry, lights, materials, ownership, parameters, sky, units
from .atomic_file import replacing
from .glb import Glb
from .ownership import NAME

DIGEST = "vug_digest"
MAKERS = {"mesh": lambda name, kind: bpy.data.meshes.new(name),
          "camera": lambda name, kind: bpy.data.cameras.new(name),
          "light": lambda name, kind: bpy.data.lights.new(name, kind),
          "volume": lambda name, kind: bpy.data.volumes.new(name)}


def digest(*parts):
    sum_ = hashlib.sha256()
    for part in parts:
        sum_.update(memoryview(part).cast("B") if hasattr(part, "dtype") else repr(part).encode())
    return sum_.hexdigest()


def has_changed(thing, *parts):
    """Whether the digest of `parts` differs from the one stored in `thing`, which is then updated."""
    now = digest(*parts)
    if thing.get(DIGEST) == now:
        return False
    thing[DIGEST] = now
    return True


class SceneImporter:
    def __init__(self, collection, glb):
        self.collection, self.glb = collection, glb
        ownership.adopt(collection)
        self.objects = ownership.objects(collection)
        self.before = set(self.objects)
        self.materials = {slot.material[NAME]: slot.material for each in self.objects.values()
                          for slot in each.material_slots if slot.material and NAME in slot.material}
        self.sharing = {}  # names of the objects that share a mesh, by mesh index
        for name, kind, index, _ in glb.nodes:
            if kind == "mesh":
                self.sharing.setdefault(index, []).append(name)
        self.data = {}
        self.changed = 0

    def object(self, name, kind, data, place):
        thing = self.objects.get(name)
        if thing and thing.type != kind.upper():
            bpy.data.objects.remove(thing)
            thing = None
        if not thing:
            thing = bpy.data.objects.new(name, data)
            thing[NAME] = name
            self.collection.objects.link(thing)
        elif thing.data != data:
            thing.data = data
        self.before.discard(name)
        if has_changed(thing, [list(row) for row in place]):
            thing.matrix_world = place
        return thing

    def data_of(self, kind, names, sort=None):
        """The data-block of the first existing object among `names`, or a new one."""
        for name in names:
            thing = self.objects.get(name)
            if thing and thing.type == kind.upper() and sort in (None, getattr(thing.data, "type", None)):
                return thing.data
        return MAKERS[kind](names[0], sort)

    def mesh(self, index):
        if index in self.data:
            return self.data[index]
        surface = self.glb.surface(index)
        mesh = self.data[index] = self.data_of("mesh", self.sharing[index])
        arrays = [surface.positions, surface.triangles, *surface.attributes.values()]
        if surface.normals is not None:
            arrays.append(surface.normals)
        if len(surface.materials) > 1:
            arrays.append(surface.slots)
        if has_changed(mesh, *arrays, list(surface.attributes)):
            geometry.fill(mesh, surface)
            self.changed += 1
        elif len(mesh.vertices) == len(surface.positions):
            geometry.add_missing(mesh, surface)
        self.assign_materials(mesh, surface)
        return mesh

    def assign_materials(self, mesh, surface):
        """Fills the slots of the mesh. Materials that an artist has assigned are kept."""
        made = [self.material(surface, number) for number in surface.materials]
        if len(made) == 1 and len(mesh.materials) > 1:  # slots may have been added around ours
            ours = [i for i, each in enumerate(mesh.materials) if not each or NAME in each]
            if ours and mesh.materials[ours[0]] != made[0]:
                mesh.materials[ours[0]] = made[0]
            return
        for slot, material in enumerate(made):
            if slot == len(mesh.materials):
                mesh.materials.append(material)
            elif mesh.materials[slot] is None or NAME in mesh.materials[slot]:
                if mesh.materials[slot] != material:
                    mesh.materials[slot] = material

    def material(self, surface, number):
        about, channels = self.glb.list("materials")[number], materials.channels_of(surface)
        name = about.get("name") or surface.name
        key = f"{name}|{'+'.join(channels)}|{number}"
        material = self.materials.get(key)
        if not material:
            material = self.materials[key] = bpy.data.materials.new(name)
            material[NAME] = key
        if has_changed(material, json.dumps(about, sort_keys=True), channels):
            materials.build(material, about, channels)
        return material

    def nodes(self):
        for name, kind, index, place in self.glb.nodes:
            if kind == "mesh":
                data = self.mesh(index)
            else:
                about = (self.glb.lights if kind == "light" else self.glb.list("cameras"))[index]
                sort = lights.kind_of(about) if kind == "light" else None
                data = self.data_of(kind, [name], sort)
                if has_changed(data, json.dumps(about, sort_keys=True), self.glb.scale):
                    (lights.fill_light if kind == "light" else lights.fill_camera)(data, about, self.glb.scale)
            self.object(name, kind, data, place)

    def use_camera(self, scene, resolution):
        """Sets the cave's first camera if the scene has none, and optionally the size of its picture."""
        first = next((each for each in self.glb.nodes if each[1] == "camera"), None)
        if scene.camera or not first:
            return
        scene.camera = ownership.objects(self.collection)[first[0]]
        size = self.glb.list("cameras")[first[2]].get("extras", {}).get("vug:size")
        if resolution and size:
            scene.render.resolution_x, scene.render.resolution_y = size
            scene.render.resolution_percentage = 100

    def volume(self, name, path, about):
        data = self.data_of("volume", [name])
        stored = bpy.path.relpath(path) if bpy.data.filepath and self.collection.vug.folder.startswith(
            "//") else path
        if data.filepath == stored:
            data.grids.unload()
        data.filepath = stored
        data.grids.load()
        level_set = "surface" in data.grids or "air" in data.grids
        if "extinction" in about:
            self.assign_volume_material(data, name, about)
        # The file is in metres. Blender does not change the opacity of a scaled volume.
        thing = self.object(name, "volume", data, Matrix.Scale(self.glb.scale, 4))
        if level_set:  # for modelling only; rendered as a fog, it would hide the mesh
            thing.hide_render, thing.display_type = True, "BOUNDS"

    def assign_volume_material(self, data, name, about):
        material = self.materials.get(name)
        if not material:
            material = self.materials[name] = bpy.data.materials.new(name)
            material[NAME] = name
        if has_changed(material, json.dumps(about, sort_keys=True)):
            materials.build_volume(material, about)
        if not data.materials:
            data.materials.append(material)

    def sweep(self):
        """Removes objects and materials that the scene no longer contains."""
        for name in self.before:
            thing = self.objects[name]
            data = thing.data
            bpy.data.objects.remove(thing)
            if data and not data.users:
                bpy.data.batch_remove([data])
        for material in self.materials.values():
            if not material.users:
                bpy.data.materials.remove(material)


def move_files(collection, files, folder):
    """Moves the files that Blender references, volumes and environment maps, to the cave's folder. Each file is
    replaced atomically. Returns their paths."""
    target = bpy.path.abspath(collection.vug.folder)
    out = []
    for name in files:
        if not name.endswith((".vdb", ".exr")):
            continue
        os.makedirs(target, exist_ok=True)
        path = os.path.join(target, name)
        with replacing(path) as temporary:
            shutil.copyfile(os.path.join(folder, name), temporary)
        out.append(path)
    return out


def import_into(collection, scene, files, folder):
    """Imports a scene and returns the SceneImporter. Errors occur before any data-block is changed."""
    metres = units.metres_per_unit()
    glb = Glb(os.path.join(folder, scene["name"] + ".glb"), 1 / metres)
    for index in range(len(glb.list("meshes"))):
        glb.surface(index)
    paths = move_files(collection, files, folder)
    parameters.update(collection, scene["params"], metres)
    collection.vug.variants = json.dumps(scene["variants"])
    importer = SceneImporter(collection, glb)
    importer.nodes()
    stem = scene["name"] + "_"
    clouds = {about["file"]: about for about in glb.extras("vug:volumes")}
    for path in paths:
        name, end = os.path.splitext(os.path.basename(path))
        if end == ".vdb":
            own = name[len(stem):] if name.startswith(stem) else name
            importer.volume(own + " volume", path, clouds.get(os.path.basename(path), {}))
    sky.update_world(collection, glb.extras("vug:skies"), bpy.path.abspath(collection.vug.folder), has_changed)
    importer.sweep()
    ownership.note(collection)
    collection.vug.known, collection.vug.metres_per_unit = scene["key"], metres
    return importer
