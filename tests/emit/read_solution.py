# SPDX-License-Identifier: GPL-3.0-or-later
# As read_back.py, of a solution as LaTeX: frame, slow flow and outputs have the values that the JSON gives them.
# Usage: python3 read_solution.py, beside out.latex, out.json and out.normal_form, the JSON of the normal form.
import json
import re

import mpmath
from read_back import Answer, Point, at_a_point, differ, key, notation
from read_latex import sections, sides


class Solution(Answer):
    def __init__(self, document):
        self.document = document
        self.flow = {key(f["variable"]): f for f in document.get("flow", [])}
        self.outputs = {key(o["name"]): o["terms"] for o in document["outputs"]}
        self.rates = [notation(f["rate"]) for f in document.get("frame", [])]

    def is_angle(self, name):
        return self.flow.get(name, {}).get("role") == "angle"

    def series(self, terms, point):
        return sum(point["eps"]**point.value(str(t["eps"]))*point.value(notation(t["coefficient"])) for t in terms)

    def amplitude(self, mode, point):
        return (point["eps"]*point[key(mode["amplitude"])]*point.value(notation(mode["envelope"])) *
                self.series(mode["factor"], point))

    def phase(self, mode, point):  # as if its rate were constant
        return point[key(mode["phase"])] + point["t"]*self.series(mode["phase_rate"], point)

    def rate_of_mode(self, normal_form, point):
        """Of z1 = Delta*exp(I*theta) at theta = 0: Delta' + I*Delta*theta'."""
        assert normal_form.document["order"] >= self.document["truncation"]
        rates = {key(s["variable"]) + "_dot": point["eps"]*(point.value(notation(s["rate"])) -
                 self.decline(s, point)*point[key(s["variable"])]) for s in self.document["slow"]}
        point.update(rates, z1=point["Delta"], z2=point["Delta"])
        return mpmath.mpc(normal_form.sum([t for t in normal_form.document["normal_form"]
                                           if t["variable"] == "z1" and t["weight"] <= self.document["truncation"]],
                                          point))

    def decline(self, law, point):
        return point.value(notation(law["decline"])) if "decline" in law else 0

    def slow(self, name, point):
        law = next((s for s in self.document["slow"] if key(s["variable"]) == name), None)
        if law is None:  # T
            return point["eps"]*point["t"]
        rate, decline = point.value(notation(law["rate"])), self.decline(law, point)
        return path(point[key(law["start"])], rate, decline, point["eps"]*point["t"])

    def slow_in_flow(self, name, point):
        """Its rate is linear in it."""
        drive, at_one = (self.sum(self.flow[name]["terms"], point.moved({name: mpmath.mpf(at)})) for at in (0, 1))
        return path(point[name + "0"], drive, drive - at_one, point["t"])

    def output(self, name, point, phase):
        if self.flow:
            drift = self.flow.get(name, {}).get("role") == "drift"
            return self.sum(self.outputs[name], point) + (point["z" + name] if drift else 0)
        of = {"1": lambda angle: 1, "cos": mpmath.cos, "sin": mpmath.sin}
        return sum(point["eps"]**point.value(str(t["eps"]))*point.value(notation(t["coefficient"])) *
                   of[t["function"]](t["harmonic"]*point[phase]) for t in self.outputs[name])


def path(start, rate, decline, time):
    if decline == 0:
        return start + time*rate
    return start*mpmath.exp(-decline*time) - rate/decline*mpmath.expm1(-decline*time)


def integral(point):
    """The value of an integral: of an expression by a name, in the notation of the JSON."""
    return lambda expression, name, start, end: mpmath.quad(
        lambda value: point.moved({name: value}).value(expression), [start, end])


def primitives(solution, point):
    for primitive in solution.document.get("primitives", []):
        argument, kind = notation(primitive["argument"]), primitive["kind"]
        if kind == "quadrature":
            over = key(primitive["over"])
            slow = over in [key(law["variable"]) for law in solution.document["slow"]]
            start, end = (point[over + "0"], point[over]) if slow else (0, point["eps"]*point["t"])
            value = integral(point)(argument, over, start, end)
        else:
            value = {"logarithm": mpmath.log, "exponential": mpmath.exp}[kind](point.value(argument))
        point[key(primitive["name"])] = value


def faults(latex, document, normal_form, seed):
    solution = Solution(json.loads(document))
    equations = [(heading, text, *sides(text, set())) for heading, lines in sections(latex) for text in lines]
    outputs = [e for e in equations if e[0].startswith("outputs")]
    parts = {left: right for _, _, left, right, _ in outputs if left not in solution.outputs}
    phase = next((m[1] for e in equations for m in re.finditer(r"exp\(I\*(\w+)\)", e[3])), None)
    drifts = [(left, right) for heading, _, left, right, _ in equations if heading == "drift"]
    frames = {left: right for left, right in drifts if "z" + left in dict(drifts)}  # X = x - ...
    point = Point(seed, {**parts, **frames}, ())
    primitives(solution, point)
    point["integral"] = integral(point)
    for drift in solution.document.get("drift", []):
        point[key(drift["variable"])] = solution.series(drift["value"], point)
    amplitudes, conjugates = {}, {}  # z1 = a1*exp(...), phi = theta + delta_phi; z2 = conj(z1), a2 = conj(a1)
    for heading, _, left, right, _ in equations:
        names = re.findall(r"\b[A-Za-z]\w*", right)
        if heading == "frame" and not left.endswith("_dot"):
            if names[0] == "conj":
                conjugates[names[1]] = left
            elif solution.is_angle(left):
                amplitudes[names[-1]] = left
            elif left not in amplitudes:
                amplitudes[names[0]] = left
    for name, mode in amplitudes.items():
        point[name] = point[mode]
        if mode in conjugates:
            point[conjugates[name]] = point[conjugates[mode]]
    turning = iter(solution.rates)
    for heading, text, left, right, _ in equations:
        name = left.removesuffix("_dot")
        if heading == "frame" and left != name:
            expected = point.value(next(turning))
        elif heading == "slow flow" and left == name:
            expected = solution.slow_in_flow(name, point)
        elif heading == "slow flow":
            variable = amplitudes.get(name, name if name in solution.flow else name[1:])
            expected = solution.sum(solution.flow[variable]["terms"], point)
        elif heading == "amplitude and phase" and left in ("Delta", phase):
            mode = solution.document["modes"][0]
            expected = solution.amplitude(mode, point) if left == "Delta" else solution.phase(mode, point)
        elif heading == "amplitude and phase" and left != name:
            rate = solution.rate_of_mode(Answer(json.loads(normal_form)), point)
            expected = rate.real if name == "Delta" else rate.imag/point["Delta"]
        elif heading == "drift" and left not in frames:
            expected = point[left.removeprefix("z")]
        elif heading == "":
            expected = solution.slow(left, point)
        elif left in solution.outputs and heading.startswith("outputs"):
            expected = solution.output(left, point, phase)
        else:
            continue
        if differ(expected, point.value(right)):
            yield f"LaTeX, {heading}: {text}"
    if len(outputs) - len(parts) < len(solution.outputs):
        yield "LaTeX: an output is missing"


if __name__ == "__main__":
    texts = [open(name).read() for name in ("out.latex", "out.json", "out.normal_form")]
    print("\n".join(at_a_point(lambda seed: faults(*texts, seed))) or "equal")
