// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/integrate/taylor_jet.hpp"

namespace resonform {

namespace {

// sum_{j=first}^{last} a_j b_{n-j}
template <class Real> Real cauchy(const Real* a, const Real* b, int n, int first, int last) {
    Real sum(0);
    for (int j = first; j <= last; ++j) sum += a[j] * b[n - j];
    return sum;
}

// sum_{j=first}^{last} j a_j b_{n-j}
template <class Real> Real weighted(const Real* a, const Real* b, int n, int first, int last) {
    Real sum(0);
    for (int j = first; j <= last; ++j) sum += Real(j) * (a[j] * b[n - j]);
    return sum;
}

// [a^2]_n from half of the products.
template <class Real> Real square(const Real* a, int n) {
    Real sum(0);
    for (int j = 0; 2 * j < n; ++j) sum += a[j] * a[n - j];
    sum += sum;
    return n % 2 == 0 ? Real(sum + a[n / 2] * a[n / 2]) : sum;
}

// q^2 = a: 2 q_0 q_n = a_n - sum_{j=1}^{n-1} q_j q_{n-j}
template <class Real> Real square_root(const Real* q, const Real* a, int n) {
    return (a[n] - cauchy(q, q, n, 1, n - 1)) / (Real(2) * q[0]);
}

// p = a^e: n a_0 p_n = sum_{j=1}^n (j e - (n - j)) a_j p_{n-j}
template <class Real> Real power(const Real* p, const Real* a, const Real& e, int n) {
    Real sum(0);
    for (int j = 1; j <= n; ++j) sum += (Real(j) * e - Real(n - j)) * (a[j] * p[n - j]);
    return sum / (Real(n) * a[0]);
}

} // namespace

template <class Real>
TaylorJet<Real>::TaylorJet(const BoundTape<Real>& tape, int order)
    : tape_(tape.tape()), values_(tape.registers()), order_(order), constants_(tape.tape().constant_count()),
      stride_(static_cast<std::size_t>(order) + 1),
      rows_(static_cast<std::size_t>(tape.tape().size()) * stride_, Real(0)) {
    for (int r = 0; r < constants_; ++r) row(r)[0] = values_[static_cast<std::size_t>(r)];
}

template <class Real> void TaylorJet<Real>::expand(const std::vector<Real>& state) {
    for (std::size_t i = 0; i < state.size(); ++i)
        values_[static_cast<std::size_t>(constants_) + i] = state[i];
    for (const Tape::Instruction& step : tape_.body()) run(step, values_.data());
    for (int r = constants_; r < tape_.size(); ++r) row(r)[0] = values_[static_cast<std::size_t>(r)];
    const std::vector<int>& rates = tape_.outputs();
    for (int n = 0; n < order_; ++n) {
        if (n > 0)
            for (const Tape::Instruction& step : tape_.body()) coefficient(step, n);
        for (std::size_t i = 0; i < rates.size(); ++i)
            row(constants_ + static_cast<int>(i))[n + 1] = row(rates[i])[n] / Real(n + 1);
    }
}

template <class Real> void TaylorJet<Real>::coefficient(const Tape::Instruction& step, int n) {
    using Op = Tape::Op;
    const Real* a = row(step.left);
    const Real* b = row(step.right);
    Real* out = row(step.result);
    Real* out2 = out + stride_; // the second result, where there is one
    switch (step.op) {
    case Op::add: out[n] = a[n] + b[n]; break;
    case Op::subtract: out[n] = a[n] - b[n]; break;
    case Op::multiply: out[n] = cauchy(a, b, n, 0, n); break;
    case Op::scale: out[n] = a[0] * b[n]; break;
    case Op::square: out[n] = square(a, n); break;
    case Op::divide: out[n] = (a[n] - cauchy(out, b, n, 0, n - 1)) / b[0]; break;
    case Op::sqrt: out[n] = square_root(out, a, n); break;
    case Op::power: out[n] = power(out, a, b[0], n); break;
    case Op::exp: out[n] = weighted(a, out, n, 1, n) / Real(n); break;
    case Op::sin_cos:
        out[n] = weighted(a, out2, n, 1, n) / Real(n);
        out2[n] = -(weighted(a, out, n, 1, n) / Real(n));
        break;
    case Op::sinh_cosh:
        out[n] = weighted(a, out2, n, 1, n) / Real(n);
        out2[n] = weighted(a, out, n, 1, n) / Real(n);
        break;
    case Op::tan_secant:
        out[n] = weighted(a, out2, n, 1, n) / Real(n);
        out2[n] = square(out, n);
        break;
    case Op::tanh_sech:
        out[n] = weighted(a, out2, n, 1, n) / Real(n);
        out2[n] = -square(out, n);
        break;
    case Op::function:
    case Op::data: out[n] = weighted(a, b, n, 1, n) / Real(n); break;
    }
}

template <class Real> Real TaylorJet<Real>::value(int state, const Real& h) const {
    const Real* c = coefficients(state);
    Real sum = c[order_];
    for (int k = order_ - 1; k >= 0; --k) sum = sum * h + c[k];
    return sum;
}

template class TaylorJet<double>;
template class TaylorJet<long double>;
template class TaylorJet<Float128>;
template class TaylorJet<DoubleDouble>;

} // namespace resonform
