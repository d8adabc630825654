# SPDX-License-Identifier: Apache-2.0
"""Folders of the files that Blender references: next to the .blend or, while it is unsaved, in a folder in the
user's data.

When the .blend is saved, the files are copied next to it. The file on disk still refers to the old folder, so
that folder is kept, with a note of its owner, until the file is saved again. Deleting it too early does no harm:
an update rebuilds missing files.
"""
import os
import shutil
import time

import bpy
from bpy.app.handlers import persistent

from . import properties
from .atomic_file import replacing

NOTE = "named_by"  # in a folder that was unused_folders: the .blend that may name it on the disk
DAYS = 30  # lifetime of folders of unsaved files, which Blender can recover


def store():
    return bpy.utils.user_resource("DATAFILES", path="vug")


def new_folder(name):
    """The folder for a new cave."""
    if bpy.data.filepath:
        return f"//vug/{name}/"
    stem = os.path.join(store(), name)
    folder, number = stem, 1
    while os.path.exists(folder):
        number += 1
        folder = f"{stem}_{number}"
    return os.path.join(folder, "")


def is_stored(folder):
    return os.path.dirname(os.path.normpath(folder)) == os.path.normpath(store())


def move_beside_blend(collection):
    """Copies a cave's files next to the .blend and updates all references to them."""
    old, new = os.path.normpath(collection.vug.folder), f"//vug/{collection.name}/"
    target = bpy.path.abspath(new)
    if os.path.isdir(old):
        os.makedirs(target, exist_ok=True)
        for name in os.listdir(old):
            if name != NOTE:
                with replacing(os.path.join(target, name)) as temporary:
                    shutil.copyfile(os.path.join(old, name), temporary)
        with open(os.path.join(old, NOTE), "w", encoding="utf-8") as note:
            note.write(bpy.data.filepath)
    for each in (*bpy.data.volumes, *bpy.data.images):
        if os.path.dirname(os.path.normpath(bpy.path.abspath(each.filepath))) == old:
            each.filepath = new + os.path.basename(each.filepath)
    collection.vug.folder = new


def move_all_beside_blend():
    if not bpy.data.filepath:
        return
    for collection in properties.caves():
        if is_stored(collection.vug.folder):
            try:
                move_beside_blend(collection)
            except OSError as error:
                print(f"Vug: the volumes of '{collection.name}' remain in {collection.vug.folder}: {error}")


def unused_folders():
    """(folder, .blend that may refer to it or "") of all folders that no cave of this file uses."""
    used = {os.path.normpath(each.vug.folder) for each in properties.caves()}
    for name in sorted(os.listdir(store())) if os.path.isdir(store()) else ():
        folder = os.path.join(store(), name)
        if not os.path.isdir(folder) or os.path.normpath(folder) in used:
            continue
        note = os.path.join(folder, NOTE)
        owner = ""
        if os.path.isfile(note):
            with open(note, encoding="utf-8") as file:
                owner = file.read()
        yield folder, owner


def sweep():
    """Removes folders whose .blend no longer exists, and old folders of unsaved files."""
    for folder, owner in unused_folders():
        old = time.time() - os.path.getmtime(folder) > DAYS * 86400
        if not os.path.exists(owner) if owner else old:
            shutil.rmtree(folder, ignore_errors=True)


@persistent
def after_save(*_):
    for folder, owner in unused_folders():  # the file on disk now equals the open file
        if owner == bpy.data.filepath:
            shutil.rmtree(folder, ignore_errors=True)
    move_all_beside_blend()


@persistent
def after_load(*_):
    move_all_beside_blend()


def register():
    bpy.app.handlers.save_post.append(after_save)
    bpy.app.handlers.load_post.append(after_load)
    bpy.app.timers.register(sweep, first_interval=5)  # no data is available during registration


def unregister():
    if bpy.app.timers.is_registered(sweep):
        bpy.app.timers.unregister(sweep)
    bpy.app.handlers.save_post.remove(after_save)
    bpy.app.handlers.load_post.remove(after_load)
