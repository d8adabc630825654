# SPDX-License-Identifier: Apache-2.0
"""Systems of The Algorithmic Beauty of Plants (prusinkiewicz1990), each compared with the oracle: the hash
of the whole word that `vug derive` prints after the given number of steps."""
import hashlib
import json
import math
import unittest

from lsystem_oracle import System, modules
from vug import VugTest


def plain(axiom, **rules):
    """A system whose modules have no parameters."""
    return System(axiom, [("", head, "", "", word) for head, word in rules.items()])


def line(successor, axiom="F-F-F-F"):
    return plain(axiom, F=successor)


P, C = 0.3, 1
ROW = {"p": P, "q": C - P, "h": (P * (C - P))**0.5}
HONDA = [
    ("", "A(l, w)", "", "", "!(w)F(l)[&(45deg)B(l*r2, w*wr)]/(137.5deg)A(l*r1, w*wr)"),
    ("", "B(l, w)", "", "", "!(w)F(l)[-(45deg)$C(l*r2, w*wr)]C(l*r1, w*wr)"),
    ("", "C(l, w)", "", "", "!(w)F(l)[+(45deg)$B(l*r2, w*wr)]B(l*r1, w*wr)")]

# Name: system, steps.
SYSTEMS = {
    "1.7a quadratic Koch island": (line("F+FF-FF-F-F+F+FF-F-F+F+FF+FF-F"), 3),
    "1.7b quadratic snowflake": (line("F+F-F-F+F", "-F"), 6),
    "1.8 islands and lakes": (
        plain("F+F+F+F", F="F+f-FF+F+FF+Ff+FF-f+FF-F-FF-Ff-FFF", f="ffffff"), 3),
    "1.9a": (line("FF-F-F-F-F-F+F"), 4),
    "1.9b": (line("FF-F-F-F-FF"), 4),
    "1.9c": (line("FF-F+F-F-FF"), 3),
    "1.9d": (line("FF-F--F-F"), 4),
    "1.9e": (line("F-FF--F-F"), 5),
    "1.9f": (line("F-F+F-F-F"), 4),
    "1.10a dragon": (plain("Fl", Fl="Fl+Fr+", Fr="-Fl-Fr"), 13),
    "1.10b Sierpinski gasket": (plain("Fr", Fl="Fr+Fl+Fr", Fr="Fl-Fr-Fl"), 9),
    "1.11a hexagonal Gosper": (
        plain("Fl", Fl="Fl+Fr++Fr-Fl--FlFl-Fr+", Fr="-Fl+FrFr++Fr+Fl--Fl-Fr"), 5),
    "1.11b quadratic Gosper": (
        plain("-Fr", Fl="FlFl-Fr-Fr+Fl+Fl-Fr-FrFl+Fr+FlFlFr-Fl+Fr+FlFl+Fr-FlFr-Fr-Fl+Fl+FrFr-",
              Fr="+FlFl-Fr-Fr+Fl+FlFr+Fl-FrFr-Fl-Fr+FlFrFr-Fl-FrFl+Fl+Fr-Fr-Fl+Fl+FrFr"), 3),
    "Sierpinski's square curve": (plain("F+XF+F+XF", X="XF-F+F-XF+F+XF-F+F-X"), 6),
    "Peano's curve": (
        plain("L", L="LFRFL-F-RFLFR+F+LFRFL", R="RFLFR+F+LFRFL-F-RFLFR"), 4),
    "1.2 Anabaena": (plain("Ar", Ar="AlBr", Al="BlAr", Br="Ar", Bl="Al"), 18),
    "1.8 signal to the right": (
        System("BAAAAAAAAAAAA", [("B", "A", "", "", "B"), ("", "B", "", "", "A")]), 9),
    "1.30a acropetal signal": (
        System("B[+A]A[-A]A[+A[-A]A]A", [("B", "A", "", "", "B")], ignore="+ -"), 3),
    "1.30b basipetal signal": (
        System("A[+A]A[-A]A[+A[-A]A]B", [("", "A", "B", "", "B")], ignore="+ -"), 3),
    "2L: both neighbours and their parameters": (
        System("A(8)A(1)[+A(2)A(3)]A(4)[-A(5)[+A(6)]A(7)]A(16)",
               [("A(l)", "A(x)", "A(r)", "if l != r", "A((l + 2*x + r) / 4)")], ignore="+ -"), 12),
    "signals that pass through each other": (
        System("R" + "O" * 20 + "L", [
            ("R", "O", "L", "", "X"), ("R", "O", "", "", "R"), ("", "O", "L", "", "L"),
            ("", "R", "", "", "O"), ("", "L", "", "", "O"), ("X", "O", "", "", "R"),
            ("", "O", "X", "", "L"), ("", "X", "", "", "O")]), 31),
    "1.10.1 B(2)A(4, 4)": (
        System("B(2)A(4, 4)", [
            ("", "A(x, y)", "", "if y <= 3", "A(x*2, x+y)"),
            ("", "A(x, y)", "", "if y > 3", "B(x)A(x/y, 0)"),
            ("", "B(x)", "", "if x < 1", "C"), ("", "B(x)", "", "if x >= 1", "B(x-1)")]), 40),
    "1.10.2 row of trees": (
        System("F(1)", [("", "F(x)", "", "", "F(x*p)+F(x*h)--F(x*h)+F(x*q)")], lets=ROW), 7),
    "1.10.2 row of trees with delay": (
        System("F(1, 0)", [
            ("", "F(x, t)", "", "if t == 0", "F(x*p, 2)+F(x*h, 1)--F(x*h, 1)+F(x*q, 0)"),
            ("", "F(x, t)", "", "if t > 0", "F(x, t-1)")], lets=ROW), 11),
    "1.10.3 Anabaena with heterocysts": (
        System("-(90deg)F(0, 0, CH)F(4, 1, CH)F(0, 0, CH)", [
            ("", "F(u, t, c)", "", "if t == 1 and u >= 6", "F(u/3*2, 2, c)f(1)F(u/3, 1, c)"),
            ("", "F(u, t, c)", "", "if t == 2 and u >= 6", "F(u/3, 2, c)f(1)F(u/3*2, 1, c)"),
            ("F(h, i, k)", "F(u, t, c)", "F(o, p, r)", "if u < 6 and (u > 3.9 or c > 0.4)",
             "F(u+0.1, t, c+0.25*(k+r-3*c))"),
            ("F(h, i, k)", "F(u, t, c)", "F(o, p, r)", "if u < 6 and not (u > 3.9 or c > 0.4)",
             "F(0, 0, CH)'H(1)"),
            ("", "H(u)", "", "if u < 3", "H(u*1.1)")],
               ignore="f ' H", lets={"CH": 900}), 120),
    "2.6 Honda's tree a": (System("A(1, 10)", HONDA, lets={"r1": 0.9, "r2": 0.6, "wr": 0.707}), 9),
    "3.1 cut: branches that fall off": (
        System("A", [
            ("", "A", "", "", "F(1)[-X(3)B][+X(3)B]A"), ("", "B", "", "", "F(1)B"),
            ("", "X(d)", "", "if d > 0", "X(d-1)"), ("", "X(d)", "", "if d == 0", "U%"),
            ("", "U", "", "", "F(0.3)")]), 12),
    "3.5 Mycelis, by signals up and down": (
        System("I(20)FA(0)", [
            ("S", "A(t)", "", "", "TV'"), ("V", "A(t)", "", "", "TV'"),
            ("", "A(t)", "", "if t > 0", "A(t-1)"),
            ("", "A(t)", "", "if t == 0", "[+(30deg)G]F/(180deg)A(2)"),
            ("S", "M", "", "", "S"), ("", "S", "T", "", "T"), ("T", "G", "", "", "FA(2)"),
            ("V", "M", "", "", "S"), ("", "T", "V", "", "W"), ("", "W", "", "", "V"),
            ("", "I(t)", "", "if t > 0", "I(t-1)"), ("", "I(t)", "", "if t == 0", "S")],
               consider="M S T V W"), 40),
    "3.1 tables: leaves, then flowers": (
        System("A", [("", "B", "", "", "BI")], tables={
            "leaves": [("", "A", "", "", "I[+L][-L]A"), ("", "L", "", "", "LL")],
            "flowers": [("", "A", "", "", "I[K]A"), ("", "L", "", "", "nothing")]},
               schedule="leaves*3 flowers"), 11),
    "3.13 Lychnis coronaria": (
        System("A(7)", [
            ("", "A(t)", "", "if t == 7", "FI(20)[&(60deg)L(0)]/(90deg)[&(45deg)A(0)]/(90deg)"
             "[&(60deg)L(0)]/(90deg)[&(45deg)A(4)]FI(10)K(0)"),
            ("", "A(t)", "", "if t < 7", "A(t+1)"), ("", "I(t)", "", "if t > 0", "FFI(t-1)"),
            ("", "L(t)", "", "", "L(t+1)"), ("", "K(t)", "", "", "K(t+1)")]), 40),
    "5.11 compound leaf": (
        System("A(0)", [
            ("", "A(d)", "", "if d > 0", "A(d-1)"),
            ("", "A(d)", "", "if d == 0", "F(1)[+A(1)][-A(1)]F(1)A(0)"),
            ("", "F(a)", "", "", "F(a*1.5)")]), 11),
    "decomposition to an end": (
        System("S(40)", [("", "S(n)", "", "", "S(n*1.5)")],
               decompose=[("", "S(n)", "", "if n > 30", "[S(n/2)]S(n/3)I")]), 6),
    "decomposition of a limited depth": (
        System("A", [("", "A", "", "", "B(1)[A]A"), ("", "B(n)", "", "", "A")],
               decompose=[("", "A", "", "", "B(2)A"), ("", "B(n)", "", "if n == 2", "[B(1)]")],
               depth=2), 5),
    "1.27 chance": (
        System("F", [("", "F", "", "@0.33", "F[+F]F[-F]F"), ("", "F", "", "@0.33", "F[+F]F"),
                     ("", "F", "", "@0.34", "F[-F]F")], seed=2012), 6),
    "draws in weights' rules, guards and words": (
        System("A(1)A(2)", [
            ("", "A(x)", "", "if (0..1) < 0.1", "B(x, 2..3)"),
            ("", "A(x)", "", "@2 if (0..1) < 0.9", "F(0.5..1)[+(0.1..0.7)A(x*(0.8..1))]A(x)"),
            ("", "A(x)", "", "@1", "F(x)A(0.25..0.75)"),
            ("", "B(x, y)", "", "if y > (2..3)", "A(y)")], seed=99), 12),
    "right contexts that enter branches of branches": (
        System("A[B[C]D]E", [
            ("", "A", "[B[C]D]E", "", "A[B[C]D]E"), ("", "A", "[B]", "", "FA"),
            ("", "E", "", "", "A[D][B[D][C]D]A"), ("", "B", "[C]", "", "B[C]A"),
            ("", "B", "D", "", "B[A]"), ("", "C", "", "", "CB"), ("B", "D", "", "", "DE")]), 7),
    "pipes: widths summed towards the root": (
        System("I(0)I(0)A(5)", [
            ("", "A(n)", "", "if n > 0",
             "[+(17deg)I(0)A(n-1)][-(23deg)I(0)I(0)A(n-2)]I(0)A(n-1)"),
            ("", "A(n)", "", "if n <= 0", "I(1)"),
            ("", "I(w)", "[I(a)][I(b)]I(c)", "", "I(w/2 + a + b + c)"),
            ("", "I(w)", "[I(a)]I(c)", "", "I(a + c)"), ("", "I(w)", "I(c)", "", "I(c)")],
               ignore="+ -"), 12),
    "left contexts over branch points, two deep, with numbers": (
        System("B(1)A(1)[+A(2)[-A(3)]A(4)]A(5)", [
            ("B(b) A(x)", "A(y)", "", "if x > y/2", "A(y+b)[+A(x)]"),
            ("A(x)", "A(y)", "A(z)", "if x + z > y", "A((x+z)/2)B(y)"),
            ("A(x)", "A(y)", "", "", "A(x-y)A(y)"), ("", "B(b)", "", "if b < 9", "B(b*1.5)")],
               ignore="+ -"), 9),
    "cuts by signals": (
        System("SA", [
            ("S", "A", "", "", "[+BS]SA"), ("", "S", "", "", "X"), ("X", "B", "", "", "BC"),
            ("", "B", "X", "", "F%"), ("", "C", "", "", "[D%E]S"), ("", "D", "", "", "A%A"),
            ("", "X", "", "", "XF")], ignore="+ F"), 16),
    "contexts that consider few names": (
        System("S[FA[GA]F]FA[F-A]+GA", [
            ("S", "A", "", "", "SF"), ("", "S", "", "", "[+FA]GA"), ("A", "S", "A", "", "S"),
            ("", "G", "A", "", "F[-A]S"), ("", "F", "[S]", "", "S")], consider="S A"), 13),
    "empty branches and branches of branches": (
        System("A[[B]][+[C]-A]B[]C", [
            ("A", "B", "", "", "AB"), ("", "A", "[B]", "", "C[B]A"), ("", "C", "", "", "[[A]]"),
            ("", "B", "C", "", "BC"), ("", "A", "[C]A", "", "B")], ignore="+ -"), 8),
    "tables with contexts, chance and weights by parameters": (
        System("A(3)B", [("", "L(t)", "", "if t < 5", "L(t+1)")], tables={
            "wet": [("", "A(x)", "", "@2", "I[+L(0)]A(x)B"), ("", "A(x)", "", "@x", "IA(x+1)"),
                    ("A(x)", "B", "", "", "[L(x)]B")],
            "dry": [("", "A(x)", "", "if (0..1) < 0.4", "IA(0.5..1.5)"),
                    ("", "L(t)", "", "if t >= 3", "nothing"),
                    ("", "B", "", "@1", "nothing"), ("", "B", "", "@3", "BI")]},
               schedule="wet*2 dry*3 wet dry", seed=31), 17),
    "Penrose's tiling, which forgets": (
        plain("[N]++[N]++[N]++[N]++[N]", M="OA++PA----NA[-OA----MA]++",
              N="+OA--PA[---MA--NA]+", O="-MA++NA[+++OA++PA]-", P="--OA++++MA[+PA++++NA]--NA",
              A="nothing"), 5),
    "2.7 Aono and Kunii": (
        System("A(1, 10)", [
            ("", "A(l, w)", "", "",
             "!(w)F(l)[&(10deg)B(l*r1,w*wr)]/(180deg)[&(60deg)B(l*r2,w*wr)]"),
            ("", "B(l, w)", "", "", "!(w)F(l)[+(10deg)$B(l*r1,w*wr)][-(60deg)$B(l*r2,w*wr)]")],
               lets={"r1": 0.9, "r2": 0.7, "wr": 0.707}), 8),
    "2.8 ternary branching": (
        System("!(1)F(200)/(45deg)A", [
            ("", "A", "", "", "!(vr)F(50)[&(a1)F(50)A]/(d1)[&(a1)F(50)A]/(d2)[&(a1)F(50)A]"),
            ("", "F(l)", "", "", "F(l*lr)"), ("", "!(w)", "", "", "!(w*vr)")],
               lets={"vr": 1.732, "lr": 1.109, "a1": "18.95deg", "d1": "94.74deg",
                     "d2": "132.63deg"}), 5),
    "3.5 Capsella bursa-pastoris": (
        System("I(9) a(13)", [
            ("", "a(t)", "", "if t > 0", "[&(70deg)L]/(137.5deg)I(10) a(t-1)"),
            ("", "a(t)", "", "if t == 0", "[&(70deg)L]/(137.5deg)I(10)A"),
            ("", "A", "", "", "[&(18deg) u(4)FFI(10)I(5)X(5)KKKK]/(137.5deg)I(8)A"),
            ("", "I(t)", "", "if t > 0", "FI(t-1)"), ("", "I(t)", "", "if t == 0", "F"),
            ("", "u(t)", "", "if t > 0", "&(9deg) u(t-1)"), ("", "u(t)", "", "if t == 0", "&(9deg)"),
            ("", "L", "", "", "[{.-FI(7)+FI(7)+FI(7)}][{.+FI(7)-FI(7)-FI(7)}]"),
            ("", "K", "", "", "[&{.+FI(2)--FI(2)}][&(90deg){.+FI(2)--FI(2)}]/(90deg)"),
            ("", "X(t)", "", "if t > 0", "X(t-1)"),
            ("", "X(t)", "", "if t == 0", "^(50deg)[[-ffff++[f f++f f]|[f]]%]")]), 30),
    "4.1 phyllotaxis, by roots": (
        System("A(0)", [("", "A(n)", "", "", "+(137.5deg)[f(n^0.5)D]A(n+1)")]), 60),
    "5.6 cordate leaf: polygons that end beyond their branch": (
        plain("[A][B]", A="[+A{.].C.}", B="[-B{.].C.}", C="GC"), 12),
    "5.8 simple leaf, with a parameter called like a unit": (
        System("{.A(0)}", [
            ("", "A(t)", "", "", "G(LA,RA)[-B(t).][A(t+1)][+B(t).]"),
            ("", "B(t)", "", "if t > 0", "G(LB,RB)B(t-PD)"),
            ("", "G(s, r)", "", "if r > 1", "G(s*r, r)")],
               lets={"LA": 5, "RA": 1.15, "LB": 1.3, "RB": 1.25, "PD": 0.25}), 9),
    "Lindenmayer's alga": (
        plain("A", A="B[C]", C="B[+D]", D="E[-C]G", E="D", G="F[A]"), 14),
    "rule 110": (
        System("O" * 25 + "IX", [
            (l, c, r, "", n) for l, c, r, n in (
                "IIIO", "IOOO", "OOOO", "IOII", "OIOO", "OOII", "IIOI", "OIII", "OIXI", "IIXI",
                "IOXO")]), 24),
}


