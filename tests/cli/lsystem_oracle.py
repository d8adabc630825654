# SPDX-License-Identifier: Apache-2.0
"""A slow and simple rewriter of L-systems in Python, with which `vug derive` is compared.

It follows the book and docs/reference/lsystems.md, not the program. A system's rules are rows of text,
from which both the scene's block and the words here are derived:
    (left, head, right, clauses, successor)
where clauses are "if ...", "@..." or nothing.
"""
import math
import re

MODULE = re.compile(r"\s*(\?\w+|F(?=f+(?![a-z0-9_]))|[A-Z][a-z0-9_]*|[a-z]|[-+&^\\/|$!'\[\]{}.%])")
MASK = 2**32 - 1
DEGREES = re.compile(r"([\d.]+)deg")
METRES = re.compile(r"([\d.]+)m\b")
DRAW = re.compile(r"([\d.]*\d)\.\.([\d.]+)")


def philox(counter, key):
    """Philox4x32-10, as described in its paper (salmon2011philox)."""
    a, b, c, d = counter
    k, m = key
    for _ in range(10):
        p, q = 0xD2511F53 * a, 0xCD9E8D57 * c
        a, b, c, d = (q >> 32) ^ b ^ k, q & MASK, (p >> 32) ^ d ^ m, p & MASK
        k, m = (k + 0x9E3779B9) & MASK, (m + 0xBB67AE85) & MASK
    return a, b, c, d


def halves(x):
    return x & MASK, x >> 32 & MASK


def mixed(state, word, tag):
    out = philox((*halves(word), tag, 0x766D6978), halves(state))
    return out[0] | out[1] << 32


def named(state, name):
    """The key derived from a key and a name."""
    data = name.encode()
    for i in range(0, len(data), 8):
        state = mixed(state, int.from_bytes(data[i:i + 8], "little"), 1)
    return mixed(state, len(data), 2)


def child(key, place):
    """The key of the module at a position (from 1) of a successor: Splitmix (steele2014splitmix)."""
    z = (key + 0x9E3779B97F4A7C15 * (place + 1)) % 2**64
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9 % 2**64
    z = (z ^ z >> 27) * 0x94D049BB133111EB % 2**64
    return z ^ z >> 31


