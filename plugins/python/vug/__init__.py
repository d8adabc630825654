# SPDX-License-Identifier: Apache-2.0
"""Vug grows film-grade caves from grammars.

    import vug
    scene = vug.load("grotto.vug", seed=3)
    build = scene.build()
    mesh = build.mesh()
    image = scene.render(spp=16, size=(480, 270))
    image.save("grotto.exr")

Lengths are metres, angles radians; space is right-handed, y up. See docs/guides/python.md.
"""
import warnings as _warnings

from . import _requirements  # noqa: F401  reports missing requirements before an import fails
from . import _vug
from ._catalogue import Catalogue, Kind, KindParam
from ._errors import Cancelled, Diagnostic, Error, SceneWarning
from ._functions import Function, FunctionParam
from ._params import Param
from ._vug import (Build, Cells, Derivation, Diff, Grid, Image, LevelSet, Mesh, Scene, __version__,
                   diff, load, load_plugin, loads, read_mesh, scene_of)

catalogue = Catalogue()

__all__ = ["Build", "Cancelled", "Catalogue", "Cells", "Derivation", "Diagnostic", "Diff", "Error",
           "Function", "FunctionParam", "Grid", "Image", "Kind", "KindParam", "LevelSet", "Mesh", "Param", "Scene",
           "SceneWarning", "catalogue", "diff", "load", "load_plugin", "loads",
           "read_mesh", "scene_of"]

for _type in (Build, Cells, Derivation, Diff, Grid, Image, LevelSet, Mesh, Scene):
    _type.__module__ = __name__

for _plugin in _vug.plugins_in_path():
    try:
        load_plugin(_plugin)
    except Error as _error:  # the package works without the plugin
        _warnings.warn(str(_error), SceneWarning, stacklevel=2)
