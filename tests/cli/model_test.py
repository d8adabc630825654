# SPDX-License-Identifier: Apache-2.0
"""`vug facade model`: interactive modelling sessions."""
import json
import re
import unittest

from pictures import write_png
from vug import SOURCE, VugTest

BEGIN = ("facade", "model", "--grammar", "ripperda.vug", "--width", "12m", "--height", "9m")
SESSIONS = SOURCE / "data/facades/sessions"


class Modelling(VugTest):
    def prepare(self):
        self.expect(0, *BEGIN, "--apply", "0 rows heights=3m", "--act", "0.1 Grid columns=4 rows=2",
                    "--edit", "toggle 0.1.0 column=1 row=0", "--checkpoint", "grid", "-o", "s.json")

    def model(self, *args, code=0):
        return self.expect(code, "facade", "model", *args)

    def session(self, name="s.json"):
        return json.loads((self.folder / name).read_text())

    def test_lists_rules_with_reasons_against_them(self):
        fresh = self.model(*BEGIN[2:], "--list").out
        self.assertEqual(fresh.count("\n  + "), 8, fresh)
        self.assertIn("+ rows(FacadeRow, PartFacade) heights=3.5,5.5", fresh)
        said = self.model("s.json", "--list").out
        self.assertIn("* grid(window) columns=4", said)
        self.assertIn("lines: 0 at y 3", said)
        one = self.model("s.json", "--list", "0.1").out
        self.assertIn("- Grid", one.replace("* Grid", "- Grid"))
        self.assertIn("[divided already: Grid divides the node]", one)
        self.assertEqual(one.split("actions:")[1].count("\n  - "), 8, one)
        self.assertIn("+ IdenticalGrid", self.model("s.json", "--list", "Facade.FacadeRow").out)

    def test_conditions_and_sizes_give_reasons(self):
        self.write("own.vug", "grammar own: facade {\n axiom A\n A if width > 20m -> window\n"
                              " A -> columns(15m, door, 1, wall)\n A -> wall\n}\n")
        said = self.model("--grammar", "own.vug", "--width", "12m", "--height", "9m", "--list").out
        self.assertIn("- window [condition is false: the condition of 'A -> window' is false for A", said)
        self.assertIn("- columns(door, wall) [does not fit: the parts do not fit: they need 15m of 12m", said)
        self.assertIn("+ wall", said)

    def test_every_style_can_be_modelled(self):
        for grammar in sorted((SOURCE / "data/facades").glob("*.vug")):
            size = ("--width", "12m", "--height", "9m") if grammar.name == "ripperda.vug" else ()
            self.assertIn("\n  + ", self.model("--grammar", grammar.name, *size, "--list").out)
        said = self.model("--grammar", "paris_art_deco.vug", "--apply", "0 rows", "--apply", "0.1 mirror",
                          "--apply", "0.1.0 columns", "--apply", "0.1.0.1 repeat", "--list").out
        self.assertIn("0.1.0.1.1 Storey(1, 1) 4.35 x 3.1 m at (0.55, 7.1)\n"
                      "  - rows(wall, Railed, wall) [condition is false: ", said)

    def test_undo_redo_and_checkpoints(self):
        trees = [self.model("s.json", "--json").out]
        self.model("s.json", "--act", "0.0 IdenticalGrid columns=5 rows=1", "-o", "t.json")
        self.assertNotEqual(self.model("t.json", "--json").out, trees[0])
        self.model("t.json", "--undo", 1, "-o", "u.json")
        self.assertEqual(self.model("u.json", "--json").out, trees[0])
        self.assertEqual(len(self.session("u.json")["edits"]), 4)
        self.model("u.json", "--redo", 1, "-o", "v.json")
        self.assertEqual((self.folder / "v.json").read_bytes(), (self.folder / "t.json").read_bytes())
        self.assertEqual(self.model("t.json", "--to", "grid", "--json").out, trees[0])
        self.assertIn("the session has 3 edits to undo, not 9", self.model("s.json", "--undo", 9, "--tree", code=2).err)
        self.assertIn("did you mean 'grid'", self.model("s.json", "--to", "grit", "--tree", code=2).err)

    def test_a_moved_checkpoint_is_reported(self):
        said = self.model("s.json", "--act", "0.0 IdenticalGrid", "--checkpoint", "grid", "-o", "t.json").err
        self.assertIn("the checkpoint 'grid' was after 3 edits and is now after 4", said)
        self.assertFalse(self.model("t.json", "--checkpoint", "grid", "-o", "t.json").err)
        self.assertFalse(self.model("t.json", "--undo", 1, "--checkpoint", "other", "-o", "u.json").err)

    def test_forms(self):
        self.assertIn("0.0 FacadeRow 12 x 3 m at (0, 0)  open", self.model("s.json").out)
        self.assertTrue(self.model("s.json", "--theta").out.startswith("Facade(0, 0, 12, 9, (FacadeRow(3), "))
        data = json.loads(self.model("s.json", "--json").out)
        self.assertEqual(len(data["elements"]), 7)
        self.assertTrue(data["nodes"][1]["stuck"])
        self.model("s.json", "--svg", "out/s.svg", "--overlay", "photo.png", "--scene", "s.vug")
        self.assertIn('href="../photo.png"', (self.folder / "out/s.svg").read_text())
        self.assertIn("open", (self.folder / "out/s.svg").read_text())
        tree = json.loads(self.expect(0, "tree", "s.vug", "--json").out)
        self.assertEqual(len([e for e in tree["elements"] if e["kind"] == "window"]), 7)

    def test_carved(self):
        self.model("s.json", "--carve", "s.vdb", "--voxel", "10cm")
        info = self.expect(0, "info", "s.vdb").out
        self.assertIn("stone", info)
        self.assertNotIn("panes", info, "10 cm are too coarse for glass")
        self.model("--grammar", "ripperda.vug", "--width", "2m", "--height", "2m", "--act", "0 RegularIdenticalGrid",
                   "--carve", "small.vdb")
        self.assertIn("panes", self.expect(0, "info", "small.vdb").out)

    def test_carved_solids_have_a_recipe_with_all_measures(self):
        self.write("own.vug", "grammar own: facade {\n width 2m\n height 2m\n axiom A\n"
                              " A -> inset(50cm, window(panes: [1, 1], head: round))\n}\n")
        begin = ("--grammar", "own.vug", "--apply", "0 inset")
        self.model(*begin, "--scene", "again.vug", "--carve", "own.vdb", "--thickness", "80cm")
        window = "window(panes: [1, 1], head: round)"
        self.assertIn(window, (self.folder / "again.vug").read_text())
        recipe = self.expect(0, "recipe", "own.vdb").out
        self.assertIn(window, recipe)
        self.assertIn("thickness 0.8m", recipe)
        self.write("recipe.vug", recipe)
        self.expect(0, "build", "recipe.vug", "-o", "rebuilt")
        first, second = (json.loads(self.expect(0, "info", name, "--json").out)
                         for name in ("own.vdb", "rebuilt/recipe.vdb"))
        self.assertEqual([g["active_voxels"] for g in first["grids"]],
                         [g["active_voxels"] for g in second["grids"]])

    def test_carved_solids_have_the_sizes_of_the_recipe(self):
        """Texts have a resolution of a tenth of a millimetre, which cannot represent a third of a metre."""
        self.model("--grammar", "ripperda.vug", "--width", "2m", "--height", "2m", "--act",
                   "0 RegularIdenticalGrid columns=1 rows=1 x=0.33335 y=0.33335 width=1.33335 height=1.33335", "--carve",
                   "a.vdb", "--voxel", "2cm")
        self.write("again.vug", self.expect(0, "recipe", "a.vdb").out)
        self.expect(0, "build", "again.vug", "-o", "out")
        ids = [json.loads(self.expect(0, "info", name, "--json").out)["id"] for name in ("a.vdb", "out/again.vdb")]
        self.assertEqual(*ids)

    def test_thin_walls_are_reported(self):
        begin = ("--grammar", "ripperda.vug", "--width", "2m", "--height", "2m", "--carve", "a.vdb")
        said = self.model(*begin, "--thickness", "3cm").err
        self.assertIn("warning: a wall of 0.03m is thinner than two voxels of 0.04m and may have holes", said)
        self.assertIn("hint: --voxel 0.015m, or --thickness 0.08m", said)
        self.assertFalse(self.model(*begin, "--thickness", "8cm").err)

    def test_scenes_are_named_as_their_files(self):
        for name, grammar in (("front", "front"), ("my front 2", "my_front_2"), ("panes", "facade_panes"),
                              ("s", "s"), ("cm", "facade_cm"), ("frame", "facade_frame")):
            self.model("s.json", "--scene", f"out/{name}.vug")
            self.assertIn(f"grammar {grammar}: facade {{", (self.folder / f"out/{name}.vug").read_text())
            self.expect(0, "check", f"out/{name}.vug")

    def test_inputs_of_a_session_are_not_overwritten(self):
        self.write("mine/own.vug", "grammar own: facade {\n width 5m\n height 4m\n axiom A\n A -> window\n}\n")
        write_png(self.folder / "photo.png", [[(9, 9, 9)] * 10] * 8)
        photo = (self.folder / "photo.png").read_bytes()
        self.model("--grammar", "mine/own.vug", "--photo", "photo.png", "-o", "kept/k.json")
        for wrong in (("--svg", "photo.png"), ("--scene", "mine/own.vug"), ("--overlay", "photo.png", "--svg", "photo.png"),
                      ("--apply", "0 window", "-o", "two.json", "--svg", "two.json"), ("--carve", "k.obj")):
            self.model("kept/k.json", *wrong, code=2)
        self.assertEqual((self.folder / "photo.png").read_bytes(), photo)
        self.assertIn("A -> window", (self.folder / "mine/own.vug").read_text())
        self.assertFalse((self.folder / "two.json").exists())

    def test_edits_in_the_order_of_the_command(self):
        self.model(*BEGIN[2:], "--edit", "apply 0 rows", "--apply", "0.1 repeat count=3",
                   "--edit", "retract 0.1", "--act", "0.1 Grid", "-o", "o.json")
        self.assertEqual([e["edit"] for e in self.session("o.json")["edits"]],
                         ["apply", "apply", "retract", "act"])

    def test_sessions_in_other_folders(self):
        self.write("mine/own.vug", "grammar own: facade {\n width 5m\n height 4m\n axiom A\n A -> window\n}\n")
        self.model("--grammar", "mine/own.vug", "--apply", "0 window", "-o", "mine/a.json")
        self.assertEqual(self.session("mine/a.json")["grammar"], "own.vug")
        self.model("mine/a.json", "--checkpoint", "end", "-o", "other/b.json")
        self.assertEqual(self.session("other/b.json")["grammar"], "../mine/own.vug")
        self.assertEqual(self.model("other/b.json", "--json").out, self.model("mine/a.json", "--json").out)

    def test_from_a_tree(self):
        """Trees of a session and of a fit."""
        self.write("tree.json", self.model("s.json", "--json").out)
        self.assertFalse(self.model("--from", "tree.json", "-o", "back.json").err)
        windows = [[one["rect"] for one in json.loads(self.model(name, "--json").out)["elements"]]
                   for name in ("s.json", "back.json")]
        self.assertEqual(len(windows[0]), len(windows[1]))
        for was, now in zip(*windows):
            for a, b in zip(was, now):
                self.assertAlmostEqual(a, b, delta=0.001)
        rows = [[(30, 35, 60) if 8 < x % 30 < 22 and 10 < y % 40 < 32 else (190, 170, (x * y) % 9) for x in range(90)]
                for y in range(120)]
        write_png(self.folder / "photo.png", rows)
        self.expect(0, "facade", "fit", "photo.png", "-o", "out", "--no-carving", "--steps", 2000)
        self.model("--from", "out/photo.json", "--photo", "photo.png", "-o", "fit.json")
        fitted = json.loads((self.folder / "out/photo.json").read_text())
        model = json.loads(self.model("fit.json", "--json").out)
        self.assertEqual((model["width"], model["height"]), (12, 16))
        self.assertEqual(len(model["elements"]), len(fitted["elements"]))
        self.assertEqual(self.session("fit.json")["photo"]["file"], "photo.png")
        self.assertIn("--width", self.model("--from", "tree.json", "--width", "3m", code=2).err)
        self.assertIn("s.json:1:1: error: this is not a facade tree", self.model("--from", "s.json", code=2).err)
        self.assertIn("no such file", self.model("--from", "gone.json", code=2).err)
        self.write("mine/house.vug", (SOURCE / "data/facades/ripperda.vug").read_text().replace("grammar ripperda", "grammar house"))
        self.expect(0, "facade", "model", "--grammar", "mine/house.vug", "--width", "12m", "--height", "9m", "-o", "h.json")
        self.write("house.json", self.expect(0, "facade", "model", "h.json", "--json").out)
        self.assertRegex(self.model("--from", "house.json", code=2).err,
                         "error: there is no grammar 'house.vug': no such file\nhint: 'house.json' was derived from a grammar 'house': "
                         "name its file, as in --grammar")
        self.model("--from", "house.json", "--grammar", "mine/house.vug")

    def test_options_that_begin_a_session(self):
        for option, value in (("--width", "9m"), ("--height", "9m"), ("--facade", "a"), ("--photo", "a.png"),
                              ("--from", "a.json"), ("--grammar", "ripperda.vug")):
            said = self.model("s.json", option, value, "--tree", code=2).err
            self.assertIn(f"{option} applies to new sessions only, but 's.json' exists", said)

    def test_faults_of_edits_come_first(self):
        self.assertIn("unknown edit 'frobnicate'", self.model("s.json", "--edit", "frobnicate 0", code=2).err)
        self.assertIn("the session has 3 edits to undo", self.model("s.json", "--undo", 9, code=2).err)
        self.assertIn("would be lost", self.model("s.json", "--undo", 1, code=2).err)

    def test_broken_sessions_leave_no_files(self):
        text = (self.folder / "s.json").read_text()
        for bad, told in ((text.replace('"rows":2', '"rows":0'), "/edits/1/numbers/rows: 'rows' is 0"),
                          (text.replace("Grid", "Gridd"), "s.json:10:39: error: /edits/1/rule"),
                          (text.replace("ripperda.vug", "riperda2.vug"), "did you mean 'ripperda.vug'"),
                          (text[:-20], "invalid JSON"), ("", "invalid JSON"),
                          (text.replace('"version": 1', '"version": 9'), "this program reads version 1"),
                          ("\0\xff" * 40, "invalid JSON")):
            self.write("s.json", bad)
            said = self.model("s.json", "--svg", "o.svg", "-o", "t.json", code=2).err
            self.assertIn(told, said)
            self.assertEqual(self.files(), ["s.json"])
        self.model("nowhere.json", code=2)
        self.model(code=2)

    def test_bad_arguments(self):
        self.assertIn("would be lost", self.model("s.json", "--apply", "0.0 IdenticalGrid", code=2).err)
        self.assertIn("doing 'apply 0.7 Grid'",
                      self.model("s.json", "--apply", "0.7 Grid", "--tree", code=2).err)
        self.assertIn("the pixel size is unknown", self.model("s.json", "--edit", "set 0 heights=40px", "--tree", code=2).err)
        self.model("s.json", "--grammar", "ripperda.vug", code=2)
        self.model("--grammar", "ripperda.vug", code=2)
        self.model("s.json", "--svg", "s.json", code=2)
        self.model("s.json", "--list", "0.9", code=2)
        self.model("s.json", "--edit", "frobnicate 0", "--tree", code=2)
        before = (self.folder / "s.json").read_bytes()
        self.model("s.json", "--apply", "0.7 Grid", "-o", "s.json", code=2)
        self.assertEqual((self.folder / "s.json").read_bytes(), before, "a refused edit keeps the file")


