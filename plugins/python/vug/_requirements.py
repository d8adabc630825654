# SPDX-License-Identifier: Apache-2.0
"""Checks the requirements of the package: the Python version and numpy. Raises an ImportError that states the
remedy."""
import importlib.machinery
import os
import sys

_folder = os.path.dirname(os.path.abspath(__file__))
_built = [name for name in os.listdir(_folder) if name.startswith("_vug.") and name.endswith(".so")]

if not any("_vug" + end in _built for end in importlib.machinery.EXTENSION_SUFFIXES):
    _for = ", ".join(sorted(name.split(".")[1] for name in _built)) or "no Python version"
    raise ImportError(
        f"vug in {_folder} is built for {_for}, and this is Python {sys.version_info[0]}.{sys.version_info[1]} "
        f"({sys.executable}): run it with the Python that it was built for (Debian's is /usr/bin/python3), or build "
        "it for this version: cmake -DPython_EXECUTABLE=...")

try:
    import numpy  # noqa: F401
except ImportError as error:
    raise ImportError(
        f"vug needs numpy, which {sys.executable} does not find ({error}): install Debian's package python3-numpy, "
        "or numpy with pip of that Python") from error
