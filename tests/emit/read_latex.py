# SPDX-License-Identifier: GPL-3.0-or-later
# Reads the LaTeX that `derive` prints, and writes each side of an equation in the notation of the JSON:
#
#   -\frac{i \sqrt{g}}{16 \left(r^{2} + \xi^{2}\right)^{1/4}} z_{1}^{2}
#   -(I*(g)**(1/2))/(16*(r**2+xi**2)**(1/4))*z1**2
#
# Names lose their underscores, which LaTeX does not show: x_2 is x_{2}, as x2 is. Beside that it is x_{(2)}, which is
# read as "x_sub_2". A dot is "_dot".
import re

FUNCTIONS = {"sin": "sin", "cos": "cos", "tan": "tan", "exp": "exp", "ln": "log", "sinh": "sinh", "cosh": "cosh",
             "tanh": "tanh", "arcsin": "asin", "arccos": "acos", "arctan": "atan", "arsinh": "asinh",
             "arcosh": "acosh", "artanh": "atanh", "erf": "erf", "Re": "re", "Im": "im", "overline": "conj"}
TOKEN = re.compile(r"\s*(\\left\(|\\right\)|\\[A-Za-z]+|\\,|\d+(?:\.\d+)?|[A-Za-z]|[-+/^_{}(),'])")


def tokens(text):
    at, result = 0, []
    text = re.sub(r"\\operatorname\{(\w+)\}", r"\\\1", text).rstrip()
    while at < len(text):
        match = TOKEN.match(text, at)
        assert match, f"no LaTeX of ours: {text[at:at + 40]}"
        result.append(match[1])
        at = match.end()
    return result + [""]


class Reader:
    """One side of an equation; `functions` are the names that stand for functions, as omega in omega(tau)."""

    def __init__(self, text, functions):
        self.tokens, self.at, self.functions = tokens(text), 0, functions

    @property
    def next(self):
        return self.tokens[self.at]

    def take(self, *expected):
        token = self.next
        assert not expected or token in expected, f"{token} where {expected} should be"
        self.at += 1
        return token

    def whole(self):
        text = self.sum()
        assert self.next == "", f"not read: {self.next}"
        return text

    def sum(self):
        text = self.take() if self.next in "+-" and self.next else ""
        text += self.term()
        while self.next in ("+", "-"):
            text += self.take() + self.term()
        return text

    def term(self):
        text = self.factor()
        while True:
            if self.next == "/":
                text += self.take() + self.factor()
                continue
            if self.next == "\\cdot":
                self.take()
            elif self.next in ("", "+", "-", "}", ")", "\\right)", ",", "\\,"):
                return text
            text += "*" + self.factor()

    def factor(self):
        base = self.base()
        while self.next == "^":
            self.take()
            base = f"{base}**({self.braced()})"
        return base

    def braced(self):
        self.take("{")
        text = self.sum()
        self.take("}")
        return text

    def parenthesised(self):
        self.take("\\left(")
        text = self.sum()
        self.take("\\right)")
        return f"({text})"

    def base(self):
        token = self.next
        if token == "\\left(":
            return self.parenthesised()
        if token[0].isdigit():
            return self.take()
        if token == "{":  # {\phi}_{\mathrm{old}}
            self.take()
            name = self.symbol()
            for expected in ("}", "_", "{", "\\mathrm", "{", "o", "l", "d", "}", "}"):
                self.take(expected)
            return name + "_old"
        if token == "\\frac":
            self.take()
            return f"(({self.braced()})/({self.braced()}))"
        if token == "\\sqrt":
            self.take()
            return f"({self.braced()})**(1/2)"
        if token == "\\int":
            return self.integral()
        if token[1:] in FUNCTIONS and token[0] == "\\":
            self.take()
            return FUNCTIONS[token[1:]] + self.argument()
        return self.named()

    # \overline{z}, \ln \left(x + 1\right), \cos 3 \theta. What follows an argument without parentheses is no part of
    # it, to a human reader neither: not \sin \theta \varepsilon.
    def argument(self):
        if self.next == "{":
            return f"({self.braced()})"
        if self.next == "\\left(":
            return self.parenthesised()
        number = self.take() + "*" if self.next.isdigit() else ""
        argument = f"({number}{self.symbol()})"
        clear = self.next in ("", "+", "-", "}", ")", "\\right)", "\\,") or self.next.lstrip("\\") in FUNCTIONS
        assert clear, f"{self.next} may belong to the argument {argument}"
        return argument

    # \int\limits_{\xi_{0}}^{\xi} 2 \xi \, d\xi, which is written integral("2*xi", "xi", xi0, xi)
    def integral(self):
        for expected in ("\\int", "\\limits", "_"):
            self.take(expected)
        start = self.braced()
        self.take("^")
        end = self.braced()
        integrand = self.term()
        self.take("\\,")
        self.take("d")
        return f'integral("{integrand}", "{self.symbol()}", {start}, {end})'

    # x, \dot{x}, \omega''\left(\tau\right); i is the imaginary unit
    def named(self):
        name = self.symbol()
        if name not in self.functions:
            return "I" if name == "i" else name
        order = 0
        while self.next == "'":
            order += 1
            self.take()
        if self.next == "^" and self.tokens[self.at + 2] == "(":
            order = self.derivative()
        argument = self.parenthesised()
        return f"derivative({name},{order},{argument})"

    def derivative(self):  # ^{(4)}
        for expected in ("^", "{", "("):
            self.take(expected)
        order = int(self.take())
        self.take(")")
        self.take("}")
        return order

    def symbol(self):
        dots = {"\\dot": "_dot", "\\ddot": "_dot_dot"}.get(self.next, "")
        if dots:
            self.take()
            self.take("{")
        name = self.word()
        if dots:
            self.take("}")
        if self.next == "^" and self.tokens[self.at + 2] == "(" and name not in self.functions:
            dots = "_dot" * self.derivative()
        if self.next == "_":
            self.take()
            self.take("{")
            name += self.subscript()
            while self.next == ",":
                self.take()
                name += self.subscript()
            self.take("}")
        return name + dots

    def subscript(self):
        if self.next != "(":
            return self.word()
        self.take()
        name = "_sub_" + self.subscript()
        self.take(")")
        return name

    def word(self):
        token = self.take()
        if token == "\\mathrm":
            self.take("{")
            letters = ""
            while self.next != "}":
                letters += self.take()
            self.take("}")
            return letters
        assert token.isalnum() or re.fullmatch(r"\\[A-Za-z]+", token), f"{token} where a name should be"
        return {"\\varepsilon": "eps"}.get(token, token.lstrip("\\"))


def sections(document):
    """[(heading, [equation])]: the alignments, their lines joined."""
    result = []
    for heading, body in re.findall(r"(?:^([^%\\\n]*):\n)?\\begin\{align\*\}\n(.*?)\n\\end\{align\*\}", document,
                                    re.M | re.S):
        equations = []
        for line in body.split(" \\\\\n"):
            if line.strip().startswith("&\\quad"):
                equations[-1] += " " + line.strip()
            else:
                equations.append(line.strip())
        result.append((heading, [e.replace("&", "").replace("\\quad", "") for e in equations]))
    return result


def sides(equation, functions):
    """Left, right, and the weight k of + O(eps^k): "" if there is none."""
    remainder = re.search(r" \+ O\\left\(\\varepsilon(?:\^\{([\d/]+)\})?\\right\)", equation)
    if remainder:
        equation = equation.replace(remainder[0], "")
    left, right = equation.split("=")
    weight = (remainder[1] or "1") if remainder else ""
    return Reader(left, functions).whole(), Reader(right, functions).whole(), weight
