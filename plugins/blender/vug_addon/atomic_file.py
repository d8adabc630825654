"""Files that are whole or not there. No part of bpy here."""
import contextlib
import os


@contextlib.contextmanager
def replacing(path):
    """The path of a file beside `path` to write to, which takes its place at the end; where the work between
    fails, what was there stays."""
    folder, name = os.path.split(path)
    beside = os.path.join(folder, f".{name}.{os.getpid()}")
    try:
        yield beside
        os.replace(beside, path)
    finally:
        if os.path.exists(beside):
            os.remove(beside)
