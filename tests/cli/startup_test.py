# SPDX-License-Identifier: Apache-2.0
"""Commands load the library that calls OpenImageIO only for pictures other than EXR and PNG; what happens if that library is
missing. The same for PROJ and coordinate systems."""
import os
import pathlib
import subprocess
import unittest

from pictures import write_exr, write_hdr, write_png
from vug import PROGRAM, SOURCE, VugTest

LIBRARY = "libvug_image_files.so"
PROJ = "libproj.so.25"
PICTURE_LIBRARIES = (LIBRARY, "libOpenImageIO", "libOpenColorIO", "libavcodec", "libopencv_core")


class Startup(VugTest):
    def libraries(self, *args):
        """Names of the shared libraries that a run initialises, from the log of the dynamic linker."""
        log = self.folder / "linker"
        result = self.vug(*args, env=dict(os.environ, LD_DEBUG="libs", LD_DEBUG_OUTPUT=str(log)))
        self.assertEqual(result.code, 0, result.err)
        lines = [line for part in self.folder.glob("linker.*") for line in part.read_text().splitlines()]
        names = {pathlib.Path(line.split()[-1]).name for line in lines if "calling init:" in line}
        self.assertTrue(any(name.startswith("libstdc++") for name in names), "the log lists libraries")
        return names

    def copy_with(self, old, new):
        """A copy of the program in which one text is another of the same length."""
        self.assertEqual(len(old), len(new))
        program = pathlib.Path(PROGRAM).read_bytes()
        self.assertIn(old, program)
        copy = self.write("vug", program.replace(old, new))
        copy.chmod(0o755)
        return copy

    def run_copy(self, copy, *args):
        return subprocess.run([copy, *args], cwd=self.folder, stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=300)

    def test_commands_without_pictures_load_no_libraries_for_pictures(self):
        scene = SOURCE / "data/scenes/grotto.vug"
        for args in (["--version"], ["--help"], ["list"], ["check", scene]):
            with self.subTest(args=args):
                names = self.libraries(*args)
                self.assertFalse([name for name in names if name.startswith(PICTURE_LIBRARIES)])
                self.assertNotIn(PROJ, names)

    def test_a_render_without_textures_writes_its_pictures_without_them(self):
        self.write("s.vug", "volume rock = level_set(sphere(1m), voxel: 20cm)\ncamera main { eye (0, 0, 3) }\n"
                            "light lamp = sphere(center: (1, 1, 3), radius: 10cm, radiance: (9, 9, 9))\n"
                            "render main { size 16x16  spp 1 }\n")
        names = self.libraries("render", "s.vug", "-o", "s.exr", "--deep", "--multi-part")
        self.assertFalse([name for name in names if name.startswith(PICTURE_LIBRARIES)])
        self.assertTrue((self.folder / "s.png").exists() and (self.folder / "s.deep.exr").exists())

    def test_only_other_formats_than_exr_and_png_load_them(self):
        write_png(self.folder / "grey.png", [[(9, 9, 9)] * 16] * 16)
        write_exr(self.folder / "grey.exr", {name: [[0.5] * 16] * 16 for name in "RGB"})
        write_hdr(self.folder / "grey.hdr", [[(0.5, 0.5, 0.5)] * 16] * 16)
        for name in ("grey.png", "grey.exr"):
            self.assertFalse([loaded for loaded in self.libraries("diff", name, name)
                              if loaded.startswith(PICTURE_LIBRARIES)])
        names = self.libraries("diff", "grey.hdr", "grey.hdr")
        self.assertIn(LIBRARY, names)
        self.assertTrue([name for name in names if name.startswith("libOpenImageIO")])

    def test_surveys_load_proj_only_for_coordinate_systems(self):
        self.write("local.svx", "a b 10 0 0\n")
        self.write("grid.svx", "*cs UTM30N\n*cs out EPSG:27700\n*fix a 500000 5538630 0\na b 10 0 0\n")
        self.assertNotIn(PROJ, self.libraries("survey", "local.svx"))
        self.assertIn(PROJ, self.libraries("survey", "grid.svx"))
        copy = self.copy_with(b"libproj.so", b"libgone.so")
        self.assertEqual(self.run_copy(copy, "survey", "local.svx").returncode, 0)
        result = self.run_copy(copy, "survey", "grid.svx")
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertRegex(result.stderr, "error: the library PROJ, which computes coordinates, cannot be loaded: "
                                        ".*No such file")
        self.assertIn("hint: install the Debian package libproj25", result.stderr)

    def test_a_missing_library_is_reported_and_other_commands_still_work(self):
        write_hdr(self.folder / "grey.hdr", [[(0.5, 0.5, 0.5)] * 16] * 16)
        copy = self.copy_with(LIBRARY.encode(), b"libvug_image_gone_.so")
        self.assertEqual(self.run_copy(copy, "--version").returncode, 0)
        result = self.run_copy(copy, "diff", "grey.hdr", "grey.hdr")
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertRegex(result.stderr, "error: the library '.*libvug_image_gone_.so', which reads pictures, "
                                        "cannot be loaded: .*No such file")
        self.assertIn("hint: reinstall vug", result.stderr)

    def test_a_library_of_another_version_is_rejected(self):
        write_hdr(self.folder / "grey.hdr", [[(0.5, 0.5, 0.5)] * 16] * 16)
        copy = self.copy_with(b"picture library of vug ", b"picture library of gnu ")
        result = self.run_copy(copy, "diff", "grey.hdr", "grey.hdr")
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("is the picture library of vug ", result.stderr)
        self.assertIn("but the picture library of gnu ", result.stderr)


if __name__ == "__main__":
    unittest.main()
