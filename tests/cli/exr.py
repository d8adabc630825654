# SPDX-License-Identifier: Apache-2.0
"""A reader of OpenEXR files for tests, written from the file layout document without any library: parts,
lines, deep lines or tiles, channels of half and float, no compression or ZIP."""
import struct
import zlib


# The number of lines that are compressed together: none, ZIPS, ZIP.
LINES = {0: 1, 2: 1, 3: 16}


def _text(data, at):
    end = data.index(0, at)
    return data[at:end].decode("latin-1"), end + 1


def _header(data, at):
    """Attributes of one part by name, as (type, bytes)."""
    attributes = {}
    while data[at]:
        name, at = _text(data, at)
        kind, at = _text(data, at)
        size, = struct.unpack_from("<i", data, at)
        attributes[name] = (kind, data[at + 4:at + 4 + size])
        at += 4 + size
    return attributes, at + 1


def _channels(attribute):
    found, at = [], 0
    while attribute[at]:
        name, at = _text(attribute, at)
        found.append((name, struct.unpack_from("<i", attribute, at)[0]))
        at += 16
    return found


def _unzip(data, size):
    """The decompressed bytes of a ZIP block, with the predictor undone and the two halves interleaved."""
    if len(data) == size:  # stored uncompressed if ZIP does not help
        return data
    raw = bytearray(zlib.decompress(data))
    for i in range(1, len(raw)):
        raw[i] = (raw[i - 1] + raw[i] - 128) & 255
    half = (len(raw) + 1) // 2
    out = bytearray(len(raw))
    out[0::2] = raw[:half]
    out[1::2] = raw[half:]
    return bytes(out)


class Part:
    def __init__(self, attributes):
        self.attributes = attributes
        self.channels = _channels(attributes["channels"][1])
        self.window = struct.unpack("<4i", attributes["dataWindow"][1])
        self.display = struct.unpack("<4i", attributes["displayWindow"][1])
        self.width = self.window[2] - self.window[0] + 1
        self.height = self.window[3] - self.window[1] + 1
        self.compression = attributes["compression"][1][0]
        self.tiles = attributes.get("tiles")
        self.deep = attributes.get("type", ("", b""))[1] == b"deepscanline"
        self.pixels = {name: [0.0] * (self.width * self.height) for name, _ in self.channels}

    def text(self, name):
        kind, value = self.attributes[name]
        assert kind == "string", (name, kind)
        return value.decode()

    def _take(self, data, x0, y0, width, height):
        size = width * height * sum(2 if kind == 1 else 4 for _, kind in self.channels)
        if self.compression in (2, 3):
            data = _unzip(data, size)
        assert len(data) == size, (len(data), size)
        at = 0
        for y in range(y0, y0 + height):
            for name, kind in self.channels:
                count = 2 * width if kind == 1 else 4 * width
                values = struct.unpack_from(f"<{width}{'e' if kind == 1 else 'f'}", data, at)
                self.pixels[name][y * self.width + x0:y * self.width + x0 + width] = values
                at += count

    def _take_deep(self, data, y, counts_size, samples_size, whole_size):
        """One line: the cumulative number of samples of each pixel, then the channels."""
        counts = struct.unpack(f"<{self.width}i", _unzip(data[:counts_size], 4 * self.width))
        assert all(a <= b for a, b in zip(counts, counts[1:])), counts
        samples = _unzip(data[counts_size:counts_size + samples_size], whole_size)
        at, total = 0, counts[-1]
        for name, kind in self.channels:
            values = struct.unpack_from(f"<{total}{'e' if kind == 1 else 'f'}", samples, at)
            at += total * (2 if kind == 1 else 4)
            line = [values[a:b] for a, b in zip((0, *counts), counts)]
            self.pixels[name][y * self.width:(y + 1) * self.width] = line
        assert at == whole_size, (at, whole_size)


def read(path):
    """All parts of a file."""
    data = path.read_bytes()
    magic, version = struct.unpack_from("<II", data)
    assert magic == 20000630 and version & 255 == 2, "no EXR"
    multi, single_tiled, at = bool(version & 0x1000), bool(version & 0x200), 8
    parts = []
    while True:
        attributes, at = _header(data, at)
        if not attributes:
            break
        parts.append(Part(attributes))
        if not multi:
            break
    tables = []
    for part in parts:
        if part.tiles:
            wide, high = struct.unpack_from("<II", part.tiles[1])
            count = -(-part.width // wide) * -(-part.height // high)
        else:
            count = -(-part.height // LINES[part.compression])
        tables.append(struct.unpack_from(f"<{count}Q", data, at))
        at += 8 * count
    for number, (part, table) in enumerate(zip(parts, tables)):
        assert bool(part.tiles) == (single_tiled or part.attributes.get("type", ("", b""))[1] == b"tiledimage")
        for place in table:
            if multi:
                assert struct.unpack_from("<i", data, place)[0] == number
                place += 4
            if part.deep:
                line, *sizes = struct.unpack_from("<i3Q", data, place)
                part._take_deep(data[place + 28:place + 28 + sizes[0] + sizes[1]],
                                line - part.window[1], *sizes)
            elif part.tiles:
                wide, high = struct.unpack_from("<II", part.tiles[1])
                tx, ty, _, _, size = struct.unpack_from("<5i", data, place)
                x0, y0 = tx * wide, ty * high
                part._take(data[place + 20:place + 20 + size], x0, y0,
                           min(wide, part.width - x0), min(high, part.height - y0))
            else:
                line, size = struct.unpack_from("<2i", data, place)
                y0 = line - part.window[1]
                lines = LINES[part.compression]
                part._take(data[place + 8:place + 8 + size], 0, y0, part.width,
                           min(lines, part.height - y0))
    return parts
