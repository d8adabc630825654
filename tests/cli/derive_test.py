# SPDX-License-Identifier: Apache-2.0
"""`vug derive` prints words; those of the teaching scenes equal those of the book, letter by letter."""
import hashlib
import json
import unittest

from vug import SOURCE, VugTest

SCENES = SOURCE / "data/scenes/lsystems"


def rewritten(word, rules, steps):
    """The oracle: replaces letters by strings, or by the result of a function of both neighbours."""
    for _ in range(steps):
        word = "".join(rules.get(letter, letter) for letter in word)
    return word


def neighbours(word, at, unseen):
    """The left and right neighbours along the branch, without side branches and ignored letters."""
    found = []
    for way, opens, closes in ((-1, "]", "["), (1, "[", "]")):
        depth, i, letter = 0, at + way, ""
        while 0 <= i < len(word):
            if word[i] == opens:
                depth += 1
            elif word[i] == closes:
                if depth == 0 and way > 0:
                    break
                depth -= depth > 0
            elif depth == 0 and word[i] not in unseen:
                letter = word[i]
                break
            i += way
        found.append(letter)
    return found


def hogeweg(rules, steps):
    """Figure 1.31: rules[binary number of left, strict and right]."""
    word = "F1F1F1"
    for _ in range(steps):
        out = []
        for i, letter in enumerate(word):
            context = neighbours(word, i, "+-F")
            if letter in "01" and all(context):
                letter = rules[int(context[0] + letter + context[1], 2)]
            out.append({"+": "-", "-": "+"}.get(letter, letter))
        word = "".join(out)
    return word.replace("0", "O").replace("1", "I")


HOGEWEG = {
    "a": (30, ["0", "1[+F1F1]", "1", "1", "0", "1F1", "0", "0"]),
    "b": (30, ["1", "1[-F1F1]", "1", "1", "0", "1F1", "1", "0"]),
    "c": (26, ["0", "1", "0", "1[+F1F1]", "0", "1F1", "0", "0"]),
    "d": (24, ["1", "0", "0", "1F1", "1", "1[+F1F1]", "1", "0"]),
    "e": (26, ["0", "1[-F1F1]", "1", "1", "0", "1F1", "1", "0"]),
}
HILBERT = {
    "A": "B-F+CFC+F-D&F^D-F+&&CFC+F+B//", "B": "A&F^CFB^F^D^^-F-D^|F^B|FC^F^A//",
    "C": "|D^|F^B-F+C^F^A&&FA&F^C+F+B^F^D//", "D": "|CFB-F+B|FA&F^A&&FB-F+B|FC//"}
# Scene, grammar, steps, axiom, rules. Lower-case letters represent names of two letters.
CASES = [
    ("koch", "koch", 5, "F-F-F-F", {"F": "F-F+F+FF-F-F+F"}),
    ("hilbert", "plane", 8, "L", {"L": "+RF-LFL-FR+", "R": "-LF+RFR+FL-"}),
    ("hilbert", "space", 4, "A", HILBERT),
    ("curves", "dragon", 12, "l", {"l": "l+r+", "r": "-l-r"}),
    ("curves", "gosper", 5, "l", {"l": "l+r++r-l--ll-r+", "r": "-l+rr++r+l--l-r"}),
    ("weeds", "a", 5, "F", {"F": "F[+F]F[-F]F"}),
    ("weeds", "b", 5, "F", {"F": "F[+F]F[-F][F]"}),
    ("weeds", "c", 4, "F", {"F": "FF-[-F+F+F]+[+F-F-F]"}),
    ("weeds", "d", 7, "X", {"X": "F[+X]F[-X]+X", "F": "FF"}),
    ("weeds", "e", 7, "X", {"X": "F[+X][-X]FX", "F": "FF"}),
    ("weeds", "f", 5, "X", {"X": "F-[[X]+X]+F[+FX]-X", "F": "FF"}),
    ("bush", "bush", 7, "A", {"A": "[&FL!A]/////'[&FL!A]///////'[&FL!A]", "F": "S/////F", "S": "FL",
                              "L": "['''^^{-f+f+f-|-f+f+f}]"}),
]


