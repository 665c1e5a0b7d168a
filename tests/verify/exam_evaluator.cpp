// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled evaluators in the cache, whatever happened to them there; compilers that do not compile.
#include "algebra/number/error.hpp"
#include "runtime/math.hpp"
#include "verify/evaluate/evaluator.hpp"
#include "verify/evaluate/interpreter.hpp"
#include "verify/run/cache.hpp"

#include "model/files/read_scene.hpp"
#include "support/compiler.hpp"
#include "support/error_when.hpp"
#include "support/program.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>

namespace resonform {
namespace {

namespace fs = std::filesystem;

fs::path empty_folder(const std::string& name) {
    const fs::path path = fs::path(RESONFORM_BINARY_DIR) / name;
    fs::remove_all(path);
    return path;
}

Scene stiffening_scene() {
    const fs::path systems = test::source_dir() / "systems";
    return read_scene(systems / "slowly_stiffening_oscillator" / "scenes" / "third_order.toml", systems);
}

std::vector<fs::path> files_of_kind(const fs::path& folder, const std::string& extension) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == extension) found.push_back(entry.path());
    return found;
}

Diagnostic refusal_with(const char* compiler, const fs::path& cache) {
    const test::OtherCompiler chosen(compiler);
    const auto program = test::program_of(stiffening_scene());
    return test::error_when([&] { EvaluatorLibrary::build(*program, cache, {}); }).diagnostic();
}

// A compiler that compiles once, and then gives what it has made.
std::string keeping_compiler(const fs::path& script, const fs::path& kept) {
    test::write(script, "for object; do :; done\n[ ! -f '" + kept.string() + "' ] || exec cp '" +
                            kept.string() +
                            "' \"$object\"\n" RESONFORM_CXX_COMPILER " \"$@\" && cp \"$object\" '" +
                            kept.string() + "'\n");
    return "sh " + script.string();
}

TEST(SlowEvaluatorLibrary, IsCompiledAnewWhenTheCachedOneIsDamaged) {
    const fs::path cache = empty_folder("test_evaluator_cut");
    const test::Scratch scratch;
    const test::OtherCompiler chosen(
        keeping_compiler(scratch.path() / "compiler.sh", scratch.path() / "kept"));
    const auto program = test::program_of(stiffening_scene());
    int compilations = 0;
    const auto count = [&](const std::string&) { ++compilations; };
    const auto answer = [&] {
        const Evaluator<double> emitted(EvaluatorLibrary::build(*program, cache, count), 0.1, {}, {0, 1, 0},
                                        1.0);
        double x = 0;
        EXPECT_EQ(emitted.call(1.0, &x), Status::ok);
        return x;
    };
    const double x = answer();
    EXPECT_EQ(answer(), x);
    EXPECT_EQ(compilations, 1);
    const std::vector<fs::path> objects = files_of_kind(cache, ".so");
    ASSERT_EQ(objects.size(), 1U);
    const std::string whole = read_bytes(objects.front()).value();
    int expected = 1;
    for (const std::size_t length : {whole.size() / 2, std::size_t(4096), std::size_t(0)}) {
        write_atomically(objects.front(), whole.substr(0, length));
        EXPECT_EQ(answer(), x);
        EXPECT_EQ(compilations, ++expected) << "cut to " << length << " bytes";
    }
    EXPECT_TRUE(files_of_kind(cache, ".part").empty());
    EXPECT_TRUE(files_of_kind(cache, ".log").empty());
}

TEST(EvaluatorLibrary, TellsAnInterruptionFromAComplaint) {
    const fs::path cache = empty_folder("test_evaluator_interrupted");
    const Diagnostic killed = refusal_with("sh -c 'kill -INT $$' --", cache);
    EXPECT_EQ(killed.rule, "the compiler of emitted code runs to its end");
    EXPECT_EQ(killed.value, "sh -c 'kill -INT $$' -- was ended by signal 2");
    const Diagnostic complains = refusal_with("sh -c 'echo no such thing >&2; exit 1' --", cache);
    EXPECT_EQ(complains.rule, "emitted code compiles");
    EXPECT_EQ(complains.value, "no such thing\n");
    const Diagnostic silent = refusal_with("true", cache);
    EXPECT_EQ(silent.rule, "emitted code compiles");
    EXPECT_EQ(silent.value, "true says nothing and makes nothing");
    const Diagnostic absent = refusal_with("no-such-compiler", cache);
    EXPECT_EQ(absent.rule, "emitted code is checked by compiling it with a C++20 compiler");
    EXPECT_TRUE(files_of_kind(cache, ".part").empty());
}

