"""Where the files of caves lie that Blender reads as files: beside the .blend, or, as long as that has not been
saved, in a folder of their own among the user's data.

When the .blend is saved they are copied beside it. The file on the disk still names the old folder then, so that
one stays, with a note of who named it, until that file is saved again. What is gone too early is no harm: an
update misses it and makes it again.
"""
import os
import shutil
import time

import bpy
from bpy.app.handlers import persistent

from . import properties
from .atomic_file import replacing

NOTE = "named_by"  # in a folder that was unused_folders: the .blend that may name it on the disk
DAYS = 30  # for which one stays whose .blend was never saved: Blender can recover such


def store():
    return bpy.utils.user_resource("DATAFILES", path="vug")


def new_folder(name):
    """For a new cave."""
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
    """Copies a cave's files beside the .blend; all that reads them does so there from then on."""
    old, new = os.path.normpath(collection.vug.folder), f"//vug/{collection.name}/"
    target = bpy.path.abspath(new)
    if os.path.isdir(old):
        os.makedirs(target, exist_ok=True)
        for name in os.listdir(old):
            if name != NOTE:
                with replacing(os.path.join(target, name)) as beside:
                    shutil.copyfile(os.path.join(old, name), beside)
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
                print(f"Vug: the volumes of '{collection.name}' stay in {collection.vug.folder}: {error}")


def unused_folders():
    """(folder, the .blend that may name it or "") of all that no cave of this file needs."""
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
    """What was unused_folders by files that are gone, or never were saved and are old."""
    for folder, owner in unused_folders():
        old = time.time() - os.path.getmtime(folder) > DAYS * 86400
        if not os.path.exists(owner) if owner else old:
            shutil.rmtree(folder, ignore_errors=True)


@persistent
def after_save(*_):
    for folder, owner in unused_folders():  # the file on the disk is as it is here
        if owner == bpy.data.filepath:
            shutil.rmtree(folder, ignore_errors=True)
    move_all_beside_blend()


@persistent
def after_load(*_):
    move_all_beside_blend()


def register():
    bpy.app.handlers.save_post.append(after_save)
    bpy.app.handlers.load_post.append(after_load)
    bpy.app.timers.register(sweep, first_interval=5)  # while add-ons are registered there is no data


def unregister():
    if bpy.app.timers.is_registered(sweep):
        bpy.app.timers.unregister(sweep)
    bpy.app.handlers.save_post.remove(after_save)
    bpy.app.handlers.load_post.remove(after_load)
