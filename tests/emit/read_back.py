# SPDX-License-Identifier: GPL-3.0-or-later
# What `derive` prints as LaTeX and as a Maxima script, against its JSON: every equation has the same value at
# a random point. Usage: python3 read_back.py, beside out.latex, out.json and perhaps out.maxima; prints what
# differs. With --plant it changes each sign in turn, and prints the changes that it does not see.
import json
import os
import random
import re
import sys

import mpmath
from read_latex import sections, sides

mpmath.mp.dps = 40
mpmath.mp.trap_complex = True  # a root or logarithm of a negative number: another point is drawn

ELEMENTARY = {name: getattr(mpmath, name) for name in
              "sin cos tan exp log sqrt sinh cosh tanh asin acos atan asinh acosh atanh erf re im conj".split()}


APART = set()  # names beside others that LaTeX would print alike


def key(name):
    return name.replace("_", "_sub_" if name.rstrip("'") in APART else "").replace("'", "_dot")


def set_names_apart(document):
    names = sorted(set(re.findall(r"[A-Za-z]\w*", document)), key=lambda name: name.count("_"))
    APART.update(name for at, name in enumerate(names)
                 if name.replace("_", "") in (other.replace("_", "") for other in names[:at]))


def notation(expression):
    """An expression of the JSON with names as the reader of LaTeX has them."""
    text = re.sub(r"Derivative\((\w+)\((\w+)\), (?:\2|\(\2, (\d+)\))\)",
                  lambda m: f"derivative({m[1]}, {m[3] or 1}, {m[2]})", expression)
    text = re.sub(r"Subs\((derivative\(\w+, \d+, )_u\), _u, ", r"\1", text)
    return re.sub(r"[A-Za-z]\w*'*", lambda m: m[0] if m[0] in (*ELEMENTARY, "derivative") else key(m[0]), text)


def from_maxima(expression):
    text = re.sub(r"'diff\((\w+)\((\w+)\), \2, (\d+)\)", r"derivative(\1, \3, \2)", expression)
    text = re.sub(r"at\((derivative\(\w+, \d+, )u_\), u_ = ", r"\1", text)
    return notation(text.replace("%i", "I").replace("%pi", "pi").replace("^", "**"))


class Named:
    """Some smooth positive function in place of one that is known by its name only."""

    def __init__(self, name):
        self.speed = 1 + mpmath.mpf(sum(map(ord, name)) % 7) / 8

    def __call__(self, argument, order=0):
        wave = mpmath.sin(self.speed*argument + order*mpmath.pi/2)*self.speed**order
        return wave + (2 if order == 0 else 0)


class Point(dict):
    """Values by name; a name that has none is defined by an equation, or has a random value."""

    def __init__(self, seed, definitions, functions):
        super().__init__(ELEMENTARY, I=mpmath.mpc(0, 1), pi=mpmath.pi, mpf=mpmath.mpf,
                         derivative=lambda f, order, at: f(at, order), **{f: Named(f) for f in functions})
        self.seed, self.definitions = seed, definitions

    def __missing__(self, name):
        if name in self.definitions:
            return self.value(self.definitions[name])
        self[name] = self.number(name)
        return self[name]

    def number(self, name):
        return mpmath.mpf(random.Random(f"{name} {self.seed}").randint(3, 25))/8

    def value(self, expression):
        return eval(re.sub(r"(?<![\w.'])\d+(?:\.\d+)?(?:e[-+]?\d+)?", r"mpf('\g<0>')", expression), {}, self)

    def moved(self, changes):
        other = Point(self.seed, self.definitions, ())
        other.update(self, **changes)
        return other


