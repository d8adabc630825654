# SPDX-License-Identifier: Apache-2.0
"""JPEG pictures that Vug made carry no metadata: programs store commands in them, with paths of a machine."""
from .tree import Finding

# Application data (Exif, XMP, IPTC) and comments; APP0 (JFIF) and APP14 (Adobe) determine the colours, APP2 the profile.
METADATA = {0xE1, 0xED, 0xFE}
FOLDERS = ("docs/", "data/caves/")  # elsewhere are photographs, whose metadata belong to them


def markers(data):
    """The marker of each segment before the compressed pixels."""
    at = 2
    while at + 4 <= len(data) and data[at] == 0xFF and data[at + 1] != 0xDA:
        yield data[at + 1]
        at += 2 + int.from_bytes(data[at + 2:at + 4], "big")


def check(tree):
    for name in tree.select(".jpg", ".jpeg"):
        if name.startswith(FOLDERS) and METADATA.intersection(markers((tree.root / name).read_bytes())):
            yield Finding(name, 0, "it has metadata; remove them, e.g. with 'convert FILE -strip FILE'")
