# SPDX-License-Identifier: Apache-2.0
"""Truncated and invalid files: an error that names the file and exit code 2, never a crash."""
import json
import os
import random
import re
import unittest

from vug import BALL, VugTest

READERS = {  # the verbs that read each kind of file
    ".vdb": ["info", "measure"],
    ".ply": ["info", "measure"],
    ".obj": ["measure"],
    ".stl": ["measure"],
    ".exr": ["info"],
    ".png": ["info"],
}
IN_A_SCENE = {
    ".vdb": 'volume v = level_set(grid(file: "{}"), voxel: 20cm)\n',
    ".ply": 'volume v = level_set(mesh(file: "{}"), voxel: 20cm)\n',
    ".obj": 'volume v = level_set(mesh(file: "{}"), voxel: 20cm)\n',
    ".stl": 'volume v = level_set(mesh(file: "{}"), voxel: 20cm)\n',
    ".exr": 'light day = sky_image(file: "{}")\n',
    ".png": 'volume v = level_set(heightfield(file: "{}"), voxel: 1m)\n',
}


class BrokenFiles(VugTest):
    def prepare(self):
        self.write("ball.vug", BALL.replace("10cm", "30cm") +
                   "".join(f"mesh as_{f} on rock {{ format {f} }}\n" for f in ("ply", "obj", "stl")))
        self.expect(0, "build", "ball.vug", "-o", "out")
        self.expect(0, "render", "ball.vug", "-o", "out/ball.exr", "--size", "16x8", "--spp", "1")

    def setUp(self):
        super().setUp()
        self.whole = {f.suffix: f for f in (self.folder / "out").iterdir()}
        self.assertEqual(sorted(self.whole), sorted(READERS))
        self.in_a_scene = []

    def refused(self, name, verb):
        result = self.vug(verb, name)
        said = f"vug {verb} {name}: {result.code}\n{result.out}{result.err}"
        self.assertEqual(result.code, 2, said)
        self.assertIn("error: ", result.err, said)
        self.assertIn(name, result.err, said)
        for rude in ("terminate", "what()", "std::", "Exception", "0x"):
            self.assertNotIn(rude, result.err, said)

    def try_all(self, content, suffix, what, in_a_scene=False):
        name = f"{what}{suffix}"
        self.write(name, content)
        for verb in READERS[suffix]:
            with self.subTest(file=name, verb=verb):
                self.refused(name, verb)
        if in_a_scene:
            self.in_a_scene.append(name)

    def check_the_scene(self, why=""):
        """A scene that reads all damaged files; each line reports an error."""
        lines = [IN_A_SCENE[f".{name.split('.')[1]}"].format(name) for name in self.in_a_scene]
        names = {" v ": " v{} ", " day ": " day{} "}
        for i, line in enumerate(lines):
            for old, new in names.items():
                line = line.replace(old, new.format(i))
            lines[i] = line
        self.write("use.vug", "".join(lines))
        error = self.expect(2, "check", "use.vug").err
        for i, name in enumerate(self.in_a_scene):
            with self.subTest(file=name, verb="check"):
                self.assertRegex(error, rf"(?m)^use\.vug:{i + 1}:\d+: error: .*{why}\n"
                                        + re.escape(lines[i]))

    def test_garbage(self):
        noise = random.Random(1).randbytes(3000)
        for suffix in READERS:
            self.try_all(b"", suffix, "empty")
            self.try_all(noise, suffix, "noise", in_a_scene=True)
        self.check_the_scene()

    def test_files_of_another_kind(self):
        for suffix in READERS:
            self.try_all(self.whole[".vdb" if suffix != ".vdb" else ".exr"].read_bytes(), suffix, "other")

    def test_truncated(self):
        for suffix, path in self.whole.items():
            if suffix == ".obj":
                continue  # see below: a truncated text file can still be read
            whole = path.read_bytes()
            self.try_all(whole[:int(0.3 * len(whole))], suffix, "cut", in_a_scene=True)
            if suffix != ".png":  # readers do not need its last bytes
                self.try_all(whole[:-1], suffix, "lacks_a_byte")
        self.check_the_scene()

    def test_a_text_mesh_that_ends_early_is_open(self):
        whole = self.whole[".obj"].read_bytes()
        end = whole.rindex(b"\nf ", 0, int(0.9 * len(whole))) + 1
        self.write("cut.obj", whole[:end])
        self.expect(1, "measure", "cut.obj")
        self.write("use.vug", IN_A_SCENE[".obj"].format("cut.obj"))
        self.assertIn("does not bound a solid", self.expect(2, "check", "use.vug").err)

    def test_flipped_bytes_never_crash(self):
        """A damaged file may still be readable, but must never end the program by a signal."""
        dice = random.Random(7)
        for suffix, path in self.whole.items():
            for flips in (1, 4):
                content = bytearray(path.read_bytes())
                for _ in range(flips):
                    content[dice.randrange(min(len(content), 2000))] = dice.randrange(256)
                name = f"bad{flips}{suffix}"
                self.write(name, bytes(content))
                with self.subTest(file=name):
                    result = self.vug(READERS[suffix][-1], name)
                    self.assertIn(result.code, (0, 1, 2), result.err)

    def test_a_scene_that_is_not_a_text_file(self):
        for suffix in (".vdb", ".ply", ".exr", ".png"):
            self.write("use.vug", self.whole[suffix].read_bytes())
            for verb in ["check", "format"] if suffix == ".vdb" else ["check"]:
                self.assertEqual(self.expect(2, verb, "use.vug").messages,
                                 "use.vug: error: the file is not a text file\n"
                                 "hint: scenes are UTF-8 text; 'vug info' describes grids, meshes and "
                                 "pictures\n")

    def test_files_that_are_not_regular(self):
        """Reading a pipe without a writer would block, and reading a device would never end."""
        for name, what in [("pipe", "pipe"), ("zero", "device"), ("folder", "folder")]:
            for suffix in (".vug", ".vdb", ".ply", ".exr"):  # the four ways of opening a file
                path = self.folder / f"{name}{suffix}"
                if name == "pipe":
                    os.mkfifo(path)
                elif name == "zero":
                    path.symlink_to("/dev/zero")
                else:
                    path.mkdir()
                for verb in READERS.get(suffix, ["check"]):
                    with self.subTest(file=path.name, verb=verb):
                        error = self.expect(2, verb, path.name).err
                        self.assertIn(f"'{path.name}': it is a {what}", error)
                if suffix in READERS:
                    self.in_a_scene.append(path.name)
        self.check_the_scene("it is a (pipe|device|folder)")
        for verb in ("check", "info", "measure"):
            self.expect(2, verb, "/proc/self/mem")
        self.write("use.vug", 'include "pipe.vug"\n')
        self.assertIn("use.vug:1:9: error: cannot read the file 'pipe.vug': it is a pipe\n",
                      self.expect(2, "check", "use.vug").err)

    def test_texts_of_any_bytes_in_a_picture(self):
        content = self.whole[".exr"].read_bytes()
        self.assertIn(b"volume rock", content)
        self.write("odd.exr", content.replace(b"volume rock", b"volume \xff\x01\xd6k"))
        self.assertIn("vug:recipe: volume \ufffd\ufffd\ufffdk", self.expect(0, "info", "odd.exr").out)
        texts = json.loads(self.expect(0, "info", "odd.exr", "--json").out)["metadata"]
        self.assertIn("volume \ufffd\x01\ufffdk", texts["vug:recipe"])

    def test_names_of_any_bytes(self):
        error = self.expect(2, "check", os.fsdecode(b"no\xff\n.vug")).err
        self.assertEqual(error, "error: cannot read 'no\ufffd\ufffd.vug': no such file\n")

    def test_a_truncated_include(self):
        self.write("use.vug", 'include "lib.vug"\nvolume v = level_set(hall, voxel: 20cm)\n')
        self.write("lib.vug", "let hall = union([sphere(1m), box(size: (1,")
        error = self.expect(2, "check", "use.vug").err
        self.assertTrue(error.startswith("lib.vug:1:"), error)
        self.write("lib.vug", b"\xff\xfe\x00l\x00e\x00t")
        self.assertIn("use.vug:1:9: error: 'lib.vug' is not a text file",
                      self.expect(2, "check", "use.vug").err)
        (self.folder / "lib.vug").unlink()
        self.assertIn("use.vug:1:9: error: ", self.expect(2, "check", "use.vug").err)


if __name__ == "__main__":
    unittest.main()
