# SPDX-License-Identifier: Apache-2.0
"""L-systems that never end, grow without bound or compute invalid numbers: each stops soon, in little
memory, with a message that names the rule and its location."""
import resource
import subprocess
import unittest

from vug import PROGRAM, SLOW, VugTest

LIMIT = "exceeds its limit of 10000000 modules: the next step makes"
ENDS = "does not terminate after 10000 rounds, for instance the rule of"
# Case: lines of the block (the first is line 2 of the text), location and part of the message.
BOMBS = {
    "one module becomes eight": (
        ["axiom A", "steps 1000", "A -> AAAAAAAA"], "4:1", f"{LIMIT} 16777216, 16777216 of them by the rule of 'A'"),
    "with numbers": (
        ["axiom A(1)", "steps 1000", "A(x) -> A(x+1)B A(x+1)", "B -> BB"], "5:1", LIMIT),
    "with contexts": (
        ["axiom AAAA", "steps 1000", "A < A -> AA", "A -> A"], "4:1", LIMIT),
    "with chance": (["axiom A", "steps 1000", "A @1 -> AA", "A @1 -> AAA"], "5:1", LIMIT),
    "while growing older": (
        ["axiom A(0)", "time 1000000", "A(t) after 1 -> A(0)A(0)"], "4:1", LIMIT),
    "within one moment": (["axiom A(0)", "time 2", "A(t) after 1 -> A(1)"], "4:1", f"the growth of grammar 'g' {ENDS} 'A(t)'"),
    "decomposition": (
        ["axiom A", "decompose {", "A -> A[B]", "}"], "4:1", "the decomposition of 'A' never terminates: A -> A"),
    "decomposition in a circle": (
        ["axiom A", "decompose {", "A -> B", "B -> [C]", "C -> A", "}"], "4:1", "never terminates: A -> B -> C -> A"),
    "decomposition that no guard ends": (
        ["axiom B(1)A(1)", "decompose {", "B(x) if x < 0 -> A(x)", "A(x) if x > 0 -> A(x+1)", "}"], "5:1",
        f"the decomposition of grammar 'g' {ENDS} 'A(x)'"),
    "decomposition that doubles": (
        ["axiom A(1)", "decompose {", "A(x) if x > 0 -> A(x+1)A(x)", "}"], "4:1", LIMIT),
    "interpretation by itself": (
        ["axiom F", "interpret {", "F -> F+F", "}"], "4:1", "the interpretation of 'F' never terminates: F -> F"),
    "interpretation that no guard ends": (
        ["axiom A(1)", "interpret {", "A(x) if x > 0 -> F A(x/2+1)", "}"], "4:1",
        f"the interpretation of grammar 'g' {ENDS} 'A(x)'"),
    "interpretation of too great a depth": (
        ["axiom A(1)", "interpret {", "depth 1e9", "A(x) -> F A(x/2+1)", "}"], "5:1", "reduce 'depth'"),
    "a guard that divides by 0": (["axiom A(0)", "A(x) if 1/x > 3 -> B"], "3:1",
                                  "one side of a comparison of the rule of 'A(x)' is inf"),
    "an invalid number": (["axiom B A(1)", "A(x) -> B[A(sqrt(0 - x))]"], "3:1",
                              "parameter 1 of module 3 of the rule of 'A(x)' is not a number"),
    "a number beyond all": (["axiom A(1)", "steps 99", "A(x) -> A(x*1e200)"], "4:1",
                            "parameter 1 of module 1 of the rule of 'A(x)' is inf"),
    "an invalid weight": (["axiom A(1)", "A(x) @(x - 2) -> B"], "3:1", "the weight of the rule of 'A(x)' is -1"),
}
TEXTS = {
    "a block without an axiom": (["A -> B"], "1:9", "grammar 'g' has no axiom"),
    "a rule without its arrow": (["axiom A", "A B"], "3:1", "a line without '->'"),
    "a rule without its arrow, between others": (["axiom A", "A -> B", "B F[+F]", "C -> D"], "4:1", "a line without '->'"),
    "a rule without a word": (["axiom A", "A ->"], "3:3", "the rule of 'A' has no modules"),
    "an unknown option": (["stepz 3", "axiom A"], "2:1", "did you mean 'steps'?"),
    "half a step": (["steps 2.5", "axiom A"], "2:1", "'steps'"),
    "steps below none": (["steps -1", "axiom A"], "2:1", "'steps'"),
    "half a seed": (["seed 1.5", "axiom A"], "2:6", "a seed must be a whole number, not 1.5"),
    "half a limit": (["limit 1.5", "axiom A"], "2:7", "the limit must be a whole number of modules, not 1.5"),
    "an axiom beyond the limit": (["limit 3", "axiom FFFF"], "3:1", "exceeds its limit of 3 modules: its axiom has 4"),
    "a weight below 0": (["axiom A", "A @-1 -> B"], "3:4", "weights must be 0 or more"),
    "two lists of what contexts see": (["axiom A", "ignore F", "consider A", "A < A -> B"], "4:10", "'consider' cannot be combined with 'ignore'"),
    "nothing behind": (["axiom A", "A > -> B"], "3:3", "expected a right context after '>'"),
    "an unknown query": (["axiom A ?Z(1)"], "2:9", "known queries: ?P, ?H, ?L, ?U, ?D"),
    "a wrong number of parameters": (["axiom A(1, 2)", "A(x) -> B"], "2:7", "its rules take 1"),
    "an unknown name": (["axiom A(1)", "A(x) -> B(y)"], "3:11", "unknown name 'y'"),
    "a turn without a unit": (["axiom +(60)F"], "2:9", "write 60deg or 60rad"),
    "an open branch": (["axiom A", "A -> F[B"], "3:7", "the '[' in the rule of 'A' is never closed"),
    "a branch that is not open": (["axiom A", "A -> B]"], "3:7", "']' without a matching '['"),
    "two left contexts": (["axiom A", "A < B < C -> D"], "3:7", "duplicate '<' in the head of a rule"),
    "a lost table": (["axiom A", "schedule summer", "table winter {", "A -> B", "}"], "3:10",
                     "unknown table 'summer'"),
    "a schedule of no steps": (["axiom A", "schedule winter*0", "table winter {", "A -> B", "}"], "3:10",
                               "the schedule has no steps"),
    "ages and steps": (["axiom A(0)", "steps 3", "A(t) after 1 -> A(0)"], "3:1", "has a 'time' instead of 'steps'"),
    "ages and contexts": (["axiom A(0)", "A(t) after 1 -> A(0)", "B < C -> D"], "4:", "rules cannot have a context"),
}


