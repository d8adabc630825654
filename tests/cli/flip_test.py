# SPDX-License-Identifier: Apache-2.0
"""FLIP of the command against an independent implementation in numpy, within 1e-3."""
import json
import unittest

import numpy as np

import flip_oracle
from pictures import rgbe, scene, shown, unpack, write_hdr, write_png
from vug import VugTest

PAIRS = [dict(shift=0.02), dict(noise=0.3), dict(dark=0.7), dict(shift=0.1, noise=0.1, dark=1.4)]


class Flip(VugTest):
    def measured(self, reference, test, measure):
        self.vug("diff", reference, test, "--metric", measure, "--reference-exposures", "--json", "d.json", "-q")
        return json.loads((self.folder / "d.json").read_text())["layers"]["beauty"][measure]["value"]

    def test_of_screens(self):
        reference = shown(scene(96, 60, 1))
        write_png(self.folder / "a.png", reference)
        for change in PAIRS:
            with self.subTest(**change):
                test = shown(scene(96, 60, 2, **change))
                write_png(self.folder / "b.png", test)
                expected = flip_oracle.ldr(flip_oracle.decoded(reference), flip_oracle.decoded(test)).mean()
                self.assertGreater(expected, 0.01)
                self.assertAlmostEqual(self.measured("a.png", "b.png", "flip"), expected, delta=1e-3)

    def test_of_high_dynamic_range(self):
        def stored(rows):
            return np.array([[unpack(rgbe(pixel)) for pixel in row] for row in rows])
        reference = scene(96, 60, 1)
        write_hdr(self.folder / "a.hdr", reference)
        for change in PAIRS:
            with self.subTest(**change):
                test = scene(96, 60, 2, **change)
                write_hdr(self.folder / "b.hdr", test)
                expected = flip_oracle.hdr(stored(reference), stored(test)).mean()
                self.assertGreater(expected, 0.01)
                self.assertAlmostEqual(self.measured("a.hdr", "b.hdr", "flip_hdr"), expected, delta=1e-3)


if __name__ == "__main__":
    unittest.main()