class Answer:
    """The JSON of a normal form; sums of its terms at a point."""

    def __init__(self, document):
        self.document = document
        self.conjugates = {key(f["name"]): key(f["conjugate"]) for f in document["fast"]}
        self.fast = {*self.conjugates, *self.conjugates.values()}
        self.definitions = {key(f["name"]): f["definition"].split(", ") for f in document["fast"]}
        self.frequencies = {key(name): notation(value) for d in self.definitions.values()
                            for name, value in (part.split(" = ") for part in d[1:])}
        self.variables = list(dict.fromkeys(t["variable"] for t in document["normal_form"] + document["map"]))
        self.functions = set(re.findall(r"\b([A-Za-z]\w*)\(", json.dumps(document["normal_form"]))) - {
            *ELEMENTARY, "Derivative", "Subs"}

    def is_angle(self, name):  # in exponents
        return name not in self.fast and name != "eps"

    def sum(self, terms, point):
        total = mpmath.mpf(0)
        for term in terms:
            product = point.value(notation(term["coefficient"]))
            for name, exponent in term["exponents"].items():
                base = point[key(name)]
                product *= (mpmath.exp(mpmath.mpc(0, base*exponent)) if self.is_angle(key(name))
                            else base**point.value(str(exponent)))
            total += product
        return total

    def of(self, part, name, point):
        return self.sum([t for t in self.document[part] if key(t["variable"]) == name], point)

    def old_fast(self, name, point):
        return point.moved({n: point.value(v) for n, v in self.frequencies.items()}).value(
            notation(self.definitions[name][0]))

    def first_weight(self, name):
        return min((str(t["weight"]) for t in self.document["map"] if key(t["variable"]) == name),
                   key=lambda w: eval(w), default=None)


class Page:
    """The equations of the LaTeX document by their section, each compared with the JSON at a point."""

    def __init__(self, latex, answer):
        self.answer = answer
        self.equations = [(heading, text, *sides(text, set(map(key, answer.functions))))
                          for heading, equations in sections(latex) for text in equations]
        self.definitions = {left: right for heading, _, left, right, _ in self.equations
                            if heading == "where" and re.fullmatch(r"\w+", left) and left not in answer.fast}

    def point(self, seed):
        answer = self.answer
        point = Point(seed, self.definitions, map(key, answer.functions))
        for name, conjugate in answer.conjugates.items():
            if conjugate != name:
                point[name] = mpmath.mpc(point.number(name), point.number(conjugate))
                point[conjugate] = point[name].conjugate()
        for action in answer.document.get("hamiltonian", {}).get("actions", []):
            pair = point[key(action["left"])]*point[key(action["right"])]
            point[key(action["name"])] = pair/point.value(notation(action["product"]))
        self.rates = {n: answer.of("normal_form", n, point) for n in map(key, answer.variables)}
        point.update({n + "_dot": rate for n, rate in self.rates.items() if n not in answer.fast})
        old = {n: point[n] + answer.of("map", n, point) for n in map(key, answer.variables) if n not in answer.fast}
        self.old = point.moved({**old, **{n + "_old": value for n, value in old.items()}})
        return point

    def rate(self, name, point):
        answer = self.answer
        if name in answer.conjugates:
            return self.rates.get(name, 0)
        if name in answer.fast:
            return next(self.rates[n] for n, c in answer.conjugates.items() if c == name).conjugate()
        if name not in self.definitions:
            return self.rates.get(name, 0)
        along = lambda s: point.moved({n: point[n] + s*r for n, r in self.rates.items() if n not in answer.fast})
        return mpmath.diff(lambda s: along(s).value(name), 0)

    def compared(self, heading, left, right, point):
        """Two values that are equal if the equation is right; of some both sides have a second value."""
        answer = self.answer
        if heading == "":
            yield self.rate(left.removesuffix("_dot"), point), point.value(right)
        elif heading == "near-identity map":
            name = re.match(r"\w+", right)[0]
            if name in answer.fast:
                yield answer.old_fast(name, point), point.value(left)
                yield point[name] + answer.of("map", name, point), point.value(right)
            else:
                yield self.old.value(left), point.value(right)
        elif heading == "where" and left in answer.conjugates:
            yield answer.old_fast(left, point), point.value(right)
        elif heading == "where" and left in answer.frequencies:
            yield point.value(answer.frequencies[left]), point.value(right)
        elif heading == "energy in real invariants":
            yield answer.sum(answer.document["hamiltonian"]["energy"], point), point.value(right)
        elif heading.startswith("equilibrium"):
            yield point.value(notation(answer.document["equilibrium"][left])), point.value(right)
        else:
            yield point.value(left), point.value(right)

    def missing(self):
        answer = self.answer
        for heading, expected in (("", answer.fast | set(map(key, answer.variables))),
                                  ("near-identity map", {t["variable"] for t in answer.document["map"]})):
            found = sum(h == heading for h, *_ in self.equations)
            if found < len(expected):
                yield f"LaTeX, {heading or 'rates'}: {found} equations, expected: {sorted(expected)}"

    def faults(self, point):
        yield from self.missing()
        for heading, text, left, right, weight in self.equations:
            if any(differ(a, b) for a, b in self.compared(heading, left, right, point)):
                yield f"LaTeX, {heading or 'rates'}: {text}"
            expected = self.answer.first_weight(left)
            if left in self.answer.fast and weight and expected and weight != expected:
                yield f"LaTeX, O(eps^{expected}) expected: {text}"


