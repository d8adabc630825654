# SPDX-License-Identifier: Apache-2.0
"""Runs inside a Blender with a window: uses the add-on by a user's clicks and keys.

blender --factory-startup --enable-event-simulate --python in_window.py -- FOLDER ADDON

Modal operators return at once there, so the checks run one after the other in a timer.
"""
import os
import sys
import time
import traceback

import bpy

folder, addon = sys.argv[sys.argv.index("--") + 1:]
sys.dont_write_bytecode = True
sys.path.append(addon)
import vug_addon  # noqa: E402
from vug_addon.cave_build import CaveBuild  # noqa: E402

vug_addon.register()


def window():
    return bpy.context.window_manager.windows[0]


def view():
    area = next(each for each in window().screen.areas if each.type == "VIEW_3D")
    return {"window": window(), "area": area, "region": next(r for r in area.regions if r.type == "WINDOW")}


def call(operator, *arguments, **more):
    with bpy.context.temp_override(**view()):
        return operator(*arguments, **more)


def ended():
    """Waits for the current build to end: a generator for `yield from`."""
    begun = time.monotonic()
    while CaveBuild.current:
        assert time.monotonic() - begun < 120, "it does not end"
        yield


def cave():
    return bpy.data.collections.get("cave")


def wall():
    return next(each for each in cave().objects if each["vug_name"] == "wall")


def checks():
    # The call that the file browser makes when a file has been chosen.
    assert call(bpy.ops.vug.add, "EXEC_DEFAULT", filepath=f"{folder}/cave.vug", chosen=True) == {"FINISHED"}
    assert CaveBuild.current and cave() is None, "it does not wait"
    yield from ended()
    assert cave() is not None
    yield "added"

    size = wall().dimensions.x
    cave()["R"] = 0.9
    assert call(bpy.ops.vug.update, "INVOKE_DEFAULT") == {"FINISHED"}
    assert not bpy.ops.vug.update.poll(), "a second one meanwhile"
    yield from ended()
    bpy.context.view_layer.update()
    assert abs(wall().dimensions.x - 1.8) < 0.01 < abs(size - 1.8), wall().dimensions
    yield "updated"

    call(bpy.ops.ed.undo)
    bpy.context.view_layer.update()
    assert abs(wall().dimensions.x - size) < 0.01, wall().dimensions
    call(bpy.ops.ed.redo)
    bpy.context.view_layer.update()
    assert abs(wall().dimensions.x - 1.8) < 0.01, wall().dimensions
    yield "undone and redone"

    for stop in (escape, bpy.ops.vug.cancel):
        cave().vug.source = f"{folder}/slow.vug"
        cave()["R"] = 0.8
        call(bpy.ops.vug.update, "INVOKE_DEFAULT")
        build = CaveBuild.current
        while build.share == 0:
            assert CaveBuild.current, f"it was too fast to stop: {build.error} {build.message}"
            yield
        stop()
        yield from ended()
        assert build.cancelled and not os.path.exists(build.job.folder)
        assert abs(wall().dimensions.x - 1.8) < 0.01, wall().dimensions
    yield "cancelled by Esc and by the button"

    cave().vug.source = f"{folder}/cave.vug"
    cave()["R"] = 9.0
    call(bpy.ops.vug.update, "INVOKE_DEFAULT")
    yield from ended()
    yield
    assert "'R' is 9" in cave().vug.stale, cave().vug.stale
    draw_sidebar()
    for _ in range(5):
        yield
    yield "an error is reported"


def escape():
    x, y = window().width // 2, window().height // 2
    window().event_simulate(type="ESC", value="PRESS", x=x, y=y)
    window().event_simulate(type="ESC", value="RELEASE", x=x, y=y)


def draw_sidebar():
    """Ensures that the panel, which shows an error, is drawn at least once."""
    place = view()
    place["area"].spaces.active.show_region_ui = True
    place["area"].tag_redraw()


running = checks()


def go_on():
    try:
        done = next(running)
    except StopIteration:
        print("\nALL GOOD", flush=True)
        os._exit(0)
    except BaseException:
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)
    if done:
        print("ok", done, flush=True)
    return 0.05


bpy.app.timers.register(go_on, first_interval=1.0)