def number_of(key, system_key, number):
    bits = philox((*halves(key), number // 2, 0), halves(system_key))[number % 2 * 2:]
    return (bits[0] << 20 | bits[1] >> 12) * 2.0**-52


def closing(text, at):
    depth = 0
    for i in range(at, len(text)):
        depth += {"(": 1, ")": -1}.get(text[i], 0)
        if depth == 0:
            return i
    raise ValueError(text)


def commas(text):
    parts, depth = [""], 0
    for letter in text:
        depth += {"(": 1, ")": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def modules(text):
    """[(name, [texts of arguments])]"""
    out, at = [], 0
    text = text.strip()
    while at < len(text):
        match = MODULE.match(text, at)
        at = match.end()
        arguments = []
        if at < len(text) and text[at] == "(":
            end = closing(text, at)
            arguments = commas(text[at + 1:end])
            at = end + 1
        out.append((match.group(1), arguments))
        while at < len(text) and text[at] == " ":
            at += 1
    return out


def python(text):
    text = DEGREES.sub(lambda m: f"({m.group(1)} * pi / 180)", text)
    text = METRES.sub(r"\1", text)
    return DRAW.sub(r"draw(\1, \2)", text).replace("^", "**")


def printed(word):
    out = []
    for name, values in word:
        out.append(name)
        if values:
            out.append("(" + ",".join(repr(float(v)).removesuffix(".0") for v in values) + ")")
    return "".join(out)


def closing_bracket(word, at):
    depth = 0
    for i in range(at, len(word)):
        depth += {"[": 1, "]": -1}.get(word[i][0], 0)
        if depth == 0:
            return i
    raise ValueError(word)


class Rule:
    def __init__(self, left, head, right, clauses, successor):
        self.left, self.right = modules(left), modules(right)
        (self.name, self.formals), = modules(head)
        self.weight = re.search(r"@(\S+)", clauses)
        guard = re.search(r"if (.*)", clauses)
        self.guard = compile(python(guard.group(1)), "guard", "eval") if guard else None
        self.draws = len(DRAW.findall(guard.group(1))) if guard else 0
        self.word = [] if successor == "nothing" else [
            (name, [compile(python(a), "value", "eval") for a in arguments])
            for name, arguments in modules(successor)]
        self.text = (f"{left + ' < ' if left else ''}{head}{' > ' + right if right else ''} "
                     f"{clauses} -> {successor}")


class Around:
    """The neighbours of modules in a word with branches: the module before and behind each one."""

    def __init__(self, word, unseen):
        self.word, self.before, self.behind, self.unseen = word, {}, {}, unseen
        last, waiting, stack = None, [], []
        for i, (name, _) in enumerate(word):
            if name == "[":
                stack.append((last, waiting))
                waiting = []
            elif name == "]":
                last, waiting = stack.pop()
            else:
                self.before[i] = last
                waiting.append(i)
                if name not in unseen:
                    self.behind.update((one, i) for one in waiting[:-1])
                    last, waiting = i, [i]

    def fits(self, at, wanted):
        return (at is not None and self.word[at][0] == wanted[0]
                and len(self.word[at][1]) == len(wanted[1]))

    def left(self, at, wanted, env):
        for one in reversed(wanted):
            at = self.before[at]
            if not self.fits(at, one):
                return False
            env.update(zip(one[1], self.word[at][1]))
        return True

    def right(self, at, wanted, env):
        """Matches the branches of the pattern in order, each with the first side branch that fits."""
        after = at + 1  # where the next side branch may begin
        while wanted:
            if wanted[0][0] == "[":
                end = closing_bracket(wanted, 0)
                after = self.entered(after, wanted[1:end], env)
                if after is None:
                    return False
                wanted = wanted[end + 1:]
                continue
            at = self.behind.get(at)
            if not self.fits(at, wanted[0]):
                return False
            env.update(zip(wanted[0][1], self.word[at][1]))
            after, wanted = at + 1, wanted[1:]
        return True

    def entered(self, at, wanted, env):
        """The position after the first side branch from `at` on that begins with `wanted`, or None."""
        while at < len(self.word):
            name = self.word[at][0]
            if name == "[":
                inner, trial = Around(self.word[at + 1:closing_bracket(self.word, at)], self.unseen), {}
                inner.before_first()
                if inner.right(-1, wanted, trial):
                    env.update(trial)
                    return closing_bracket(self.word, at) + 1
                at = closing_bracket(self.word, at)
            elif name == "]" or name not in self.unseen:
                return None
            at += 1
        return None

    def before_first(self):
        """Makes -1 the position before the word's first module."""
        depth = 0
        for i, (name, _) in enumerate(self.word):
            if name not in self.unseen and name not in "[]" and depth == 0:
                self.behind[-1] = i
                return
            depth += {"[": 1, "]": -1}.get(name, 0)


class System:
    """An L-system. tables: {name: rows} with a schedule of names; lets: numbers that rules use."""

    def __init__(self, axiom, rows, ignore="", consider="", lets=(), seed=7, tables=(),
                 schedule="", decompose=(), depth=None):
        self.axiom, self.rows = axiom, [Rule(*row) for row in rows]
        self.ignore, self.consider = ignore.split(), consider.split()
        self.written, self.lets = dict(lets), {
            name: eval(python(value), {"pi": math.pi}) if isinstance(value, str) else value
            for name, value in dict(lets).items()}
        self.tables = {name: [Rule(*row) for row in rows] for name, rows in dict(tables).items()}
        self.schedule, self.seed = schedule.split(), seed
        self.parts, self.depth = [Rule(*row) for row in decompose], depth
        every = self.rows + [rule for rules in self.tables.values() for rule in rules] + self.parts
        self.random = any(rule.weight or DRAW.search(rule.text) for rule in every)
        self.key = named(named(seed, "grammar"), "g")
        self.names = {name for name, _ in modules(axiom)} | {
            name for rule in every for name, _ in rule.word}

    def text(self):
        """The text of the scene."""
        lines = [f"let {name} = {value}" for name, value in self.written.items()]
        lines += ["grammar g: lsystem {", f"  seed {self.seed}", f"  axiom {self.axiom}"]
        for word, names in (("ignore", self.ignore), ("consider", self.consider),
                            ("schedule", self.schedule)):
            if names:
                lines.append(f"  {word} {' '.join(names)}")
        lines += ["  " + rule.text for rule in self.rows]
        for name, rules in self.tables.items():
            lines += [f"  table {name} {{"] + ["    " + rule.text for rule in rules] + ["  }"]
        if self.parts:
            lines += ["  decompose {"] + [f"    depth {self.depth}"] * (self.depth is not None)
            lines += ["    " + rule.text for rule in self.parts] + ["  }"]
        return "\n".join(lines + ["}", ""])

    def env(self, values=()):
        return {"pi": math.pi, "sqrt": math.sqrt, **self.lets, **dict(values)}

    def step(self, word, keys, rules, waits=True):
        """The next word; a module without a rule is kept."""
        unseen = {name for name in self.names if name in self.ignore
                  or (self.consider and name not in self.consider)}
        around = Around(word, unseen)
        by_head = {}
        for rule in sorted(rules, key=lambda r: not (r.left or r.right)):
            by_head.setdefault((rule.name, len(rule.formals)), []).append(rule)
        out, out_keys = [], []
        for i, (name, values) in enumerate(word):
            tried = by_head.get((name, len(values)), [])
            chosen, env = self.chosen(tried, around, i, keys[i])
            if chosen is None:
                out.append((name, values))
                out_keys.append(child(keys[i], 0) if tried and waits else keys[i])
                continue
            count = sum(rule.draws for rule in tried)
            env["draw"] = self.drawing(keys[i], count)
            out += [(name, [eval(code, env) for code in codes]) for name, codes in chosen.word]
            out_keys += [child(keys[i], place + 1) for place in range(len(chosen.word))]
        return out, out_keys

    def drawing(self, key, last):
        def draw(low, high):
            nonlocal last
            last += 1
            return low + (high - low) * number_of(key, self.key, last)
        return draw

    def chosen(self, rules, around, at, key):
        lots, drawn = [], 0
        for rule in sorted(rules, key=self.rank):
            rule.first, drawn = drawn, drawn + rule.draws
        for rule in rules:
            env = self.env(zip(rule.formals, around.word[at][1]))
            env["draw"] = self.drawing(key, rule.first)
            fits = ((not rule.left or around.left(at, rule.left, env))
                    and (not rule.right or around.right(at, rule.right, env))
                    and (rule.guard is None or eval(rule.guard, env)))
            if not fits or (lots and not rule.weight):
                continue
            if not rule.weight:
                return rule, env
            lots.append((float(eval(rule.weight.group(1), env)), rule, env))
        dart = sum(lot[0] for lot in lots) * number_of(key, self.key, 0) if lots else 0
        total = 0
        for weight, rule, env in lots:
            total += weight
            if dart < total:
                return rule, env
        return None, None

    def rank(self, rule):
        return self.rows.index(rule) if rule in self.rows else -1

    def decomposed(self, word, keys):
        rounds = 0
        heads = {(rule.name, len(rule.formals)) for rule in self.parts}
        while self.depth is None or rounds < self.depth:
            before = word
            word, keys = self.step(word, keys, self.parts, waits=False)
            rounds += 1
            if word == before or not heads & {(name, len(values)) for name, values in word}:
                break
        return word, keys

    def cut(self, word, keys):
        out, gone = [], None
        depth = 0
        for module, key in zip(word, keys):
            if module[0] == "]":
                depth -= 1
                if gone is not None and depth < gone:
                    gone = None
            if gone is None and module[0] == "%":
                gone = depth
            if gone is None:
                out.append((module, key))
            depth += module[0] == "["
        return [m for m, _ in out], [k for _, k in out]

    def derived(self, steps):
        env = self.env()
        word = [(name, [eval(python(a), env) for a in arguments])
                for name, arguments in modules(self.axiom)]
        keys = [child(self.key, place + 1) for place in range(len(word))]
        if self.parts:
            word, keys = self.decomposed(word, keys)
        for step in range(steps):
            rules = list(self.rows)
            if self.schedule:
                turns = [turn.split("*") for turn in self.schedule]
                order = [turn[0] for turn in turns for _ in range(int((turn + ["1"])[1]))]
                rules = self.tables[order[step % len(order)]] + rules
            word, keys = self.cut(word, keys)
            word, keys = self.step(word, keys, rules)
            if self.parts:
                word, keys = self.decomposed(word, keys)
        return printed(word)