class Words(VugTest):
    def derive(self, scene, *args):
        return self.expect(0, "derive", SCENES / f"{scene}.vug", *args).out

    def test_classic_systems_by_the_hash_of_the_whole_word(self):
        for scene, grammar, steps, axiom, rules in CASES:
            word = rewritten(axiom, rules, steps)
            if scene == "curves":
                word = word.replace("l", "Fl").replace("r", "Fr")
            said = self.derive(scene, grammar, "--steps", steps, "--hash")
            self.assertEqual(said.strip(), hashlib.sha256(word.encode()).hexdigest(), (scene, grammar))

    def test_hogeweg_and_hesper(self):
        for grammar, (steps, rules) in HOGEWEG.items():
            word = hogeweg(rules, steps)
            said = self.derive("hogeweg", grammar)
            self.assertEqual(hashlib.sha256(said.strip().encode()).hexdigest(),
                             hashlib.sha256(word.encode()).hexdigest(), grammar)

    def test_published_counts(self):
        for scene, grammar, steps, lines, modules in (("koch", "koch", 5, 131072, 243419),
                                                      ("hilbert", "plane", 8, 65535, 218451),
                                                      ("weeds", "f", 5, 1488, 6263)):
            said = dict(line.split() for line in
                        self.derive(scene, grammar, "--steps", steps, "--count").splitlines())
            self.assertEqual((int(said["F"]), int(said["total"])), (lines, modules))

    def test_the_example_with_parameters(self):
        words = ["B(2)A(4,4)", "B(1)B(4)A(1,0)", "B(0)B(3)A(2,1)", "CB(2)A(4,3)", "CB(1)A(8,7)",
                 "CB(0)B(8)A(1.1428571428571428,0)"]
        for steps, word in enumerate(words):
            self.assertEqual(self.derive("parametric", "example", "--steps", steps), word + "\n")

    def test_signals(self):
        self.assertEqual(self.derive("signal", "acropetal", "-D", "STEPS=1"),
                         "Fb[+Fb]Fb[-Fa]Fa[+Fa]Fa\n")
        self.assertEqual(self.derive("signal", "acropetal"), "Fb[+Fb]Fb[-Fb]Fb[+Fa]Fa\n")
        self.assertEqual(self.derive("signal", "basipetal", "--drawn"), 
                         "age(0)F[+age(0)F]age(1)F[-age(0)F]age(1)F[+age(0)F]age(1)F\n")
        self.assertEqual(self.derive("signal", "basipetal"), "Fa[+Fa]Fb[-Fa]Fb[+Fa]Fb\n")

    def test_ages(self):
        self.assertEqual(self.derive("anabaena", "--time", "2.25"), "Bl(0.25)Ar(0.25)Ar(0.25)\n")
        self.expect(2, "derive", SCENES / "anabaena.vug", "--steps", 2)

    def test_randomness_depends_only_on_the_seed(self):
        first = self.derive("chance", "--threads", 1)
        for threads in (2, 5, 8):
            self.assertEqual(first, self.derive("chance", "--threads", threads))
        self.assertNotEqual(first, self.derive("chance", "--seed", 2))

    def test_json(self):
        said = json.loads(self.derive("koch", "--steps", 1, "--json"))
        self.assertEqual(said["symbols"], {"+": 12, "-": 15, "F": 32})
        self.assertEqual(said["modules"], 59)
        self.assertEqual(said["sha256"], hashlib.sha256(said["word"].encode()).hexdigest())
        self.assertNotIn("word", json.loads(self.derive("koch", "--json", "--count")))

    def test_underivable_systems(self):
        self.assertIn("several L-systems: plane, space",
                      self.expect(2, "derive", SCENES / "hilbert.vug").err)
        self.assertIn("did you mean 'plane'?",
                      self.expect(2, "derive", SCENES / "hilbert.vug", "plan").err)
        self.write("bomb.vug", "grammar g: lsystem {\n  limit 1000\n  steps 50\n  axiom A\n  A -> AB\n"
                               "  B -> BB\n}\n")
        self.assertIn("bomb.vug:6:3: error: grammar 'g' exceeds its limit of 1000 modules: the next "
                      "step makes", self.expect(2, "derive", "bomb.vug").err)
        self.write("nan.vug", "grammar g: lsystem {\n  axiom A(0)\n  A(x) -> A(x / x)\n}\n")
        self.assertIn("nan.vug:3:3: error: parameter 1 of module 1 of the rule of 'A(x)' is ",
                      self.expect(2, "derive", "nan.vug").err)
        self.write("ball.vug", "let a = 1\n")
        self.assertIn("no L-system", self.expect(2, "derive", "ball.vug").err)


if __name__ == "__main__":
    unittest.main()