class Samples(VugTest):
    """Sessions in data/ and the commands of docs/guides/modeller.md."""

    def test_samples_are_whole(self):
        sessions = sorted(SESSIONS.glob("*.json"))
        self.assertTrue(sessions)
        for session in sessions:
            photo = json.loads(session.read_text()).get("photo")
            if photo:
                self.assertTrue((SESSIONS / photo["file"]).is_file())
            tree = json.loads(self.expect(0, "facade", "model", session, "--json").out)
            self.assertFalse([n for n in tree["nodes"] if n.get("stuck")], session)
            self.assertGreater(len(tree["elements"]), 10)
            self.expect(0, "facade", "model", session, "-o", "copy.json")

    def test_examples_of_the_page_run(self):
        page = (SOURCE / "docs/guides/modeller.md").read_text()
        blocks = re.findall(r"```sh\n(.*?)```", page, re.S)
        self.assertGreaterEqual(len(blocks), 4)
        (self.folder / "data").symlink_to(SOURCE / "data")
        for line in "".join(blocks).replace("\\\n", " ").splitlines():
            words = [w[1:-1] if w[0] == "'" else w for w in re.findall(r"'[^']*'|\S+", line)]
            self.assertEqual(words[:3], ["vug", "facade", "model"], line)
            self.expect(0, *words[1:])


if __name__ == "__main__":
    unittest.main()
