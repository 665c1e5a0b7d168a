// SPDX-License-Identifier: GPL-3.0-or-later
// A straight-line program over graded series, evaluated weight by weight: part n of every node is
// computed once, from parts 0 ... n of its operands, and never again (Euler's recurrences, e.g. for
// s = sin u, c = cos u with [u]_0 = 0:  n s_n = sum_{j=1}^n j u_j c_{n-j}).
//
//   program:  psi = input;  s = sine(psi);  f = product(constant(i G/sigma), s)
//   run:      set_input(psi, 1, (z1+z2)/2); advance(1); part(f,1) = i G/sigma (z1+z2)/2; ...
#pragma once

#include "algebra/number/error.hpp"
#include "algebra/series/ring_domain.hpp"
#include "algebra/series/series.hpp"

#include <concepts>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace resonform {

class SeriesProgram {
public:
    using Node = int;
    enum class Op {
        input,
        constant,
        number,
        sum,
        product,
        sine,
        cosine,
        exponential,
        logarithm,
        power,
        antiderivative
    };

    struct Instruction {
        Op op = Op::constant;
        std::string name;                               // input
        std::vector<Polynomial> parts;                  // constant, by weight
        std::size_t index = 0;                          // number
        std::vector<std::pair<Rational, Node>> addends; // sum
        Node left = -1, right = -1;                     // product; left: operand of functions
        Rational exponent;                              // power
        Place place;                                    // power: of its errors, no part of its meaning

        friend bool operator==(const Instruction& a, const Instruction& b) {
            return a.op == b.op && a.name == b.name && a.parts == b.parts && a.index == b.index &&
                   a.addends == b.addends && a.left == b.left && a.right == b.right &&
                   a.exponent == b.exponent;
        }
    };

    // Nodes are shared: the same operation on the same operands is the same node. Inputs are not.
    explicit SeriesProgram(RingPtr ring);
    [[nodiscard]] const RingPtr& ring() const { return ring_; }
    [[nodiscard]] const std::vector<Instruction>& instructions() const { return instructions_; }

    Node input(std::string name);
    Node constant(const Polynomial& p); // split by weight
    // A complex number that the ring does not hold: the domain knows it by its index (NumberDomain only).
    Node number(std::size_t index);
    Node sum(const std::vector<std::pair<Rational, Node>>& addends);
    Node product(Node a, Node b);
    Node sine(Node u); // creates cosine(u) too, once per u
    Node cosine(Node u);
    Node exponential(Node u);
    Node logarithm(Node u);
    // f with df = slope du and [f]_0 = 0: n f_n = sum_{j=1}^n j u_j slope_{n-j}. With
    // slope = 1/(1 + u^2) this is atan(u). Stored as left = u, right = slope.
    Node antiderivative(Node u, Node slope);
    // u^exponent; weight-0 part of u must be a unit whose power lies in the ring (checked in a Run).
    // A non-negative integer exponent is expanded into products. `place`: where it was written.
    Node power(Node u, const Rational& exponent, const Place& place = {});

private:
    Node intern(Instruction instruction);
    Node append(Instruction instruction);

    RingPtr ring_;
    std::vector<Instruction> instructions_;
    std::unordered_multimap<std::size_t, Node> shared_;                 // by hash, of the nodes of intern()
    std::vector<std::pair<Node, std::pair<Node, Node>>> trigonometric_; // u -> (sine, cosine)
};

// One evaluation of a program, over a domain of coefficients. Weights are advanced one by one from 0. The
// program must outlive the run and must not grow meanwhile. Calls out of order throw std::logic_error.
template <class Domain> class BasicSeriesRun {
public:
    using Part = typename Domain::Part;

    BasicSeriesRun(const SeriesProgram& program, Domain domain);
    template <class Own = Domain>
    requires std::constructible_from<Own, const RingPtr&>
    explicit BasicSeriesRun(const SeriesProgram& program) : BasicSeriesRun(program, Own(program.ring())) {}

    // Sets part `weight` of an input; must happen before advance(weight), or afterwards followed by
    // correct(weight).
    void set_input(SeriesProgram::Node input, int weight, Part part);
    // Goes to the next weight; weights must come in order 0, 1, 2, ... A part is computed when it is first
    // asked for, those of weight 0 at once. Errors (refused): sine/cosine/exponential/logarithm of a series
    // whose weight-0 part is not 0 (1 for logarithm), power of a series whose weight-0 part is no unit.
    void advance(int weight);
    // After inputs at the last advanced weight changed: updates the parts of this weight that were asked for.
    // By linearity only weight-0 parts enter: d(a b)_n = a_0 db_n + b_0 da_n, d(sin u)_n = c_0 du_n.
    // (At weight 0 everything is computed anew.)
    void correct(int weight);
    // Frees the parts that no later weight needs. Only for a caller that asks for each part at its own
    // weight: a freed part is lost.
    void forget();
    // 0 <= weight <= the last one advanced to
    [[nodiscard]] const Part& part(SeriesProgram::Node node, int weight) const;
    // All parts so far.
    [[nodiscard]] const BasicSeries<Part>& series(SeriesProgram::Node node) const;

private:
    // The values of a node: complete below `next`, but for those of weights 1 ... forgotten.
    struct Value {
        BasicSeries<Part> series;
        int next = 0, forgotten = 0;
    };
    [[nodiscard]] Part first_part(SeriesProgram::Node node);
    [[nodiscard]] Part next_part(SeriesProgram::Node node, int weight) const;
    [[nodiscard]] Part change(SeriesProgram::Node node, const std::vector<Part>& deltas) const;
    // factor * part(left, i) * part(right, j)
    struct Wanted {
        Rational factor;
        SeriesProgram::Node left;
        int i;
        SeriesProgram::Node right;
        int j;
    };
    [[nodiscard]] bool is_beyond(SeriesProgram::Node node, int weight) const;
    [[nodiscard]] bool vanishes(const Wanted& w) const;
    [[nodiscard]] std::vector<ProductOf<Part>> present(std::vector<Wanted> wanted) const;
    [[nodiscard]] Part dot(std::vector<Wanted> wanted) const;
    // The products that make up part n of a product node.
    [[nodiscard]] static std::vector<Wanted> factors(const Rational& factor, SeriesProgram::Node u,
                                                     SeriesProgram::Node v, int n);
    [[nodiscard]] Part combined(const SeriesProgram::Instruction& sum, int n) const;
    void find_fused();
    [[nodiscard]] Part integrated(SeriesProgram::Node u, SeriesProgram::Node v, int n, int sign = 1) const;
    void start();

    const SeriesProgram* program_;
    Domain domain_;
    std::vector<BasicSeries<Part>> constants_; // as elements of the domain, by node
    mutable std::vector<Value> values_;        // by node: the parts computed so far
    // Products that only one sum uses: collected with it, they have no parts of their own.
    std::vector<bool> fused_;
    Part one_;
    std::vector<Part> reciprocals_; // power: 1/u_0
    int weight_ = -1;
    std::vector<std::pair<SeriesProgram::Node, Part>> changed_; // inputs since advance
};

using SeriesRun = BasicSeriesRun<RingDomain>;

} // namespace resonform
