// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/signs/open_cells.hpp"

#include "algebra/signs/eliminants.hpp"

#include <algorithm>
#include <tuple>

namespace resonform {

namespace {

bool holds(const std::vector<Packed>& all, const Packed& p) {
    return std::find(all.begin(), all.end(), p) != all.end();
}

// A number of few digits between two that are apart; a missing one is infinite.
Rational between(const RealBall* left, const RealBall* right) {
    if (left == nullptr && right == nullptr) return 0;
    const auto lies_between = [&](const Rational& x) {
        constexpr std::int64_t bits = 256;
        const RealBall there(x, bits);
        return (left == nullptr || arb_lt(left->get(), there.get()) != 0) &&
               (right == nullptr || arb_lt(there.get(), right->get()) != 0);
    };
    const Rational near = left == nullptr    ? middle(*right) - 1
                          : right == nullptr ? middle(*left) + 1
                                             : (middle(*left) + middle(*right)) / 2;
    for (int digits = 0; digits < 200; ++digits) {
        const Integer scale = cln::ash(Integer(1), digits);
        const Rational x = cln::round1(near * scale) / scale;
        if (lies_between(x)) return x;
    }
    throw NoQuotient{};
}

class OpenCells {
public:
    OpenCells(const Packed& asked, const std::vector<Packed>& conditions, const std::vector<Packed>& factors)
        : asked_(asked) {
        std::vector<Packed> all;
        for (const Packed& f : factors)
            if (!holds(all, f)) all.push_back(f);
        project(all);
        visit({levels_, conditions, asked}, order_.size());
    }

    [[nodiscard]] SignSet signs() const { return signs_; }

private:
    struct Fiber { // with values put in for some variables
        std::vector<std::vector<Packed>> levels;
        std::vector<Packed> conditions;
        Packed asked;
    };

    // Projection: over each cell of the remaining variables, the roots in the eliminated one do not meet.
    void project(std::vector<Packed> all) {
        std::vector<slong> left = variables_of(all);
        if (left.size() > most_variables) throw NoQuotient{};
        while (!left.empty()) {
            const slong next = best_of(left, all);
            left.erase(std::find(left.begin(), left.end(), next));
            const auto kept = std::stable_partition(all.begin(), all.end(),
                                                    [&](const Packed& p) { return degree(p, next) > 0; });
            std::vector<Packed> level(all.begin(), kept);
            all.erase(all.begin(), kept);
            for (auto p = level.begin(); p != level.end() && !left.empty(); ++p) {
                add(coefficient(*p, next, degree(*p, next)), all);
                if (degree(*p, next) > 1) add(eliminated(*p, *p, next), all);
                for (auto q = level.begin(); q != p; ++q) add(eliminated(*p, *q, next), all);
            }
            order_.push_back(next);
            levels_.push_back(std::move(level));
        }
    }

    // The variable to eliminate next: the one of lowest degree, among equals the one in fewest polynomials.
    // The variable eliminated first must occur in the asked polynomial, or its sign changes are missed.
    [[nodiscard]] slong best_of(const std::vector<slong>& left, const std::vector<Packed>& all) const {
        std::optional<std::tuple<slong, slong, slong>> best; // degree, polynomials, variable
        for (const slong v : left) {
            slong highest = 0, count = 0;
            for (const Packed& p : all) {
                highest = std::max(highest, degree(p, v));
                count += degree(p, v) > 0 ? 1 : 0;
            }
            if (order_.empty() && degree(asked_, v) <= 0) continue;
            if (!best || std::tuple(highest, count, v) < *best) best = {highest, count, v};
        }
        return std::get<2>(*best);
    }

    static Packed eliminated(const Packed& p, const Packed& q, slong variable) {
        if (degree(p, variable) + degree(q, variable) > highest_degree ||
            p.terms() * q.terms() > most_products)
            throw NoQuotient{};
        return &p == &q ? discriminant(p, variable) : resultant(p, q, variable);
    }

    static void add(const Packed& p, std::vector<Packed>& all) {
        for (auto& factor : factored(p).factors)
            if (!holds(all, factor.base)) all.push_back(std::move(factor.base));
        if (all.size() > most_polynomials) throw NoQuotient{};
    }

    void visit(const Fiber& fiber, std::size_t open) {
        const std::vector<RealBall> roots = real_roots(fiber.levels[open - 1], order_[open - 1]);
        int last = 0; // sign in the cell before, 0: outside of the domain
        for (std::size_t k = 0; k <= roots.size() && signs_ != SignSet::all(); ++k) {
            if (++cells_ > most_cells) throw NoQuotient{};
            const auto inner =
                at(fiber, open - 1,
                   between(k == 0 ? nullptr : &roots[k - 1], k == roots.size() ? nullptr : &roots[k]));
            if (inner && open > 1) visit(*inner, open - 1);
            const int sign = inner && open == 1 ? sign_of_number(inner->asked) : 0;
            if (sign != 0) signs_.insert(sign);
            if (sign * last < 0) signs_.insert(0);
            last = sign;
        }
    }

    // nullopt: outside of the domain.
    [[nodiscard]] std::optional<Fiber> at(const Fiber& fiber, std::size_t level,
                                          const Rational& value) const {
        Fiber inner{{}, {}, value_at(fiber.asked, order_[level], value)};
        for (const Packed& p : fiber.conditions) {
            Packed left = value_at(p, order_[level], value);
            if (!left.is_constant())
                inner.conditions.push_back(std::move(left));
            else if (sign_of_number(left) <= 0)
                return std::nullopt;
        }
        for (std::size_t k = 0; k < level; ++k) {
            inner.levels.emplace_back();
            for (const Packed& p : fiber.levels[k])
                inner.levels.back().push_back(value_at(p, order_[level], value));
        }
        return inner;
    }

    const Packed& asked_;
    std::vector<slong> order_; // of elimination
    std::vector<std::vector<Packed>> levels_;
    SignSet signs_;
    int cells_ = 0;
};

} // namespace

std::optional<SignSet> signs_on_open_cells(const Packed& asked, const std::vector<Packed>& conditions,
                                           const std::vector<Packed>& factors) {
    try {
        return OpenCells(asked, conditions, factors).signs();
    } catch (const NoQuotient&) {
        return std::nullopt;
    }
}

} // namespace resonform
