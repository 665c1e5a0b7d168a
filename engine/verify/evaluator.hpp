// SPDX-License-Identifier: GPL-3.0-or-later
// Emitted code at work: the text of emit_library compiled by the system's compiler into a shared
// object of the cache, and called.
#pragma once

#include "emit/program.hpp"
#include "runtime/status.hpp"
#include "verify/real.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace resonform {

// One loaded shared object; it stays loaded while an Evaluator lives.
class EvaluatorLibrary {
public:
    // Compiles unless the cache holds the same text, command and runtime headers. The compiler is the
    // one that built the engine, or the environment variable CXX.
    // Errors: refused, no compiler, or emitted code that does not compile (its first complaint).
    static std::shared_ptr<const EvaluatorLibrary>
    build(const Program& program, const std::filesystem::path& cache,
          const std::function<void(const std::string&)>& progress);

    [[nodiscard]] void* symbol(const std::string& name) const; // nullptr if absent
    ~EvaluatorLibrary();
    EvaluatorLibrary(const EvaluatorLibrary&) = delete;
    EvaluatorLibrary& operator=(const EvaluatorLibrary&) = delete;

private:
    explicit EvaluatorLibrary(void* handle) : handle_(handle) {}
    void* handle_;
};

// An emitted evaluator with numbers put in. Real: double, long double, Float128. Calls are
// thread-safe.
template <class Real> class Evaluator {
public:
    // parameters, start: in the order of the program's.
    Evaluator(std::shared_ptr<const EvaluatorLibrary> library, Real eps, const std::vector<Real>& parameters,
              const std::vector<Real>& start, Real slow_time_end);

    Status call(Real t, Real* outputs) const;
    // All states; only if the program kept them.
    Status state(Real t, Real* values) const;
    // outputs[k][i] at t[i]
    void batch(const std::vector<Real>& t, const std::vector<Real*>& outputs,
               std::vector<unsigned char>& status) const;

private:
    std::shared_ptr<const EvaluatorLibrary> library_;
    std::unique_ptr<void, void (*)(void*)> object_;
    int (*call_)(const void*, const Real*, Real*);
    int (*state_)(const void*, const Real*, Real*);
    void (*batch_)(const void*, const Real*, long, Real* const*, unsigned char*);
};

} // namespace resonform
