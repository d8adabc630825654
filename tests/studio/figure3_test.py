# SPDX-License-Identifier: Apache-2.0
"""Rebuilds the situation of figure 3 of ripperda2009 by mouse and keyboard, and compares its files with the command."""
import json
import unittest

from studio import HERE, StudioTest, require_studio


class Figure3(StudioTest):
    def test_all_functions_of_the_program_of_the_paper(self):
        self.studio((HERE / "figure3.txt").read_text(), "--heartbeat")
        before, after = (self.folder / f"{name}.json" for name in ("before", "after"))
        self.assertEqual(before.read_bytes(), after.read_bytes(), "after 40 undos and redos")
        session = json.loads(before.read_text())
        self.assertGreater(len(session["edits"]), 15)
        self.assertEqual(session["photo"]["file"], "paris.jpg")

        # The command makes the same tree of the same session.
        listed = self.vug("facade", "model", "before.json", "--json")
        self.assertEqual((self.folder / "model.json").read_text(), listed.out)
        self.assertEqual((self.folder / "model.txt").read_text(),
                         self.vug("facade", "model", "before.json", "--theta").out)
        self.vug("facade", "model", "before.json", "--svg", "command.svg")
        self.assertEqual((self.folder / "model.svg").read_text(), (self.folder / "command.svg").read_text())
        for name in ("model.vug", "model_carved.vug"):
            checked = self.vug("check", name)
            self.assertEqual(checked.code, 0, checked.err)
        self.assertEqual((self.folder / "model.png").read_bytes()[:4], b"\x89PNG")

        # Both sides are mirror images: the windows are symmetric about the middle of the facade.
        tree = json.loads(listed.out)
        lefts = sorted(round(each["rect"][0], 3) for each in tree["elements"] if each["kind"] == "window")
        rights = sorted(round(tree["width"] - each["rect"][0] - each["rect"][2], 3) for each in tree["elements"]
                        if each["kind"] == "window")
        side = [x for x in lefts if x < 5]
        self.assertEqual(len(side), 10)
        self.assertTrue(all(min(abs(x - y) for y in rights) < 2e-3 for x in side))

    def test_a_drag_on_the_right_moves_the_left_by_the_same_distance(self):
        script = """open "{session}"
select 0.1.0.0
export json "{folder}/a.json"
drag line 1 copy 1 to 3.3m
export json "{folder}/b.json"
"""
        self.studio(script)
        trees = [json.loads((self.folder / f"{name}.json").read_text()) for name in "ab"]
        lefts = [sorted({round(each["rect"][0], 4) for each in tree["elements"] if each["kind"] == "window"})
                 for tree in trees]
        moved = sorted(round(b - a, 3) for a, b in zip(*lefts) if abs(a - b) > 1e-6)
        self.assertEqual(moved, [-0.2, 0.2])

    def test_every_unavailable_action_gives_the_reason(self):
        self.studio("\n".join(["photo \"{photo}\" 15m", "key 1", "select 0.0"] + [
            f'expect widget "action {index}" tooltip contains "Not available, another symbol"'
            for index in (1, 2, 3, 4, 5)]))


if __name__ == "__main__":
    require_studio()
    unittest.main()
