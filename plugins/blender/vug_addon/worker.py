# SPDX-License-Identifier: Apache-2.0
"""Runs in a separate Python process: builds a scene and writes the files that the add-on imports.

The first line of its input is the order, in JSON: `source`, `params` (changed parameters by name), `seed`
or null, `known` (key of the result that Blender has) and `folder` for the output. It prints lines of JSON:
`scene` (parameters that can be set, and variants), `share` and `what` during the work, and finally `same`, `done` or
`error`. It ends at the end of its input, so that it never outlives Blender.
"""
import hashlib
import json
import os
import sys
import threading
import time
import warnings


def say(**words):
    print(json.dumps(words), flush=True)


def end_with_input():
    sys.stdin.read()
    os._exit(3)


def text_of(value, kind):
    """Converts a value for vug: names are passed as text of the scene language, strings are quoted."""
    if kind == "true or false":
        return bool(value)
    return json.dumps(value, ensure_ascii=False) if kind == "text" else value


def scene_of(vug, order):
    scene = vug.load(order["source"], seed=order["seed"])
    known = scene.params
    changed = {name: text_of(value, known[name].type) for name, value in order["params"].items()
               if name in known}
    return scene.with_(changed) if changed else scene


def key_of(vug, scene):
    """A hash of all inputs of the scene: its texts, overrides and files."""
    digest = hashlib.sha256(json.dumps([vug.__version__, scene.recipe, scene.seed]).encode())
    for name in sorted(map(str, scene.files)):
        about = os.stat(name)
        digest.update(f"{name} {about.st_size} {about.st_mtime_ns}\n".encode())
    return digest.hexdigest()


def progress_printer():
    last = [0.0]

    def tell(share, what):
        now = time.monotonic()
        if now - last[0] > 0.1 or share == 1:
            last[0] = now
            say(share=share, what=what)

    return tell


def work(order):
    import vug
    with warnings.catch_warnings(record=True) as doubts:
        warnings.simplefilter("always")
        scene = scene_of(vug, order)
    key = key_of(vug, scene)
    say(scene={"name": scene.name, "key": key,
               "params": [param._asdict() for param in scene.params.values()],
               "variants": scene.variants})
    if key == order["known"]:
        return say(same=True)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        files = scene.export(order["folder"], "blender", progress=progress_printer())
    lines = [str(each.message).partition("\n")[0] for each in doubts + told]
    say(done={"files": [os.path.basename(file) for file in files], "warnings": lines})


def main():
    del sys.path[0]  # modules next to this file need bpy and must not be imported
    order = json.loads(sys.stdin.readline())
    threading.Thread(target=end_with_input, daemon=True).start()
    try:
        work(order)
    except ImportError as error:
        say(error=f"Vug's Python package cannot be loaded ({error}): set its folder in the add-on's preferences")
    except Exception as error:  # every error must be reported to Blender
        faults = [each for each in getattr(error, "diagnostics", ()) if each.severity == "error"]
        first = (faults or [error])[0]
        place = ":".join(str(part) for part in (getattr(first, "file", None), getattr(first, "line", None),
                                                getattr(first, "column", None)) if part)
        if place.startswith("-D "):  # overrides have no file
            place = ""
        sentence = getattr(first, "message", None) or str(error) or type(error).__name__
        hint = getattr(first, "hint", None)
        say(error=(f"{place}: " if place else "") + sentence + (f" ({hint})" if hint else ""))
    sys.stdout.flush()
    os._exit(0)  # the thread that waits for input does not end


main()
