# SPDX-License-Identifier: Apache-2.0
"""`vug measure --clearance` reports whether a person passes through a cave."""
import json
import unittest

from vug import VugTest

SCENE = """param neck = 1.2m in 5cm..10m "width of the way between both rooms"
network plan = graph(names: ["mouth", "room", "neck", "hall"], paths: ["mouth room neck hall"],
  at: [(0, 1.2, 0), (6, 1.2, 0), (11, 1.2, 0), (18, 1.2, 0)], widths: [2, 4, neck, 4], heights: [2.4, 2.6, 2.2, 2.6])
volume rock = level_set(complement(passages(of: plan, section: mined(arch: 0))), voxel: 12cm, from: (-2, -1, -4), to: (22, 4, 4))
mesh cave on rock {}
"""


class Clearance(VugTest):
    def setUp(self):
        super().setUp()
        (self.folder / "cave.vug").write_text(SCENE)

    def measure(self, status, *args):
        return json.loads(self.expect(status, "measure", "cave.vug", "--clearance", "--json", *args).out)

    def test_a_person_passes_a_wide_neck_only(self):
        report = self.measure(0)
        self.assertEqual((report["from"], report["to"], report["passes"]), ("mouth", "hall", True))
        self.assertEqual((report["stations"], report["not_reached"]), (4, []))
        self.assertGreater(report["widest"], 0.8)
        self.assertLess(report["widest"], 1.3)
        narrow = self.measure(1, "-D", "neck=30cm")
        self.assertFalse(narrow["passes"])
        self.assertIn("hall", narrow["not_reached"])
        self.assertTrue(self.measure(0, "-D", "neck=30cm", "--to", "room")["passes"])
        self.assertTrue(self.measure(0, "-D", "neck=30cm", "--body-width", "15cm")["passes"])

    def test_table(self):
        table = self.expect(0, "measure", "cave.vug", "--clearance").out
        self.assertRegex(table, r"passes +yes\nwidest +\d\.\d\d m\nstations reached +4 of 4\n")

    def test_bad_requests(self):
        self.assertIn("nowhere", self.expect(2, "measure", "cave.vug", "--clearance", "--from", "nowhere").err)
        self.assertIn("capsule", self.expect(2, "measure", "cave.vug", "--clearance", "--body-height", "30cm").err)
        (self.folder / "bare.vug").write_text("volume a = level_set(sphere(1m), voxel: 20cm)\nmesh m on a {}\n")
        self.assertIn("network", self.expect(2, "measure", "bare.vug", "--clearance").err)


if __name__ == "__main__":
    unittest.main()
