// SPDX-License-Identifier: MIT
// A function that the user of an emitted class gives by an object,
//
//   template <class R> R operator()(int derivative, const R& x) const;   // the derivative-th derivative at x
//
// with R the type of the class and the wider types that phases are added up in: numbers are R(2), functions
// those of resonform::math. A generic lambda will do. It is copied with the evaluator; copies do not throw.
#ifndef RESONFORM_RUNTIME_CALLABLE
#define RESONFORM_RUNTIME_CALLABLE

#include "runtime/math.hpp"
#include "runtime/scaled.hpp"

#include <optional>

namespace resonform {

template <class Function> class Callable {
public:
    Callable() = default;
    Callable(const Function& function) : function_(function) {}
    Callable(const Callable&) = default;
    ~Callable() = default;
    Callable& operator=(const Callable& other) { // closures have no assignment
        if (this == &other) return *this;
        function_.reset();
        if (other.function_) function_.emplace(*other.function_);
        return *this;
    }

    [[nodiscard]] bool given() const { return function_.has_value(); }

    // Not a number if none is given.
    template <class Real> [[nodiscard]] Real operator()(int derivative, const Real& x) const {
        return function_ ? Real((*function_)(derivative, x)) : math::not_a_number<Real>();
    }
    template <class Number>
    [[nodiscard]] Scaled<Number> operator()(int derivative, const Scaled<Number>& x) const {
        return of_number([&](const Number& value) { return (*this)(derivative, value); }, x);
    }

private:
    std::optional<Function> function_;
};

} // namespace resonform

#endif
