// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/evaluate/evaluator.hpp"

#include "emit/cpp/cpp.hpp"
#include "runtime/batch.hpp"
#include "verify/evaluate/interpreter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace resonform {

namespace {

template <class Real> constexpr char suffix = 'd';
template <> constexpr char suffix<long double> = 'l';
template <> constexpr char suffix<Float128> = 'q';

template <class Function> Function find(const SharedObject& object, const char* stem, char type) {
    return reinterpret_cast<Function>(object.symbol(fmt::format("rf_{}_{}", stem, type)));
}

// The functions of the C interface, of an interpreter.
template <class Real> struct Interpreted {
    static void remove(void* object) { delete static_cast<Interpreter<Real>*>(object); }
    static const Interpreter<Real>& of(const void* object) {
        return *static_cast<const Interpreter<Real>*>(object);
    }
    static const char* why(const void* object, int status) {
        return of(object).why(static_cast<Status>(status));
    }
    static int call(const void* object, const Real* t, Real* outputs) {
        std::vector<Real> values;
        const Status status = of(object).call(*t, values);
        std::copy(values.begin(), values.end(), outputs);
        return static_cast<int>(status);
    }
    static int state(const void* object, const Real* t, Real* states) {
        std::vector<Real> values;
        const Status status = of(object).state(*t, values);
        std::copy(values.begin(), values.end(), states);
        return static_cast<int>(status);
    }
    static void batch(const void* object, const Real* t, long n, Real* const* outputs,
                      unsigned char* status) {
        std::vector<Real> values;
        for (long i = 0; i < n; ++i) {
            status[i] = static_cast<unsigned char>(of(object).call(t[i], values));
            for (std::size_t k = 0; k < values.size(); ++k) outputs[k][i] = values[k];
        }
    }
};

} // namespace

std::string told(Status status, const std::string& why) {
    return why.empty() ? to_string(status) : fmt::format("{}: {}", to_string(status), why);
}

std::shared_ptr<const EvaluatorLibrary>
EvaluatorLibrary::build(const Program& program, const std::filesystem::path& cache,
                        const std::function<void(const std::string&)>& progress, std::string_view types,
                        CppLies* lies) {
    const auto announce = [&] {
        if (progress)
            progress(fmt::format("compiling the emitted code of {}, order {}", program.scene,
                                 to_string(program.weight(program.order))));
    };
    SharedObject object = SharedObject::load(emit_library(program, types, lies), cache, announce);
    using Loops = const kernel::Loops& (*)() noexcept;
    if (const auto take = reinterpret_cast<void (*)(Loops)>(object.symbol("rf_loops"))) take(&kernel::loops);
    return std::make_shared<const EvaluatorLibrary>(std::move(object));
}

std::shared_ptr<const EvaluatorLibrary>
EvaluatorLibrary::interpreted(std::shared_ptr<const Program> program) {
    return std::make_shared<const EvaluatorLibrary>(
        std::make_shared<const Interpretation>(std::move(program)));
}

template <class Real>
Evaluator<Real>::Evaluator(std::shared_ptr<const EvaluatorLibrary> library, Real eps,
                           const std::vector<Real>& parameters, const std::vector<Real>& start,
                           Real slow_time_end)
    : library_(std::move(library)), object_(nullptr, nullptr) {
    if (library_->object())
        compiled(eps, parameters, start, slow_time_end);
    else
        interpreted(eps, parameters, start, slow_time_end);
}

template <class Real>
void Evaluator<Real>::compiled(Real eps, const std::vector<Real>& parameters, const std::vector<Real>& start,
                               Real slow_time_end) {
    const SharedObject& object = *library_->object();
    why_ = find<decltype(why_)>(object, "why", suffix<Real>);
    call_ = find<decltype(call_)>(object, "call", suffix<Real>);
    state_ = find<decltype(state_)>(object, "state", suffix<Real>);
    prepare_ = find<decltype(prepare_)>(object, "prepare", suffix<Real>);
    batch_ = find<decltype(batch_)>(object, "batch", suffix<Real>);
    grid_ = find<decltype(grid_)>(object, "grid", suffix<Real>);
    using New = void* (*)(const Real*, const Real*, const Real*, const Real*);
    const New make = find<New>(object, "new", suffix<Real>);
    if (make == nullptr) throw std::logic_error("the library has no code of this real type");
    object_ = {make(&eps, parameters.data(), start.data(), &slow_time_end),
               find<void (*)(void*)>(object, "delete", suffix<Real>)};
}

template <class Real>
void Evaluator<Real>::interpreted(Real eps, const std::vector<Real>& parameters,
                                  const std::vector<Real>& start, Real slow_time_end) {
    using Its = Interpreted<Real>;
    why_ = Its::why;
    call_ = Its::call;
    state_ = Its::state;
    batch_ = Its::batch;
    object_ = {new Interpreter<Real>(library_->interpretation(), eps, parameters, start, slow_time_end),
               Its::remove};
}

template <class Real> Status Evaluator<Real>::call(Real t, Real* outputs) const {
    return static_cast<Status>(call_(object_.get(), &t, outputs));
}

template <class Real> const char* Evaluator<Real>::why(Status status) const {
    return why_(object_.get(), static_cast<int>(status));
}

template <class Real> Status Evaluator<Real>::state(Real t, Real* values) const {
    return static_cast<Status>(state_(object_.get(), &t, values));
}

template <class Real>
void Evaluator<Real>::batch(const std::vector<Real>& t, const std::vector<Real*>& outputs,
                            std::vector<unsigned char>& status) const {
    batch_(object_.get(), t.data(), static_cast<long>(t.size()), outputs.data(), status.data());
}

template <class Real>
void Evaluator<Real>::grid(Real t0, Real dt, const std::vector<Real*>& outputs,
                           std::vector<unsigned char>& status) const {
    grid_(object_.get(), &t0, &dt, static_cast<long>(status.size()), outputs.data(), status.data());
}

template <class Real> void Evaluator<Real>::prepare() const {
    if (prepare_ != nullptr) prepare_(object_.get());
}

template class Evaluator<double>;
template class Evaluator<long double>;
template class Evaluator<Float128>;

} // namespace resonform
