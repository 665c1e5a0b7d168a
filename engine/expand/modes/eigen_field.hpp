// SPDX-License-Identifier: GPL-3.0-or-later
// The field K[lambda]/f for an irreducible f over a field K of expressions, and linear algebra over it:
// eigenvectors for all roots of f at once, before a root is chosen.
//
//   f = lambda^2 + k/m:   1/lambda = -(m/k) lambda
#pragma once

#include "algebra/ring/ring.hpp"

#include <ginac/ginac.h>

#include <optional>
#include <vector>

namespace resonform {

class EigenField {
public:
    using Element = std::vector<GiNaC::ex>; // c_0 + c_1 lambda + ..., as many as the degree of f
    using Row = std::vector<Element>;
    using Rows = std::vector<Row>;

    // f = lambda^n + lower[n-1] lambda^(n-1) + ... + lower[0]
    explicit EigenField(std::vector<GiNaC::ex> lower) : lower_(std::move(lower)) {}

    [[nodiscard]] std::size_t degree() const { return lower_.size(); }
    [[nodiscard]] Element constant(const GiNaC::ex& value) const;
    [[nodiscard]] Element root() const; // lambda
    [[nodiscard]] Element minus(const Element& a, const Element& b) const;
    [[nodiscard]] Element times(const Element& a, const Element& b) const;
    // Nothing if a is not proved to have one.
    [[nodiscard]] std::optional<Element> inverse(const Element& a) const;
    // no: some coefficient is proved nonzero.
    [[nodiscard]] static Zero vanishes(const Element& a);

    // The reduced echelon form: leading entries 1, in ascending columns. Nothing if some entry can be told
    // neither zero nor nonzero.
    [[nodiscard]] std::optional<Rows> echelon(Rows rows) const;
    // A basis of { v : m v = 0 } in reduced echelon form; nothing as above.
    [[nodiscard]] std::optional<Rows> null_space(const Rows& m, std::size_t columns) const;

private:
    std::vector<GiNaC::ex> lower_;
};

} // namespace resonform
