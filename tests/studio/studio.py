# SPDX-License-Identifier: Apache-2.0
"""Runs vug-studio in tests. VUG_STUDIO in the environment names the program; it is empty where Qt is missing."""
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "cli"))
from vug import SOURCE, VugTest  # noqa: E402, F401

PROGRAM = os.environ.get("VUG_STUDIO", "")
SESSIONS = SOURCE / "data/facades/sessions"


def skip(reason):
    print(f"SKIPPED: {reason}")
    sys.exit(0)


def require_studio():
    if not PROGRAM:
        skip("vug-studio is not built, because Qt 6 is missing (tools/dev/install_packages studio)")


class StudioTest(VugTest):
    """The folder of the test has a copy of the photo, so that sessions next to it are not those of the data."""

    def prepare(self):
        shutil.copy(SESSIONS / "paris.jpg", self.photo)
        (self.folder / "runtime").mkdir(mode=0o700, exist_ok=True)

    @property
    def photo(self):
        return self.folder / "paris.jpg"

    def environment(self, **more):
        return {**os.environ, "QT_QPA_PLATFORM": "offscreen", "QT_FONT_DPI": "96", "LC_ALL": "C.UTF-8",
                "XDG_CONFIG_HOME": str(self.folder / "config"), "XDG_RUNTIME_DIR": str(self.folder / "runtime"),
                "VUG_STATE_HOME": str(self.folder / "state"), **more}

    def script(self, text):
        """A file with the script, in which {photo}, {session} and {folder} are replaced."""
        for name, value in (("photo", self.photo), ("session", SESSIONS / "paris.json"), ("folder", self.folder)):
            text = text.replace("{" + name + "}", str(value))
        return self.write("script.txt", text)

    def studio(self, text, *options, code=0, **environment):
        """Runs a script and returns what the program printed to stderr."""
        self.script(text)
        done = subprocess.run([PROGRAM, "--script", self.folder / "script.txt", *options], capture_output=True,
                              text=True, timeout=300, env=self.environment(**environment), cwd=self.folder)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stderr