// Wrong numbers without a word are what such flags bring: the flag is named, and found behind a wrapper, too,
// even behind one that hides what the compiler says of it.
TEST(EvaluatorLibrary, RefusesACompilerThatBreaksTheArithmetic) {
    const fs::path cache = empty_folder("test_evaluator_fast_math");
    const std::string rule = "emitted code is compiled with the arithmetic of IEEE 754: NaN, infinities and "
                             "rounding errors count";
    const std::string wrapper = (cache / "wrapper").string();
    const auto behind_a_wrapper = [&](const std::string& flags) {
        write_atomically(wrapper, "#!/bin/sh\nexec " RESONFORM_CXX_COMPILER " \"$@\" " + flags + "\n");
        fs::permissions(wrapper, fs::perms::owner_all);
        return refusal_with(wrapper.c_str(), cache);
    };
    for (const char* flag : {"-Ofast", "-ffast-math", "-ffinite-math-only", "-funsafe-math-optimizations"}) {
        const Diagnostic named =
            refusal_with((RESONFORM_CXX_COMPILER + std::string(" -g0 ") + flag).c_str(), cache);
        EXPECT_EQ(named.rule, rule) << flag;
        EXPECT_EQ(named.value, flag + std::string(" in CXX"));
        const Diagnostic hidden = behind_a_wrapper(flag);
        EXPECT_EQ(hidden.rule, rule) << flag;
        EXPECT_EQ(hidden.value, "a flag that " + wrapper + " adds");
    }
    EXPECT_EQ(behind_a_wrapper("-fassociative-math -fno-signed-zeros -fno-trapping-math "
                               "-U__ASSOCIATIVE_MATH__")
                  .rule,
              rule);
    EXPECT_TRUE(files_of_kind(cache, ".so").empty());
    const fs::path program = cache / "harmless.cpp";
    write_atomically(program, "#include \"runtime/math.hpp\"\nint main() {}\n");
    const std::string compile = RESONFORM_CXX_COMPILER " -fsyntax-only -std=gnu++20 -fno-math-errno -I" +
                                (test::source_dir() / "engine").string() + " " + program.string();
    EXPECT_EQ(std::system(compile.c_str()), 0); // NOLINT(cert-env33-c)
}

// theta_0 = "pi" is pi in every real type, to its last digits.
template <class Real> void expect_pi(const std::shared_ptr<const Program>& program) {
    const std::vector<Real> start = default_start<Real>(*program, Real(1) / Real(8), {});
    ASSERT_EQ(start.size(), 3U);
    EXPECT_LE(static_cast<double>(math::magnitude(Real(start[2] - math::pi<Real>()))),
              4 * static_cast<double>(math::epsilon<Real>()));
}

TEST(SlowEvaluatorLibrary, StartsAtPi) {
    Scene scene = stiffening_scene();
    for (StartValue& value : scene.start)
        if (value.name == "phase.x" || value.name == "theta_0") value.value = GiNaC::Pi;
    const auto program = test::program_of(scene);
    expect_pi<double>(program);
    expect_pi<long double>(program);
    expect_pi<Float128>(program);
    expect_pi<boost::multiprecision::cpp_bin_float_50>(program);
    const auto library = EvaluatorLibrary::build(*program, fs::path(RESONFORM_BINARY_DIR) / "test_cache", {});
    const Evaluator<double> emitted(library, 0.125, {}, {0, 1, std::numbers::pi}, 1.0);
    const Evaluator<double> unturned(library, 0.125, {}, {0, 1, 0}, 1.0);
    double x = 0, y = 0;
    EXPECT_EQ(emitted.call(0.0, &x), Status::ok);
    EXPECT_EQ(unturned.call(0.0, &y), Status::ok);
    EXPECT_NEAR(x, -y, 1e-15);
}

} // namespace
} // namespace resonform
