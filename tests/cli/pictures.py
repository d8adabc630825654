# SPDX-License-Identifier: Apache-2.0
"""Writes small pictures for tests without any library: Radiance HDR and EXR (linear), PNG (sRGB)."""
import math
import random
import struct
import zlib


def write_png(path, rows):
    """`rows` of (r, g, b) codes 0..255."""
    height, width = len(rows), len(rows[0])
    raw = b"".join(b"\0" + bytes(c for pixel in row for c in pixel) for row in rows)

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))


def write_exr(path, channels):
    """Writes uncompressed lines of floats by channel: {"R": rows, "Z": rows}."""
    names = sorted(channels)
    height, width = len(channels[names[0]]), len(channels[names[0]][0])

    def attribute(name, kind, data):
        return name + b"\0" + kind + b"\0" + struct.pack("<i", len(data)) + data
    box = struct.pack("<4i", 0, 0, width - 1, height - 1)
    listed = b"".join(name.encode() + b"\0" + struct.pack("<4i", 2, 0, 1, 1) for name in names) + b"\0"
    head = struct.pack("<2i", 20000630, 2) + b"".join(attribute(*each) for each in [
        (b"channels", b"chlist", listed), (b"compression", b"compression", b"\0"),
        (b"dataWindow", b"box2i", box), (b"displayWindow", b"box2i", box),
        (b"lineOrder", b"lineOrder", b"\0"), (b"pixelAspectRatio", b"float", struct.pack("<f", 1)),
        (b"screenWindowCenter", b"v2f", struct.pack("<2f", 0, 0)),
        (b"screenWindowWidth", b"float", struct.pack("<f", 1))]) + b"\0"
    size = 4 * width * len(names)
    first = len(head) + 8 * height
    lines = b"".join(struct.pack("<2i", y, size) + b"".join(struct.pack(f"<{width}f", *channels[name][y]) for name in names)
                     for y in range(height))
    path.write_bytes(head + b"".join(struct.pack("<Q", first + y * (size + 8)) for y in range(height)) + lines)


def rgbe(pixel):
    most = max(pixel)
    if most < 1e-32:
        return b"\0\0\0\0"
    mantissa, exponent = math.frexp(most)
    scale = mantissa * 256 / most
    return bytes([*(int(v * scale) for v in pixel), exponent + 128])


def unpack(code):
    """The radiance of four RGBE bytes, by the usual decoding (m + 0.5) 2^e."""
    r, g, b, e = code
    return tuple(math.ldexp(v, e - 136) for v in (r, g, b)) if e else (0.0, 0.0, 0.0)


def write_hdr(path, rows):
    """`rows` of linear (r, g, b); flat scan lines."""
    head = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {len(rows)} +X {len(rows[0])}\n"
    path.write_bytes(head.encode() + b"".join(rgbe(pixel) for row in rows for pixel in row))


def scene(width, height, seed, shift=0.0, noise=0.0, dark=1.0):
    """Linear light with edges, gradients and a light; `shift` moves an edge, `noise` is relative."""
    draw = random.Random(seed)
    rows = []
    for y in range(height):
        row = []
        for x in range(width):
            u, v = x / width, y / height
            base = 0.05 + 0.5 * u * (1 - v)
            colour = [base, base * (0.6 + 0.4 * v), base * (0.3 + 0.5 * u)]
            if (u - 0.4 - shift) ** 2 + (v - 0.5) ** 2 < 0.05:
                colour = [0.7 * v, 0.2, 0.1 + 0.3 * u]
            if u > 0.85 and v < 0.2:
                colour = [6.0, 5.0, 3.5]
            gain = dark * (1 + noise * (draw.random() - 0.5))
            row.append(tuple(gain * c for c in colour))
        rows.append(row)
    return rows


def shown(rows):
    """Display codes: clipped, sRGB."""
    def code(v):
        v = min(max(v, 0), 1)
        return round(255 * (12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055))
    return [[tuple(code(c) for c in pixel) for pixel in row] for row in rows]
