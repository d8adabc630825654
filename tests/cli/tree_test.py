# SPDX-License-Identifier: Apache-2.0
"""`vug tree` on facades: text, JSON, the notation of the paper, the table of elements, drawings."""
import json
import unittest

from vug import SOURCE, VugTest

FRONT = """
grammar front: facade {
  width 6m
  height 4m
  axiom Front
  Front -> rows(1, repeat(x, 2m, Bay), 1m, wall)
  Bay   -> inset(50cm, window, frame: wall)
}
"""


class Trees(VugTest):
    def test_forms(self):
        self.write("front.vug", FRONT)
        text = self.expect(0, "tree", "front.vug").out
        self.assertIn("Bay 2 x 3 m at (0, 0), 3 times  ⟵ Bay -> inset(window, wall) (front.vug:7:3)", text)
        data = json.loads(self.expect(0, "tree", "front.vug", "--json").out)
        self.assertEqual((data["width"], data["height"]), (6, 4))
        kinds = [one["kind"] for one in data["elements"]]
        self.assertEqual((kinds.count("window"), kinds.count("wall")), (3, 13))
        self.assertEqual(data["nodes"][0]["symbol"], "Front")
        table = self.expect(0, "tree", "front.vug", "--elements").out.splitlines()
        self.assertIn("window,2.5,0.5,1,2,0", table)
        theta = self.expect(0, "tree", "front.vug", "--theta").out
        self.assertTrue(theta.startswith("Front(0, 0, 6, 4, (repeat(3, Bay("), theta)
        self.assertEqual(data["theta"] + "\n", theta)
        self.assertIn("<svg", self.expect(0, "tree", "front.vug", "--elevation").out)
        self.assertIn('href="photo.png"',
                      self.expect(0, "tree", "front.vug", "--overlay", "photo.png").out)
        self.assertIn("<svg", self.expect(0, "tree", "front.vug", "--svg").out)

    def test_the_grammar_of_the_paper(self):
        said = self.expect(0, "tree", SOURCE / "data/facades/ripperda.vug", "--seed", 3, "--theta").out
        self.assertTrue(said.startswith("Facade(0, 0, 12, 9, "), said)
        for seed in range(5):
            self.expect(0, "check", SOURCE / "data/facades/ripperda.vug", "--seed", seed)

    def test_faults(self):
        self.write("bad.vug", FRONT.replace("1m, wall", "5m, wall"))
        said = self.expect(2, "tree", "bad.vug").err
        self.assertIn("bad.vug:6:12: error: the parts do not fit: they need 5m of 4m ('wall' 5m)", said)

    def test_lsystems_have_words(self):
        self.write("plant.vug", "grammar plant: lsystem {\n axiom F\n}\n")
        for args in ((), ("--grammar", "plant")):
            self.assertIn("'plant' is an L-system: 'vug derive' prints its word",
                          self.expect(2, "tree", "plant.vug", *args).err)

    def test_forms_that_other_grammars_do_not_have(self):
        self.write("cave.vug", "grammar cave {\n axiom + box()\n}\nvolume v = level_set(cave, voxel: 20cm)\n")
        self.assertIn("no grammar of kind facade", self.expect(2, "tree", "cave.vug", "--theta").err)
        self.expect(2, "tree", "cave.vug", "--json", "--svg")


if __name__ == "__main__":
    unittest.main()
