# SPDX-License-Identifier: GPL-3.0-or-later
# As read_back.py, of equations, as the file has them and expanded: both sides in LaTeX have the values that the
# JSON gives them. Usage: python3 read_equations.py, beside equations.latex, equations.json, expand.latex and
# expand.json; prints what differs.
import json
import re

import mpmath
from read_back import ELEMENTARY, Point, at_a_point, differ, key, notation, set_names_apart
from read_latex import sections, sides


def functions_in(text):
    return set(re.findall(r"\b([A-Za-z]\w*)'*\(", text)) - {*ELEMENTARY, "Derivative", "Subs", "_u"}


def as_written(text):
    """What the user writes, omega''(2*tau)*psi'^2, in the notation of the reader of LaTeX."""
    text = re.sub(r"([A-Za-z]\w*)('*)\(",
                  lambda m: m[0] if m[1] in ELEMENTARY else f"of({m[1]}, {len(m[2])})(", text)
    return notation(text.replace("^", "**").replace("of(", "of_(")).replace("of(", "along(")


class Documents:
    """Equations, as written and expanded; a point has the value of every rate that an equation tells."""

    def __init__(self, written, expanded):
        set_names_apart(written + expanded)
        self.written, self.expanded = json.loads(written), json.loads(expanded)
        self.functions = set(map(key, functions_in(" ".join(
            [v["equation"] for v in self.written["variables"]] + [r["value"] for r in self.written["relations"]]))))
        self.roles = {v["name"]: v["role"] for v in self.written["variables"]}
        self.equilibrium = self.written.get("equilibrium", {})

    def point(self, seed):
        relations = {key(r["parameter"]): as_written(r["value"]) for r in self.written["relations"]}
        point = Point(seed, relations, self.functions)
        point["along"] = lambda f, order: lambda argument: f(argument, order)
        return point

    def series(self, equation, point):
        total = mpmath.mpf(0)
        for term in equation["terms"]:
            product = point.value(notation(term["coefficient"]))
            for name, exponent in term["exponents"].items():
                base = point[key(name)]
                angle = self.roles.get(name.rstrip("'")) == "angle" and "'" not in name
                product *= (mpmath.exp(mpmath.mpc(0, base*exponent)) if angle
                            else base**point.value(str(exponent)))
            total += product
        return total

    def measured(self, name):
        return "delta_" + name if name in self.equilibrium else name


def difference(text):
    left, right = text.split("=")
    return f"({as_written(left)}) - ({as_written(right)})"


def faults_as_written(latex, documents, point):
    written = documents.written
    told = {"": [v["equation"] for v in written["variables"]],
            "relations": [f"{r['parameter']} = {r['value']}" for r in written["relations"]]}
    if change := written.get("change"):
        told["before the change of variables"] = [e["equation"] for e in change["equations"]]
        told["change of variables"] = [f"{name} = {value}" for name, value in change["values"].items()]
    found = dict(sections(latex))
    shifted = found.pop("about the equilibrium at eps = 0", [])
    for heading, equations in told.items():
        lines = found.pop(heading, [])
        if len(lines) != len(equations):
            yield f"LaTeX, {heading or 'equations'}: {len(lines)} equations of {len(equations)}"
        for line, equation in zip(lines, equations):
            left, right, _ = sides(line, documents.functions)
            if differ(point.value(left) - point.value(right), point.value(difference(equation))):
                yield f"LaTeX, {heading or 'equations'}: {line}"
    yield from (f"LaTeX: {heading} are not told by the JSON" for heading in found)
    yield from faults_about_equilibrium(shifted, documents, point)


def faults_about_equilibrium(lines, documents, point):
    """c = s/(kappa + s) + delta_c, and rates with which the equations as written hold. All are of first order."""
    read = [sides(line, documents.functions) for line in lines]
    values = [(key(name), as_written(value) + " + " + key("delta_" + name))
              for name, value in documents.equilibrium.items()]
    yield from (f"LaTeX, the equilibrium: {line}" for line, (left, right, _), (name, value) in zip(lines, read, values)
                if left != name or differ(point.value(right), point.value(value)))
    point = documents.point(point.seed)
    point.definitions = {**point.definitions, **dict(values)}
    rates = {}
    for equation in documents.written["variables"]:
        left, right = equation["equation"].split("=")
        rates[key(left.strip())] = as_written(right)
    rates = {**{name: rate for name, rate in rates.items() if name.endswith("_dot")},
             **{left: right for left, right, _ in read[len(values):]}}
    moving = {name.removesuffix("_dot"): point.value(rate) for name, rate in rates.items()
              if name.removesuffix("_dot") not in point.definitions}
    along = lambda s: point.moved({name: point[name] + s*rate for name, rate in moving.items()})
    for equation in documents.written["variables"] if documents.equilibrium else []:
        name = key(equation["name"])
        point[name + "_dot"] = mpmath.diff(lambda s: along(s).value(point.definitions.get(name, name)), 0)
        if differ(point.value(difference(equation["equation"])), 0):
            yield f"LaTeX, about the equilibrium: {equation['name']} does not move as its equation says"


def expand_faults(latex, documents, point):
    rates = {}
    for equation in documents.expanded["equations"]:
        if equation["form"] == "rate = series":
            rates[equation["variable"]] = documents.series(equation, point)
            point[key(documents.measured(equation["variable"])) + "_dot"] = rates[equation["variable"]]
    found = dict(sections(latex))
    for heading in found:
        yield from faults_of_section(heading, found[heading], documents, rates, point)


def faults_of_section(heading, lines, documents, rates, point):
    equations = documents.expanded["equations"]
    if len(lines) < len(equations):
        yield f"LaTeX, expanded: {len(lines)} equations of {len(equations)}"
    read = [sides(line, documents.functions) for line in lines]
    point = point.moved({})
    point.definitions = {**point.definitions, **{left: right for left, right, _ in read if re.fullmatch(r"\w+", left)}}
    along = lambda s: point.moved({"t": point["t"] + s, **{key(n): point[key(n)] + s*r for n, r in rates.items()}})
    for line, (left, right, weight), equation in zip(lines, read, equations):
        told = documents.series(equation, point)
        if equation["form"] == "series = 0":
            same = not differ(point.value(left) - point.value(right), told)
        else:
            name = left.removesuffix("_dot")
            if name in point.definitions:  # X = x - ..., without the known drift
                told = mpmath.diff(lambda s: along(s).value(point.definitions[name]), 0)
            same = not differ(point.value(right), told)
        if not same or (equation["next_weight"] is not None and weight != str(equation["next_weight"])):
            yield f"LaTeX, expanded{heading and ', ' + heading}: {line}"
    for name, value in documents.equilibrium.items():
        right = point.definitions.get(key(name))
        if right is None or differ(point.value(right),
                                   point.value(as_written(value)) + point[key("delta_" + name)]):
            yield f"LaTeX, expanded: the equilibrium of {name}"


def texts(stage):
    return [open(f"{stage}.{format}").read() for format in ("latex", "json")]


if __name__ == "__main__":
    (latex, written), (latex_expanded, expanded) = texts("equations"), texts("expand")
    documents = Documents(written, expanded)
    found = at_a_point(lambda seed: [*faults_as_written(latex, documents, documents.point(seed)),
                                     *expand_faults(latex_expanded, documents, documents.point(seed))])
    print("\n".join(found) or "equal")
