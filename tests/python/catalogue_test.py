# SPDX-License-Identifier: Apache-2.0
"""The catalogue agrees with `vug list`."""
import json
import unittest

import vug
from case import Case


class Catalogue(Case):
    def test_every_kind(self):
        listed = json.loads(self.vug("list", "--json"))
        self.assertEqual(len(vug.catalogue), len(listed))
        for kind, data in zip(vug.catalogue, listed):
            self.assertEqual((kind.name, kind.category, kind.doc, kind.cite),
                             (data["name"], data["category"], data["doc"], data.get("cite")))
            self.assertEqual(list(kind.params), [p["name"] for p in data["params"]])
            for param, p in zip(kind.params.values(), data["params"]):
                self.assertEqual((param.type, param.doc, param.default, param.high),
                                 (p["type"], p["doc"], p.get("default"), p.get("max")))
                self.assertEqual(param.low, p.get("min", p.get("above")))

    def test_manuals(self):
        self.assertEqual(str(vug.catalogue["torus"]) + "\n", self.vug("list", "torus"))
        self.assertEqual(vug.catalogue["torus"].__doc__, str(vug.catalogue["torus"]))
        tube = vug.catalogue["torus"].params["tube"]
        self.assertEqual((tube.default, tube.unit, tube.above, tube.low), ("0.25m", "m", True, 0))

    def test_finding(self):
        self.assertEqual([k.category for k in vug.catalogue.find("sphere")], ["primitive", "light"])
        self.assertIn("rect", [k.name for k in vug.catalogue.find("light")])
        self.assertIn("torus", vug.catalogue)
        self.assertNotIn("tors", vug.catalogue)
        self.assertEqual(vug.catalogue.find("tors"), [])
        with self.assertRaisesRegex(KeyError, "did you mean 'torus'"):
            vug.catalogue["tors"]


if __name__ == "__main__":
    unittest.main()
