# SPDX-License-Identifier: Apache-2.0
"""Writes networks as Survex files, which scenes of Vug read. This module does not use bpy."""
import math
import re

from .networks import chains, components


def require_usable(network):
    """Raises ValueError for a network that a survey cannot contain."""
    if not network.legs:
        raise ValueError("the network has no legs: connect at least two points with an edge")
    names = [station.name for station in network.stations]
    if len(set(names)) != len(names):
        raise ValueError("two stations have the same name")
    for station in network.stations:
        if not all(math.isfinite(x) and abs(x) < 1e8 for x in station.position):
            raise ValueError(f"the station '{station.name}' is not within 100 000 km of the origin")


def decimal(value):
    """A number in micrometres as text in metres."""
    text = f"{value / 1e6:.6f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def svx_text(network):
    """The survey file. Positions are rounded to micrometres; the legs are cartesian, so that they close."""
    require_usable(network)
    places = [[round(x * 1e6) for x in station.position] for station in network.stations]
    title = " ".join(network.title.replace('"', ' ').split())
    lines = [f'*title "{title}"'] if title else []
    lines += ["*case preserve", "*infer exports on"]
    part = components(network)
    used = {end for leg in network.legs for end in leg}
    for i, station in enumerate(network.stations):
        if part[i] == i and i in used:
            lines.append(f"*fix {station.name} " + " ".join(map(decimal, places[i])))
    lines += [f"*entrance {network.stations[i].name}" for i in sorted(used) if network.stations[i].entrance]
    lines.append("*data cartesian from to easting northing altitude")
    for a, b in network.legs:
        step = " ".join(decimal(end - start) for start, end in zip(places[a], places[b]))
        lines.append(f"{network.stations[a].name} {network.stations[b].name} {step}")
    for chain in chains(network):
        measured = [network.stations[i] for i in chain if network.stations[i].walls]
        if measured:
            lines.append("*data passage station left right up down")
            for station in measured:
                lines.append(" ".join([station.name, *(f"{distance:.6g}" for distance in station.walls)]))
    return "\n".join(lines) + "\n"
