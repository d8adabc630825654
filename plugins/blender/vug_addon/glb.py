# SPDX-License-Identifier: Apache-2.0
"""Reads the binary glTF that vug export writes. Blender's own importer omits vertex attributes other than
colours and rounds colours to 8 bits. The results use Blender's conventions: z up, and the units of the
scene."""
import json
import struct

import numpy
from mathutils import Matrix, Quaternion, Vector

TYPES = {5121: numpy.uint8, 5123: numpy.uint16, 5125: numpy.uint32, 5126: numpy.float32}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
# Converts y up to z up. Axes are converted only here.
TURN = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))


def turned(vectors):
    """Converts rows of three numbers from y up to z up."""
    return numpy.stack([vectors[:, 0], -vectors[:, 2], vectors[:, 1]], 1)


class Surface:
    """A mesh: `positions`, `normals` or None, `triangles` and `attributes` by name. `materials` are the numbers of
    its materials and `slots` the index in this list for each triangle. Primitives share their vertices."""

    def __init__(self, glb, about):
        primitives = about["primitives"]
        arrays = {name: glb.array(index) for name, index in primitives[0]["attributes"].items()}
        self.name = about["name"]
        self.materials = [each["material"] for each in primitives if "material" in each]
        self.positions = turned(arrays.pop("POSITION")) * numpy.float32(glb.scale)
        normals = arrays.pop("NORMAL", None)
        self.normals = None if normals is None else turned(normals)
        parts = [glb.array(each["indices"]).reshape(-1, 3).astype(numpy.int32) for each in primitives]
        self.triangles = numpy.concatenate(parts)
        self.slots = numpy.repeat(numpy.arange(len(parts), dtype=numpy.int32), [len(each) for each in parts])
        if len(self.triangles) and self.triangles.max() >= len(self.positions):
            raise ValueError(f"'{self.name}' has vertex indices out of range")
        self.attributes = {}
        for name, values in arrays.items():
            own = "Cd" if name == "COLOR_0" else name.lstrip("_").lower()
            color = name == "COLOR_0" or own.endswith("color") or own.endswith("cd") or own in ("emission", "through")
            if values.ndim == 2 and values.shape[1] == 3 and not color:
                values = turned(values)
            self.attributes[own] = values


class Glb:
    def __init__(self, path, scale=1.0):
        """`scale`: Blender units per metre."""
        self.scale = scale
        with open(path, "rb") as file:
            data = file.read()
        magic, _, length, words, _ = struct.unpack_from("<4sIIII", data)
        if magic != b"glTF" or length != len(data):
            raise ValueError(f"'{path}' is not a complete binary glTF file")
        self.about = json.loads(data[20:20 + words])
        self._bytes = memoryview(data)[20 + words + 8:]

    def array(self, index):
        accessor = self.about["accessors"][index]
        view = self.about["bufferViews"][accessor["bufferView"]]
        width = WIDTHS[accessor["type"]]
        kind = TYPES[accessor["componentType"]]
        values = numpy.frombuffer(self._bytes, kind, accessor["count"] * width, view.get("byteOffset", 0))
        if accessor.get("normalized"):
            values = values.astype(numpy.float32) / numpy.float32(numpy.iinfo(kind).max)
        return values if width == 1 else values.reshape(-1, width)

    def surface(self, index):
        return Surface(self, self.about["meshes"][index])

    def list(self, name):
        return self.about.get(name, [])

    def extras(self, name):
        """Data outside the glTF standard: a list in the scene's extras."""
        return self.list("scenes")[0].get("extras", {}).get(name, [])

    @property
    def lights(self):
        return self.about.get("extensions", {}).get("KHR_lights_punctual", {}).get("lights", [])

    @property
    def nodes(self):
        """(name, kind, index, matrix in Blender's space); kind is "mesh", "camera" or "light"."""
        for node in self.list("nodes"):
            x, y, z, w = node.get("rotation", (0, 0, 0, 1))
            place = TURN @ Matrix.LocRotScale(Vector(node.get("translation", (0, 0, 0))) * self.scale,
                                              Quaternion((w, x, y, z)),
                                              Vector(node.get("scale", (1, 1, 1))))
            light = node.get("extensions", {}).get("KHR_lights_punctual", {}).get("light")
            if "mesh" in node:  # its vertices have z up already
                yield node["name"], "mesh", node["mesh"], place @ TURN.inverted()
            elif "camera" in node:
                yield node["name"], "camera", node["camera"], place
            elif light is not None:
                yield node["name"], "light", light, place
