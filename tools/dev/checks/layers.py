# SPDX-License-Identifier: Apache-2.0
"""Includes point downwards only: layers, wrappers of large libraries, no cycles, no heavy public headers.

The layers are the lines of the module list in lib/CMakeLists.txt, lowest first: a file may include
its own module and the modules of earlier lines, and only those its module's DEPENDS reaches.
"""
import re

from .tree import Finding, module_of

# The modules that may include each of these.
DOORS = {"openvdb/": ("volume",), "embree3/": ("raytree", "render"), "OpenImageIO/": ("image",),
         "OpenEXR/": ("image",), "OpenColorIO/": ("image",), "tiny_gltf.h": ("exchange",),
         "meshoptimizer.h": ("exchange",)}
# Expensive to parse: must not be reachable through a header that another module includes.
HEAVY = (*DOORS, "nlohmann/json.hpp", "CLI/", "Eigen/")


def read_layers(tree):
    match = re.search(r"foreach\(module\n(.*?)\)", tree.text("lib/CMakeLists.txt"), re.S)
    return {module: height for height, line in enumerate(match.group(1).splitlines())
            for module in line.split()}


def read_depends(tree):
    """Module -> the modules its CMake target links, and theirs."""
    direct = {}
    for name in tree.select("CMakeLists.txt", under="lib/vug/"):
        call = re.search(r"vug_module\((\w+)([^)]*)\)", tree.text(name))
        if call:
            match = re.search(r"DEPENDS\s+([^)]*?)(?=\s+(?:PUBLIC|PRIVATE|FOLDERS)\b|$)",
                              call.group(2).strip(), re.S)
            direct[call.group(1)] = set(match.group(1).split()) if match else set()

    def reach(module, seen):
        for other in direct.get(module, ()):
            if other not in seen:
                seen.add(other)
                reach(other, seen)
        return seen

    return {module: reach(module, set()) for module in direct}


def check_direction(tree, layers, depends):
    for name in tree.sources(under="lib/"):
        module = module_of(name)
        if module not in layers:
            yield Finding(name, 0, f"module '{module}' is not in the list of lib/CMakeLists.txt")
            continue
        for line, path, angle in tree.includes(name):
            other = module_of(path)
            if not angle:
                yield Finding(name, line, f'write #include <vug/module/...>, not "{path}"')
            elif other and other not in layers:
                yield Finding(name, line, f"unknown module: {other}")
            elif other and other != module and layers[other] >= layers[module]:
                way = "up" if layers[other] > layers[module] else "sideways"
                yield Finding(name, line, f"{module} includes {way}: {path}")
            elif other and other != module and other not in depends.get(module, {other}):
                yield Finding(name, line, f"add {other} to the DEPENDS of {module}: {path}")
            for prefix, owners in DOORS.items():
                if path.startswith(prefix) and module not in owners:
                    yield Finding(name, line, f"only {' and '.join(owners)} may include {path}")


def header_graph(tree):
    """Header or source -> [(line, included header of this project)]."""
    known = set(tree.files)
    return {name: [(line, "lib/" + path) for line, path, _ in tree.includes(name)
                   if "lib/" + path in known] for name in tree.sources()}


def check_cycles(graph):
    done, path = set(), []

    def visit(name):
        if name in path:
            cycle = [*path[path.index(name):], name]
            yield Finding(name, 0, "include cycle: " + " -> ".join(cycle))
        elif name not in done:
            path.append(name)
            for _, other in graph.get(name, ()):
                yield from visit(other)
            path.pop()
            done.add(name)

    for name in graph:
        yield from visit(name)


def may_include(module, path):
    return any(path.startswith(prefix) and module in owners for prefix, owners in DOORS.items())


def check_heavy(tree, graph):
    heavy = {}
    for name in tree.select(".h"):
        for _, path, _ in tree.includes(name):
            if path.startswith(HEAVY):
                heavy[name] = path
    grew = True
    while grew:
        grew = False
        for name in tree.select(".h"):
            for _, other in graph[name]:
                if other in heavy and name not in heavy:
                    heavy[name] = heavy[other]
                    grew = True
    for name in tree.sources(under="lib/"):
        for line, other in graph[name]:
            if (other in heavy and module_of(name) != module_of(other)
                    and not may_include(module_of(name), heavy[other])):
                yield Finding(name, line, f"{other} brings {heavy[other]} into another module: "
                              "keep heavy headers in .cpp files or in headers private to a module")


def check_internal(tree):
    internal = {name for name in tree.select(".h", under="lib/vug/")
                if re.match(r"// SPDX.*\n// (Internal|Inside) ", tree.text(name))}
    for name in tree.sources():
        for line, path, _ in tree.includes(name):
            header = "lib/" + path
            if header not in internal or name in internal:
                continue
            if module_of(name) != module_of(header):
                yield Finding(name, line, f"{path} is internal to its module")
            elif name.endswith(".h"):
                yield Finding(name, line, f"{path} is internal and not installed: include it in .cpp files or "
                              "internal headers only")


def check(tree):
    layers, depends = read_layers(tree), read_depends(tree)
    graph = header_graph(tree)
    yield from check_direction(tree, layers, depends)
    yield from check_cycles(graph)
    yield from check_heavy(tree, graph)
    yield from check_internal(tree)