class Classics(VugTest):
    def derive(self, text, *args):
        self.write("s.vug", text)
        return self.expect(0, "derive", "s.vug", *args).out

    def test_words_by_hash(self):
        for name, (system, steps) in SYSTEMS.items():
            with self.subTest(name):
                word = system.derived(steps)
                self.assertGreater(len(word), 12)
                said = self.derive(system.text(), "--steps", steps, "--hash").strip()
                if said != hashlib.sha256(word.encode()).hexdigest():
                    for step in range(steps + 1):  # the first step that differs gives a shorter message
                        self.assertEqual(self.derive(system.text(), "--steps", step).strip(),
                                         system.derived(step), step)

    def test_anabaena_grows_evenly(self):
        """Section 6.1: equals, at any time, a simulation of cells that divide one by one."""
        rules = {"Ar": ("Al", "Br"), "Al": ("Bl", "Ar"), "Br": ("Ar",), "Bl": ("Al",)}

        def grown(name, age):
            if age < 1:
                return [f"{name}({repr(age).removesuffix('.0')})"]
            return [cell for made in rules[name] for cell in grown(made, age - 1)]
        text = "grammar g: lsystem {\n  axiom Ar(0)\n" + "".join(
            f"  {name}(t) after 1 -> {''.join(made + '(0)' for made in word)}\n"
            for name, word in rules.items()) + "}\n"
        for time in (0.25, 3.0, 7.5, 15.875):
            self.assertEqual(self.derive(text, "--time", time).strip(), "".join(grown("Ar", time)))

    def test_counts_equal_those_of_matrices(self):
        """Counts without rewriting, by the matrix of the number of letters that each rule produces."""
        for name in ("1.9a", "1.10a dragon", "1.11b quadratic Gosper", "1.2 Anabaena"):
            system, steps = SYSTEMS[name]
            makes = {rule.name: [made for made, _ in rule.word] for rule in system.rows}
            counts = {}
            for made, _ in modules(system.axiom):
                counts[made] = counts.get(made, 0) + 1
            for _ in range(steps):
                after = {}
                for letter, count in counts.items():
                    for made in makes.get(letter, [letter]):
                        after[made] = after.get(made, 0) + count
                counts = after
            said = json.loads(self.derive(system.text(), "--steps", steps, "--count", "--json"))
            self.assertEqual(said["symbols"], dict(sorted(counts.items())))

    def test_numbers_are_printed_in_the_fewest_digits(self):
        numbers = [0.1, 1e-5, 0.0001, 1e15, 1e16, 1e17, 123456789012345680.0, 1 / 3, -2.5, 5e-324,
                   math.pi, 1e22, 1e100]
        text = "grammar g: lsystem {\n  axiom " + "".join(f"A({n!r})" for n in numbers) + "\n}\n"
        self.assertEqual(self.derive(text).strip(),
                         "".join(f"A({repr(n).removesuffix('.0')})" for n in numbers))


if __name__ == "__main__":
    unittest.main()
