# SPDX-License-Identifier: Apache-2.0
"""Parameters of a scene as custom properties of a cave's collection: sliders that Blender saves, animates and
displays, with the scene's ranges and docs. Lengths are in metres, regardless of Blender's unit scale."""
import json

RESERVED = ("vug", "cycles")  # names that are in use on collections
SUBTYPES = {"length": "DISTANCE", "angle": "ANGLE", "time": "TIME_ABSOLUTE"}
UNITS = {
    "ratio": "ratio", "number per metre": "per metre", "area": "square metres", "volume": "cubic metres",
    "number per square metre": "per square metre", "frequency": "hertz", "mass": "kilograms",
    "temperature": "kelvin", "power": "watts", "irradiance": "watts per square metre", "luminous flux": "lumen",
    "luminous intensity": "candela", "illuminance": "lux"}


def key_of(name):
    return name + "_" if name in RESERVED else name


def about(collection):
    """The declared parameters of the scene: dicts with the members of vug.Param."""
    return json.loads(collection.vug.parameters or "[]")


def stored(value, kind):
    """The value as stored in a custom property, or None if it cannot be stored."""
    if kind == "true or false":
        return int(value)
    if isinstance(value, (float, int, str)):
        return float(value) if kind == "number" else value
    if isinstance(value, (list, tuple)) and len(value) == 3:
        return [float(each) for each in value]
    return None


def same(a, b):
    return list(a) == list(b) if hasattr(a, "__len__") and not isinstance(a, str) else a == b


def set_ui(collection, key, param, metres_per_unit):
    ui = collection.id_properties_ui(key)
    # Blender displays lengths in the scene's unit, which equals ours only if it is a metre.
    foreign = param["dimension"] == "length" and metres_per_unit != 1
    unit = "metres" if foreign else UNITS.get(param["dimension"])
    doc = param["doc"] + (f" ({unit})" if unit else "")
    default = stored(param["default"], param["type"])
    wanted = {"description": doc, "default": default}
    if param["type"] == "true or false":
        wanted.update(min=0, max=1)
    elif param["type"] == "number":
        for side in ("min", "max"):
            limit = param["low" if side == "min" else "high"]
            if isinstance(limit, float):
                wanted.update({side: limit, "soft_" + side: limit})
        if param["dimension"] in SUBTYPES and not foreign:
            wanted["subtype"] = SUBTYPES[param["dimension"]]
        wanted["precision"] = 3
    ui.clear()
    ui.update(**wanted)


def update(collection, params, metres_per_unit):
    """Creates or updates the properties of these parameters. Values set by an artist are kept, values equal to
    the old default get the new default, and obsolete parameters are removed."""
    before = {param["name"]: param for param in about(collection)}
    for param in params:
        key, kind = key_of(param["name"]), param["type"]
        default = stored(param["default"], kind)
        if default is None:
            continue
        old = before.get(param["name"])
        untouched = old is None or old["type"] != kind or key not in collection or same(
            collection[key], stored(old["default"], kind))
        if untouched:
            collection[key] = default
        set_ui(collection, key, param, metres_per_unit)
    names = {param["name"] for param in params}
    for name in before:
        if name not in names and key_of(name) in collection:
            del collection[key_of(name)]
    collection.vug.parameters = json.dumps(params)


def shown(collection):
    """(param, key) of all parameters that can be set."""
    return [(param, key_of(param["name"])) for param in about(collection)
            if key_of(param["name"]) in collection]


def groups(collection):
    """Lists of (label, key) of the parameters that can be set, by the module that declares them: '' is the scene,
    which comes first. The label of `rocks.edge` is `edge`."""
    out = {"": []}
    for param, key in shown(collection):
        module, _, label = param["name"].rpartition(".")
        out.setdefault(module, []).append((label, key))
    return out


def missing(collection):
    """Names of parameters whose properties were deleted."""
    return [param["name"] for param in about(collection) if key_of(param["name"]) not in collection
            and stored(param["default"], param["type"]) is not None]


def values(collection):
    """All values by name, as JSON data."""
    return {param["name"]: plain(collection[key]) for param, key in shown(collection)}


def restore(collection, values):
    for param, key in shown(collection):
        if param["name"] in values:
            collection[key] = values[param["name"]]


def plain(value):
    return list(value) if hasattr(value, "to_list") else value


def changed(collection):
    """Values by name that differ from the default, in the form of the worker's order."""
    out = {}
    for param, key in shown(collection):
        value = collection[key]
        if same(value, stored(param["default"], param["type"])):
            continue
        out[param["name"]] = plain(value)
    return out


def variants(collection):
    """The variants of the scene: dicts of values by name."""
    return json.loads(collection.vug.variants or "{}")


def apply_variant(collection, name):
    """Sets the parameters of a variant to its values, and all others to their defaults."""
    reset(collection)
    chosen = variants(collection)[name]
    for param, key in shown(collection):
        value = stored(chosen.get(param["name"]), param["type"]) if param["name"] in chosen else None
        if value is not None:
            collection[key] = value


def reset(collection):
    for param, key in shown(collection):
        collection[key] = stored(param["default"], param["type"])
