// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/estimate/best_order.hpp"

#include "algebra/number/number.hpp"
#include "emit/program/build_program.hpp"
#include "solve/flow/solve_options.hpp"
#include "solve/solve.hpp"
#include "verify/estimate/next_weight.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/run/real.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace resonform {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();
constexpr double few_roundings = 64; // of the largest value: a smaller term is none

bool is_known(double term) { return term < unknown; } // no NaN
bool is_seen(double term) { return term > 0 && is_known(term); }

double falling(std::size_t n) { return static_cast<double>(n) * static_cast<double>(n - 1); } // n(n - 1)

// Q/(N(N - 1)) from the last terms that are seen, N of them.
double quotient(const std::vector<double>& terms, std::size_t count, double small) {
    double most = 0;
    for (std::size_t n = count; n >= 3 && n + 1 >= count; --n)
        if (is_seen(terms[n - 1]) && is_seen(terms[n - 3]))
            most = std::max(most, terms[n - 1] / terms[n - 3]);
    if (most > 0) return most / falling(count);
    if (count < 2 || !is_seen(terms[count - 2])) return small * small / falling(count + 2);
    return std::pow(terms[count - 1] / terms[count - 2] / static_cast<double>(count), 2);
}

// The terms with d_{N + 1} and d_{N + 2} appended. Zeros at their end are replaced by extrapolated terms,
// too.
std::vector<double> continued(std::vector<double> terms, double small) {
    std::size_t seen = terms.size();
    while (seen > 0 && !is_seen(terms[seen - 1])) --seen;
    if (seen == 0) return terms;
    const double q = quotient(terms, seen, small), end = is_known(terms.back()) ? 0 : unknown;
    terms.resize(terms.size() + 2, end);
    for (std::size_t n = seen + 1; n <= terms.size(); ++n)
        if (is_known(terms[n - 1]))
            terms[n - 1] = n >= 3 && is_known(terms[n - 3]) ? terms[n - 3] * q * falling(n)
                                                            : terms[n - 2] * std::sqrt(q * falling(n + 1));
    return terms;
}

using OutputsAt = std::vector<std::vector<long double>>; // [time][output]; no outputs: no answer there

OutputsAt outputs_at(const std::shared_ptr<const Interpretation>& formula, long double eps,
                     long double slow_time_end, const std::vector<double>& times) {
    OutputsAt values(times.size());
    if (!formula) return values;
    const Interpreter<long double> evaluator(formula, eps, {}, {}, slow_time_end);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Status status = evaluator.call(static_cast<long double>(times[i]), values[i]);
        if (status != Status::ok && status != Status::low_precision) values[i].clear();
    }
    return values;
}

double largest(const OutputsAt& values, std::size_t output) {
    double most = 0;
    for (const std::vector<long double>& v : values)
        if (!v.empty()) most = std::fmax(most, static_cast<double>(std::abs(v[output])));
    return most;
}

double difference(const OutputsAt& a, const OutputsAt& b, std::size_t output) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double d = a[i].empty() || b[i].empty()
                             ? unknown
                             : static_cast<double>(std::abs(a[i][output] - b[i][output]));
        if (!is_known(d)) return unknown;
        most = std::max(most, d);
    }
    return most;
}

} // namespace

BestOrder best_of(const Rational& eps, const std::vector<double>& terms, int eps_root) {
    const std::vector<double> all = continued(terms, std::pow(to_double(eps), 1.0 / eps_root));
    BestOrder best{eps, 0, unknown, static_cast<int>(terms.size()) + 1};
    double after = 0; // the next term that is seen
    for (std::size_t n = all.size(); n-- > 0;) {
        double error = unknown;
        if (is_known(all[n])) error = std::max(all[n], after);
        if (n <= terms.size() && is_seen(error) && error <= best.accuracy) {
            best.order = static_cast<int>(n) + 1;
            best.accuracy = error;
        }
        if (is_seen(all[n])) after = all[n];
    }
    return best;
}

OrderSeries::OrderSeries(const Scene& fixed, const Solution& next, const ErrorEstimator& made)
    : outputs_(fixed.outputs.size()) {
    for (int order = 1; order <= fixed.order + 1; ++order) {
        try {
            const int truncation = counted_truncation(fixed, next, order);
            formulas_.push_back(made.formula(order, truncation));
            if (formulas_.back()) continue;
            const Solution solution = solve(next.normalization, options_of(fixed, order, truncation));
            formulas_.back() = std::make_shared<const Interpretation>(
                std::make_shared<const Program>(build_program(solution, fixed)));
        } catch (const Error&) { // it has no numbers
            formulas_.resize(static_cast<std::size_t>(order), nullptr);
        }
    }
}

std::vector<std::vector<double>> OrderSeries::terms(long double eps, long double slow_time_end,
                                                    const std::vector<double>& times,
                                                    const std::vector<double>& rounding) const {
    std::vector<double> invisible = rounding;
    std::vector<std::vector<double>> terms(outputs_);
    OutputsAt before;
    for (const auto& formula : formulas_) {
        OutputsAt values = outputs_at(formula, eps, slow_time_end, times);
        for (std::size_t k = 0; k < outputs_; ++k) {
            invisible[k] = std::max(invisible[k],
                                    few_roundings * RealTraits<long double>::roundoff() * largest(values, k));
            if (!before.empty()) terms[k].push_back(difference(before, values, k));
        }
        before = std::move(values);
    }
    for (std::size_t k = 0; k < outputs_; ++k)
        for (double& term : terms[k])
            if (term <= invisible[k]) term = 0;
    return terms;
}

} // namespace resonform