class Bombs(VugTest):
    def stopped(self, lines, place, message):
        self.write("g.vug", "grammar g: lsystem {\n" + "\n".join(lines) + "\n}\n")
        error = self.expect(2, "derive", "g.vug", "--drawn", "--count").err
        self.assertIn(f"g.vug:{place}", error)
        self.assertIn(message, error)

    def test_systems_that_grow_too_large_or_never_end(self):
        for name, bomb in BOMBS.items():
            with self.subTest(name):
                self.stopped(*bomb)

    def test_faults_of_texts(self):
        for name, text in TEXTS.items():
            with self.subTest(name):
                self.stopped(*text)

    def test_they_stop_within_the_given_memory(self):
        self.write("g.vug", "grammar g: lsystem {\naxiom A(1)\nsteps 22\nA(x) -> A(x+1)A(x+1)\n}\n"
                            "field wood = stems(of: g)\nvolume v = level_set(wood, voxel: 1m)\n")
        for verb, out in (("build", "out"), ("render", "out.exr")):
            error = self.expect(2, verb, "g.vug", "-o", out, "--max-memory", "1M").err
            self.assertIn("grammar 'g' exceeds the memory of 1 MiB", error)
        self.assertEqual(self.files(), ["g.vug"])

    @unittest.skipIf(SLOW, "sanitizers take memory of their own")
    def test_they_stop_in_little_memory(self):
        self.write("g.vug", "grammar g: lsystem {\naxiom A(1)\nsteps 1000\nA(x) -> A(x+1)A(x+1)\n}\n")
        subprocess.run([PROGRAM, "derive", "g.vug"], cwd=self.folder, stderr=subprocess.DEVNULL)
        most = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss  # KiB, the maximum of all child processes so far
        self.assertLess(most, 1 << 20)

    def test_check_derives_undrawn_systems(self):
        self.write("g.vug", "grammar g: lsystem {\naxiom F\nsteps 100\nF -> FF\n}\n"
                            "grammar h: lsystem {\naxiom guide(3) F\n}\n")
        error = self.expect(2, "check", "g.vug").err
        self.assertIn("g.vug:4:1: error: grammar 'g' exceeds its limit", error)
        self.assertIn("g.vug:6:9: error: no guides are defined, at 'guide(3)', module 1 of the word", error)

    def test_deeply_nested_blocks(self):
        for name, opening in (("blocks", "grammar g: lsystem {\n"), ("tables", "grammar g: lsystem {\ntable A {\n"),
                              ("words", "grammar g: lsystem {\naxiom A{\n"), ("polygons", "{")):
            with self.subTest(name):
                text = opening * 50000 if name != "polygons" else "grammar g: lsystem {\naxiom " + opening * 50000
                self.write("g.vug", text)
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                self.expect(2, "check", "g.vug")
                taken = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
                self.assertLess(taken, 10 if not SLOW else 100)  # seconds of processor time; it once took minutes

    def test_a_module_asks_for_too_many_steps_of_another_system(self):
        self.write("g.vug", "grammar Leaf: lsystem {\n axiom L\n L -> L\n}\n"
                            "grammar g: lsystem {\n axiom Leaf(1000000000)\n}\n")
        self.assertIn("g.vug:5:9: error: grammar 'g' requests 1000000000 steps of 'Leaf'; the maximum is 1000000",
                      self.expect(2, "derive", "g.vug", "g", "--drawn").err)

    def test_systems_that_require_each_other(self):
        self.write("g.vug", "grammar A: lsystem {\n axiom B\n}\ngrammar B: lsystem {\n axiom A\n}\n")
        chain = "".join(f"grammar L{i}: lsystem {{\n axiom F L{i + 1}\n}}\n" for i in range(2500))
        self.write("chain.vug", chain + "grammar L2500: lsystem {\n axiom F\n}\n")
        for verb in (("check",), ("derive", "L0")):
            error = self.expect(2, verb[0], "chain.vug", *verb[1:]).err
            self.assertRegex(error, r"chain\.vug:\d+:\d+: error: more than 200 names depend on each other in a row")
        self.assertIn("'A' depends on itself", self.expect(2, "derive", "g.vug", "A", "--drawn").err)


if __name__ == "__main__":
    unittest.main()
