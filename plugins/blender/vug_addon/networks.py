# SPDX-License-Identifier: Apache-2.0
"""Plans of caves: stations with the distances to the walls, joined by legs. Positions are in metres: x east, y north,
z up, as in Blender. This module does not use bpy."""
import dataclasses
import re


@dataclasses.dataclass
class Station:
    name: str
    position: tuple  # (x, y, z)
    walls: tuple = None  # distances to the left, right, up and down; None: not measured
    entrance: bool = False


@dataclasses.dataclass
class Network:
    stations: list = dataclasses.field(default_factory=list)
    legs: list = dataclasses.field(default_factory=list)  # pairs of indices of stations
    title: str = ""


def usable_name(text, fallback="s"):
    """A name of a station that Survex accepts: levels of letters, digits, '_' and '-', separated by '.'."""
    levels = [re.sub(r"[^A-Za-z0-9_-]", "_", level) for level in text.split(".") if level]
    return ".".join(levels) or fallback


def unique_name(text, used):
    """The usable name, or one with a number that is not in the set `used`, to which it is added."""
    name = first = usable_name(text)
    number = 1
    while name in used:
        number += 1
        name = f"{first}_{number}"
    used.add(name)
    return name


def chains(network):
    """The legs as lists of stations from one junction or end to the next. A ring without junctions starts and ends
    at its first station."""
    ways = [[] for _ in network.stations]
    for leg, (a, b) in enumerate(network.legs):
        ways[a].append((leg, b))
        ways[b].append((leg, a))
    done, out = set(), []

    def follow(start, leg, station):
        chain = [start, station]
        done.add(leg)
        while len(ways[station]) == 2:
            open_ways = [way for way in ways[station] if way[0] not in done]
            if not open_ways:
                break
            leg, station = open_ways[0]
            done.add(leg)
            chain.append(station)
        out.append(chain)

    ends = [i for i, way in enumerate(ways) if len(way) not in (0, 2)]
    for start in [*ends, *range(len(ways))]:
        for leg, station in ways[start]:
            if leg not in done:
                follow(start, leg, station)
    return out


def components(network):
    """The number of the connected part of each station; parts are numbered by their first stations."""
    part = list(range(len(network.stations)))

    def root(i):
        while part[i] != i:
            part[i] = part[part[i]]
            i = part[i]
        return i

    for a, b in network.legs:
        low, high = sorted((root(a), root(b)))
        part[high] = low
    return [root(i) for i in range(len(part))]


def moved(network, offset):
    """The network with this vector added to its positions."""
    stations = [dataclasses.replace(each, position=tuple(x + dx for x, dx in zip(each.position, offset)))
                for each in network.stations]
    return dataclasses.replace(network, stations=stations)


def rounded_middle(network):
    """The middle of the bounding box in whole metres, as Vug's networks have it."""
    axes = zip(*(station.position for station in network.stations))
    return tuple(float(round((min(axis) + max(axis)) / 2)) for axis in axes)
