# SPDX-License-Identifier: Apache-2.0
"""Names, tab order, keys, contrast and clipping of all widgets; messages; the documented keys; the event loop."""
import re
import subprocess
import unittest

from studio import HERE, PROGRAM, SOURCE, StudioTest, require_studio


class Widgets(StudioTest):
    def test_audit_in_both_themes_and_at_all_scales(self):
        for scale in ("1", "1.25", "2"):
            for theme in ("light", "dark"):
                self.studio('expect audit = ""\nopen "{session}"\nselect 0.1.0\nexpect audit = ""\nselect 0.0\n'
                            'expect audit = ""\nkey Ctrl+E\nexpect audit = ""', "--theme", theme,
                            QT_SCALE_FACTOR=scale)

    def test_the_screenshots_of_the_guide_can_be_made(self):
        self.studio((HERE / "screenshot.txt").read_text())
        for name in ("studio_actions.jpg", "studio_facades.jpg"):
            self.assertGreater((self.folder / name).stat().st_size, 50_000)

    def test_keys_are_documented(self):
        table = subprocess.run([PROGRAM, "--keys"], capture_output=True, text=True, check=True,
                               env=self.environment()).stdout
        page = (SOURCE / "docs/guides/studio_facades.md").read_text()
        self.assertIn(table.strip(), page)

    def test_errors_of_scripts_name_the_line(self):
        error = self.studio('open "{session}"\n\nexpect edits = 4', code=2)
        self.assertIn("script.txt:3:1: expected edits = '4', but it is '9'", error)
        self.assertIn("unknown command 'opened'", self.studio("opened x", code=2))
        self.assertIn("no visible widget 'save button'", self.studio('click "save button"', code=2))

    def test_the_event_loop_is_never_blocked_by_a_fit(self):
        error = self.studio('photo "{photo}" 15m\nwait idle\nreset-heartbeat\nfit 20000\nwait idle\n'
                            'expect undo_name = Fit\nexpect heartbeat below 300', "--heartbeat")
        self.assertTrue(re.search(r"longest delay of the event loop: \d+ ms; longest computation: \d+ ms", error))

    def test_invalid_input_in_the_window_is_a_message(self):
        self.studio('open "{session}"\nselect 0.1.0.0\nkey Ctrl+Shift+P\ntype "set . columns=4000"\nkey Return\n'
                    'expect message contains "it must be"\nkey Escape\nexpect edits = 9')


if __name__ == "__main__":
    require_studio()
    unittest.main()
