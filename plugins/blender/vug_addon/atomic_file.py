# SPDX-License-Identifier: Apache-2.0
"""Atomic replacement of files. This module does not use bpy."""
import contextlib
import os


@contextlib.contextmanager
def replacing(path):
    """Context manager that yields a temporary path next to `path`, which replaces `path` at the end. If an
    exception occurs, the old file is kept."""
    folder, name = os.path.split(path)
    temporary = os.path.join(folder, f".{name}.{os.getpid()}")
    try:
        yield temporary
        os.replace(temporary, path)
    finally:
        if os.path.exists(temporary):
            os.remove(temporary)