def differ(a, b):
    return abs(a - b) > mpmath.mpf(10)**-15*(1 + abs(b))


def maxima_faults(script, answer, point):
    script = re.sub(r"/\*.*?\*/|assume\([^$]*\)\$", "", script, flags=re.S)
    statements = [re.fullmatch(r"(\w+)\[(\w+)\] : (.*)", s.strip()) for s in script.split("$") if s.strip()]
    parts = {"rate": "normal_form", "old_minus_new": "map"} if script else {}
    for s in statements:
        if differ(answer.of(parts[s[1]], key(s[2]), point), point.value(from_maxima(s[3]))):
            yield f"Maxima: {s[0]}"
    for part in parts:
        told = {key(s[2]) for s in statements if s[1] == part}
        missing = {t["variable"] for t in answer.document[parts[part]] if key(t["variable"]) not in told}
        yield from (f"Maxima: no {part} of {v}" for v in sorted(missing))


def at_a_point(faults_at):
    """What is found with the first seed whose point makes all roots and logarithms real."""
    for seed in range(100):
        try:
            return [*faults_at(seed)]
        except (mpmath.libmp.ComplexResult, ZeroDivisionError):
            pass
    return ["no point where everything is real was found"]


def faults(latex, maxima, document):
    """The equations and statements that differ."""
    set_names_apart(document)
    answer = Answer(json.loads(document))
    page = Page(latex, answer)

    def faults_at(seed):
        point = page.point(seed)
        return [*page.faults(point), *maxima_faults(maxima, answer, point)]

    return at_a_point(faults_at)


def unseen_plants(latex, maxima, document):
    """Both texts with one sign changed, which is not found; how many signs there are."""
    unseen, count = [], 0
    both = latex + "\0" + maxima
    formulas = re.sub("^%.*", lambda comment: "%"*len(comment[0]), both, flags=re.M)
    for sign in re.finditer(r"(?<= )[-+](?= (?!O))|(?<=[=:] )-", formulas):
        lie = both[:sign.start()] + {"-": "+", "+": "-"}[sign[0]] + both[sign.end():]
        count += 1
        if not faults(*lie.split("\0"), document):
            unseen.append(lie[max(0, sign.start() - 40):sign.end() + 40])
    return unseen, count


if __name__ == "__main__":
    texts = [open(name).read() if os.path.exists(name) else "" for name in ("out.latex", "out.maxima", "out.json")]
    if "--plant" in sys.argv:
        unseen, count = unseen_plants(*texts)
        print("\n".join(unseen) if unseen else f"{count} found")
    else:
        print("\n".join(faults(*texts)) or "equal")
