# SPDX-License-Identifier: Apache-2.0
"""Checks of the add-on in Blender: saving, reopening and cleaning up files, and memory."""
import gc
import os
import shutil
import time

import bpy
import numpy

from addon_helpers import cave, equal, near, nothing_is_built, print_of, resident, thing, volume_of

folder = os.getcwd()


def save():
    from vug_addon import folders
    cave()["R"] = 0.8
    bpy.ops.vug.update(cave="cave")
    # Saving a file for the first time moves its volumes next to it; later the temporary ones are deleted.
    old = cave().vug.folder
    assert folders.is_stored(old) and os.path.exists(f"{old}/cave_rock.vdb"), old
    bpy.ops.wm.save_as_mainfile(filepath=f"{folder}/saved.blend")
    equal(cave().vug.folder, "//vug/cave/")
    equal(thing("rock volume").data.filepath, "//vug/cave/cave_rock.vdb")
    picture = next(node.image for node in bpy.context.scene.world.node_tree.nodes if node.type == "TEX_ENVIRONMENT")
    equal(picture.filepath, "//vug/cave/cave_heaven.exr")
    assert os.path.exists(f"{folder}/vug/cave/cave_rock.vdb")
    assert os.path.exists(old), "the file on the disk still names it"
    nothing_is_built()
    shutil.copy(f"{folder}/saved.blend", f"{folder}/first.blend")
    bpy.ops.wm.save_mainfile()
    assert not os.path.exists(old), "no file refers to it any more"


def sweeps():
    """Deletes the folders of deleted files and of files that were never saved, the latter only if they are old."""
    from vug_addon import folders
    kept = ("young", "of_this", "of_another")
    for name in (*kept, "old", "of_none"):
        os.makedirs(os.path.join(folders.store(), name))
    for name, owner in (("of_this", bpy.data.filepath), ("of_another", f"{folder}/first.blend"), ("of_none", "/no.blend")):
        with open(os.path.join(folders.store(), name, folders.NOTE), "w") as note:
            note.write(owner)
    then = time.time() - 40 * 86400
    os.utime(os.path.join(folders.store(), "old"), (then, then))
    folders.sweep()
    equal(sorted(set(os.listdir(folders.store()))), sorted(kept))
    for name in kept:
        shutil.rmtree(os.path.join(folders.store(), name))


def memory():
    """Twenty runs that each recreate all meshes, after five warm-up runs. A mesh of 5300 vertices takes about
    1 MB in Blender and its arrays half of that, so a leak of either would amount to 10 or 20 MB."""
    sizes, meshes = [], len(bpy.data.meshes)
    for i in range(25):
        cave()["R"] = 0.6 + 0.01 * i
        cave()["LEAN"] = 0.1 + 0.01 * i
        equal(bpy.ops.vug.update(cave="cave"), {"FINISHED"})
        gc.collect()
        sizes.append(resident())
    print(f"# MB after 5 and 25 updates: {sizes[4]:.1f} {sizes[-1]:.1f}; {len(thing('wall').data.vertices)} vertices")
    assert sizes[-1] - sizes[4] < 8, sizes
    equal(len(bpy.data.meshes), meshes)


def reloads():
    bpy.ops.preferences.addon_enable(module="vug_addon")
    bpy.ops.wm.open_mainfile(filepath=f"{folder}/saved.blend")
    equal(cave()["R"], 0.8)
    near(cave().id_properties_ui("R").as_dict()["max"], 1, 1e-12)
    near(volume_of(thing("wall").data), 4 / 3 * numpy.pi * 0.8**3, 0.02)
    assert "Cd" in thing("wall").data.attributes
    # The first saved file refers to the folder that was cleaned up, by its new location.
    bpy.ops.wm.open_mainfile(filepath=f"{folder}/first.blend")
    equal(cave().vug.folder, "//vug/cave/")
    assert thing("rock volume").data.grids.load()
    bpy.ops.wm.open_mainfile(filepath=f"{folder}/saved.blend")
    rock = thing("rock volume").data
    assert rock.grids.load(), rock.grids.error_message
    before = print_of(cave())
    equal(bpy.ops.vug.update(cave="cave"), {"FINISHED"})
    equal(print_of(cave()) == before, True, "nothing has changed since it was saved")
    cave()["R"] = 0.6
    bpy.ops.vug.update(cave="cave")
    near(volume_of(thing("wall").data), 4 / 3 * numpy.pi * 0.6**3, 0.01)
    bpy.ops.preferences.addon_disable(module="vug_addon")
    assert not hasattr(bpy.types.Collection, "vug")
