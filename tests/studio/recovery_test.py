# SPDX-License-Identifier: Apache-2.0
"""A killed vug-studio loses nothing: its journal is offered and gives the last journalled state."""
import os
import random
import signal
import subprocess
import time
import unittest

from studio import PROGRAM, StudioTest, require_studio

EDITS = ["apply 0 rows(FacadeRow, PartFacade) heights=3.6", "act 0.1 RegularGrid columns=4 rows=3"]
COMMANDS = 60


def script(count):
    lines = ['photo "{photo}" 15m', *EDITS]
    for step in range(count):
        lines.append("undo" if step % 7 == 6 else f"set 0.1.0 columns={2 + step % 5}")
    return lines


class Recovery(StudioTest):
    def kill_after(self, lines):
        """Kills the program as soon as its journal has at least that number of lines; returns the journal's lines."""
        self.script("\n".join(script(COMMANDS) + ["wait 60000"]))
        state = self.folder / "state"
        process = subprocess.Popen([PROGRAM, "--script", self.folder / "script.txt"], env=self.environment(),
                                   cwd=self.folder, stderr=subprocess.DEVNULL)
        try:
            end = time.monotonic() + 60
            while time.monotonic() < end:
                journals = list(state.glob("*.vugjournal"))
                if journals and journals[0].read_text().count("\n") >= lines:
                    break
                time.sleep(0.001)
        finally:
            os.kill(process.pid, signal.SIGKILL)
            process.wait()
        text = journals[0].read_text()
        return text[:text.rfind("\n") + 1].splitlines()

    def test_recovers_the_last_journalled_state(self):
        stream = random.Random(4)
        for _ in range(5):
            journal = self.kill_after(stream.randrange(2, COMMANDS))
            self.assertGreater(len(journal), 1)
            # The state of a program that is not killed, after the same commands.
            self.studio("\n".join(journal + ["export json \"{folder}/expected.json\""]),
                        VUG_STATE_HOME=str(self.folder / "other"))
            self.studio("click recover\nexpect dirty = yes\nexport json \"{folder}/recovered.json\"")
            self.assertEqual((self.folder / "recovered.json").read_bytes(),
                             (self.folder / "expected.json").read_bytes())
            self.assertEqual(list((self.folder / "state").glob("*")), [], "the journal was used")

    def test_offers_a_journal_again_whose_photo_was_missing(self):
        state = self.folder / "state"
        state.mkdir()
        lost = state / "1-0.vugjournal"
        lost.write_text('photo moved.jpg 15m\n' + "\n".join(EDITS) + "\n")
        before = lost.read_bytes()
        self.studio("click recover\nexpect widget recover enabled = yes")
        self.assertEqual(lost.read_bytes(), before)

    def test_discards_a_journal_on_request_only(self):
        self.kill_after(5)
        self.studio("expect widget recover enabled = yes")
        self.assertEqual(len(list((self.folder / "state").glob("*"))), 1)
        self.studio("click discard")
        self.assertEqual(list((self.folder / "state").glob("*")), [])


if __name__ == "__main__":
    require_studio()
    unittest.main()
