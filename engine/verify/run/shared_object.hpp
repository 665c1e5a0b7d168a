// SPDX-License-Identifier: GPL-3.0-or-later
// C++ text as running code: compiled by the system's compiler into a shared object of the cache, and loaded.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace resonform {

// The compiler of emitted code, with its flags: "g++ -O2 -std=gnu++20 ...".
std::string compile_command();

// It stays loaded as long as the object lives.
class SharedObject {
public:
    // Compiles unless the cache holds the same text, command and runtime headers; `announce` is called
    // before. The compiler is the one that built the engine, or the environment variable CXX. Errors:
    // refused, no compiler, one that is told to break the rules of arithmetic, or text that does not compile
    // (its first complaint).
    static SharedObject load(const std::string& text, const std::filesystem::path& cache,
                             const std::function<void()>& announce);

    [[nodiscard]] void* symbol(const std::string& name) const; // nullptr if absent
    // What the compiler took, whenever it ran.
    [[nodiscard]] double compile_seconds() const { return compile_seconds_; }

private:
    SharedObject(void* handle, double seconds);
    std::unique_ptr<void, int (*)(void*)> handle_;
    double compile_seconds_;
};

} // namespace resonform
