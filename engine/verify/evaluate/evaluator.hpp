// SPDX-License-Identifier: GPL-3.0-or-later
// A running evaluator: the text of emit_library, compiled and called; or the same program interpreted.
#pragma once

#include "emit/cpp/lies.hpp"
#include "runtime/status.hpp"
#include "verify/evaluate/interpretation.hpp"
#include "verify/run/real.hpp"
#include "verify/run/shared_object.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace resonform {

// The emitted code of a scene.
class EvaluatorLibrary {
public:
    // types: of those Evaluators that are made of it, as emit_library has them. Errors: those of
    // SharedObject. lies: as emit_library has them.
    static std::shared_ptr<const EvaluatorLibrary>
    build(const Program& program, const std::filesystem::path& cache,
          const std::function<void(const std::string&)>& progress, std::string_view types = "d",
          CppLies* lies = nullptr);
    // No compiler runs: the interpreter stands for the code, with the same operations in the same real types.
    static std::shared_ptr<const EvaluatorLibrary> interpreted(std::shared_ptr<const Program> program);

    explicit EvaluatorLibrary(SharedObject object) : object_(std::move(object)) {}
    explicit EvaluatorLibrary(std::shared_ptr<const Interpretation> shared)
        : interpretation_(std::move(shared)) {}

    [[nodiscard]] const std::optional<SharedObject>& object() const { return object_; }
    [[nodiscard]] const std::shared_ptr<const Interpretation>& interpretation() const {
        return interpretation_;
    }

private:
    std::optional<SharedObject> object_; // none: interpreted
    std::shared_ptr<const Interpretation> interpretation_;
};

// An emitted evaluator with numbers put in. Real: double, long double, Float128. Calls are thread-safe.
// Precondition: the library is interpreted, or has the type; many points: interpreted, or double.
template <class Real> class Evaluator {
public:
    // parameters, start: in the order of the program's.
    Evaluator(std::shared_ptr<const EvaluatorLibrary> library, Real eps, const std::vector<Real>& parameters,
              const std::vector<Real>& start, Real slow_time_end);

    Status call(Real t, Real* outputs) const;
    // The cause of a status of the construction or of calls, "" if there is none.
    [[nodiscard]] const char* why(Status status) const;
    // All states; only if the program kept them.
    Status state(Real t, Real* values) const;
    // Builds the tables of batch and grid, which their first call would build.
    void prepare() const;
    // outputs[k][i] at t[i]
    void batch(const std::vector<Real>& t, const std::vector<Real*>& outputs,
               std::vector<unsigned char>& status) const;
    // outputs[k][i] at t0 + i dt, for as many as there is room for a status. Precondition: it is compiled.
    void grid(Real t0, Real dt, const std::vector<Real*>& outputs, std::vector<unsigned char>& status) const;

private:
    void compiled(Real eps, const std::vector<Real>& parameters, const std::vector<Real>& start,
                  Real slow_time_end);
    void interpreted(Real eps, const std::vector<Real>& parameters, const std::vector<Real>& start,
                     Real slow_time_end);

    std::shared_ptr<const EvaluatorLibrary> library_;
    std::unique_ptr<void, void (*)(void*)> object_;
    const char* (*why_)(const void*, int) = nullptr;
    int (*call_)(const void*, const Real*, Real*) = nullptr;
    int (*state_)(const void*, const Real*, Real*) = nullptr;
    int (*prepare_)(const void*) = nullptr;
    void (*batch_)(const void*, const Real*, long, Real* const*, unsigned char*) = nullptr;
    void (*grid_)(const void*, const Real*, const Real*, long, Real* const*, unsigned char*) = nullptr;
};

// Where values[output][point] go, as batch and grid take it, and ensembles. They must not grow meanwhile.
template <class Real> std::vector<Real*> arrays_of(std::vector<std::vector<Real>>& values) {
    std::vector<Real*> arrays;
    for (std::vector<Real>& array : values) arrays.push_back(array.data());
    return arrays;
}

// "outside_domain: 1 - tau", or the status alone where it has no cause.
std::string told(Status status, const std::string& why);

} // namespace resonform
