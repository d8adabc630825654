# SPDX-License-Identifier: Apache-2.0
"""Reads networks from Survex files. This module does not use bpy.

It knows the part of the language that this add-on and `vug survey -o FILE.svx` write; that command converts other
surveys.
"""
import math
import re

from .networks import Network, Station

# Commands that do not change places of stations.
IGNORED = {"title", "case", "infer", "export", "date", "team", "instrument", "ref", "copyright", "require", "cs", "sd"}
READINGS = {"cartesian": ["from", "to", "easting", "northing", "altitude"],
            "normal": ["from", "to", "tape", "compass", "clino"],
            "nosurvey": ["from", "to"],
            "passage": ["station", "left", "right", "up", "down"]}
ALIASES = {"dx": "easting", "dy": "northing", "dz": "altitude", "length": "tape", "bearing": "compass",
           "gradient": "clino", "ceiling": "up", "floor": "down"}
VERTICAL = {"up": 90.0, "u": 90.0, "+v": 90.0, "down": -90.0, "d": -90.0, "-v": -90.0}


def number(text):
    """A finite number. Raises ValueError."""
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(f"'{text}' is not a number")
    return value


def vector(style, reading):
    """The vector of a leg in metres."""
    if style == "cartesian":
        return tuple(number(reading[name]) for name in ("easting", "northing", "altitude"))
    length, clino = number(reading["tape"]), reading["clino"].lower()
    slope = math.radians(VERTICAL[clino] if clino in VERTICAL else number(clino))
    bearing = math.radians(0 if reading["compass"] == "-" else number(reading["compass"]))
    level = length * math.cos(slope)
    return level * math.sin(bearing), level * math.cos(bearing), length * math.sin(slope)


class Reader:
    def __init__(self):
        self.blocks = [("", {"style": "normal", "order": READINGS["normal"], "flags": set()})]
        self.index, self.same = {}, []
        self.vectors, self.legs, self.fixes = [], [], {}
        self.walls, self.entrances = {}, set()
        self.title = ""

    def station(self, name):
        if not re.fullmatch(r"[A-Za-z0-9_.-]+", name) or not name.strip("."):
            raise ValueError(f"'{name}' is not a name of a station")
        full = f"{self.blocks[-1][0]}{name}"
        return self.index.setdefault(full, len(self.index))

    def line(self, text):
        text = text.partition(";")[0].strip()
        if text.startswith("*"):
            words = text[1:].split()
            self.command(words[0].lower() if words else "", words[1:], text)
        elif text:
            self.data(text.split())

    def command(self, name, words, text):
        prefix, settings = self.blocks[-1]
        if name == "begin":
            inner = {**settings, "flags": set(settings["flags"])}
            self.blocks.append((prefix + (f"{words[0]}." if words else ""), inner))
        elif name == "end":
            if len(self.blocks) == 1:
                raise ValueError("*end without *begin")
            self.blocks.pop()
        elif name == "data":
            self.choose_data(words)
        elif name == "flags":
            self.change_flags(words)
        elif name == "fix":
            self.fixes[self.station(words[0])] = tuple(number(word) for word in words[-3:])
        elif name == "equate":
            stations = [self.station(word) for word in words]
            self.same += [(stations[0], each) for each in stations[1:]]
        elif name == "entrance":
            self.entrances.add(self.station(words[0]))
        elif name == "title":
            self.title = self.title or " ".join(text.split()[1:]).strip('"')
        elif name not in IGNORED:
            raise ValueError(f"*{name} is not supported; convert the survey with vug survey FILE -o NEW.svx")

    def choose_data(self, words):
        style = words[0].lower() if words else ""
        order = [ALIASES.get(word.lower(), word.lower()) for word in words[1:]]
        if style not in READINGS or sorted(order or READINGS[style]) != sorted(READINGS[style]):
            raise ValueError(f"*data {' '.join(words)} is not supported; convert the survey with vug survey FILE -o "
                             "NEW.svx")
        self.blocks[-1][1].update(style=style, order=order or READINGS[style])

    def change_flags(self, words):
        remove, flags = False, self.blocks[-1][1]["flags"]
        for word in (word.lower() for word in words):
            if word == "not":
                remove = True
                continue
            (flags.discard if remove else flags.add)(word)
            remove = False

    def data(self, words):
        settings = self.blocks[-1][1]
        style, order = settings["style"], settings["order"]
        if len(words) < len(order):
            raise ValueError(f"{len(order)} values are expected: {' '.join(order)}")
        reading = dict(zip(order, words))
        if style == "passage":
            sides = [reading[side] for side in ("left", "right", "up", "down")]
            if "-" not in sides:
                self.walls[self.station(reading["station"])] = tuple(number(side) for side in sides)
            return
        if settings["flags"] & {"splay"} or not (reading["from"].strip(".") and reading["to"].strip(".")):
            return
        ends = self.station(reading["from"]), self.station(reading["to"])
        if style != "nosurvey":
            self.vectors.append((*ends, vector(style, reading)))
        if not settings["flags"] & {"surface", "duplicate"}:
            self.legs.append(ends)

    def places(self):
        """The place of each station: legs lead away from the fixed ones; a part without them starts at 0."""
        ways = [[] for _ in self.index]
        for a, b, step in [*self.vectors, *((a, b, (0, 0, 0)) for a, b in self.same)]:
            ways[a].append((b, step))
            ways[b].append((a, tuple(-x for x in step)))
        places = [None] * len(ways)

        def lead(open_stations):
            while open_stations:
                a = open_stations.pop()
                for b, step in ways[a]:
                    if places[b] is None:
                        places[b] = tuple(x + dx for x, dx in zip(places[a], step))
                        open_stations.append(b)

        for station, place in self.fixes.items():
            places[station] = place
        lead(list(self.fixes))
        for station in range(len(ways)):
            if places[station] is None:
                places[station] = (0.0, 0.0, 0.0)
                lead([station])
        return places

    def network(self):
        places = self.places()
        first = list(range(len(places)))  # the station that represents those that are equated
        for a, b in self.same:
            low, high = sorted((first[a], first[b]))
            first = [low if each == high else each for each in first]
        used = sorted({first[end] for leg in self.legs for end in leg})
        number_of = {station: i for i, station in enumerate(used)}
        names = list(self.index)
        out = Network(title=self.title)
        for station in used:
            group = [i for i, each in enumerate(first) if each == station]
            walls = next((self.walls[i] for i in group if i in self.walls), None)
            out.stations.append(Station(names[station], places[station], walls,
                                        any(i in self.entrances for i in group)))
        for a, b in self.legs:
            ends = number_of[first[a]], number_of[first[b]]
            if ends[0] != ends[1]:
                out.legs.append(ends)
        return out


def parse(text, file="survey.svx"):
    """The network of a text. Raises ValueError with the file and the line."""
    reader = Reader()
    for count, line in enumerate(text.splitlines(), 1):
        try:
            reader.line(line)
        except (ValueError, IndexError) as error:
            what = str(error) if isinstance(error, ValueError) else "values are missing"
            raise ValueError(f"{file}:{count}: {what}") from None
    network = reader.network()
    if not network.legs:
        raise ValueError(f"{file}: the survey has no legs underground")
    return network
