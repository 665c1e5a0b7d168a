// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/evaluator.hpp"

#include "algebra/error.hpp"
#include "emit/cpp.hpp"
#include "verify/cache.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <utility>

namespace resonform {

namespace {

namespace fs = std::filesystem;

constexpr const char* flags = "-O2 -std=gnu++20 -shared -fPIC";
constexpr std::size_t complaint_length = 800; // bytes of a compiler's complaint that are shown

std::string compiler() {
    const char* chosen = std::getenv("CXX"); // NOLINT(concurrency-mt-unsafe): nobody sets it here
    return chosen != nullptr && *chosen != '\0' ? chosen : RESONFORM_CXX_COMPILER;
}

fs::path engine_folder() { return fs::path(RESONFORM_SOURCE_DIR) / "engine"; }

std::string quoted(const fs::path& path) {
    std::string out = "'";
    for (const char c : path.string()) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

// The headers that emitted code includes: a change in them is a change of the code.
std::string runtime_text() {
    std::error_code failed;
    std::vector<fs::path> headers;
    for (const auto& entry : fs::directory_iterator(engine_folder() / "runtime", failed))
        if (entry.path().extension() == ".hpp") headers.push_back(entry.path());
    if (headers.empty())
        refuse({"emitted code is compiled with the engine's runtime headers",
                (engine_folder() / "runtime").string(),
                "keep the source folder where it was when the engine was built",
                {}});
    std::sort(headers.begin(), headers.end());
    std::string text;
    for (const fs::path& header : headers) text += read_bytes(header).value_or("");
    return text;
}

// Runs a shell command; what it says on standard error, and its wait status. SIGINT ends both.
std::pair<std::string, int> complaints_of(const std::string& command) {
    FILE* pipe = popen((command + " 2>&1 >/dev/null").c_str(), "r"); // NOLINT(cert-env33-c): CXX is a command
    if (pipe == nullptr) return {"", -1};
    std::string text;
    std::array<char, 4096> buffer{};
    for (std::size_t n = 0; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        text.append(buffer.data(), n);
    return {text, pclose(pipe)};
}

// The signal that ended a command of the shell, or 0.
int signal_of(int status) {
    if (WIFSIGNALED(status)) return WTERMSIG(status);
    return WIFEXITED(status) && WEXITSTATUS(status) > 128 ? WEXITSTATUS(status) - 128 : 0;
}

// The compiler writes beside the object, and that file is renamed, so that nobody ever sees half a file.
void compile(const fs::path& source, const fs::path& object) {
    fs::path draft = object;
    draft += fmt::format(".{}.part", getpid());
    const auto [complaint, result] = complaints_of(fmt::format(
        "{} {} -I{} {} -o {}", compiler(), flags, quoted(engine_folder()), quoted(source), quoted(draft)));
    std::error_code failed;
    if (result == 0) {
        fs::rename(draft, object, failed);
        if (!failed) return;
    }
    fs::remove(draft, failed);
    if (WIFEXITED(result) && WEXITSTATUS(result) == 127)
        refuse({"emitted code is checked by compiling it with a C++20 compiler",
                compiler(),
                "install g++ (Debian: apt install g++) or set CXX to a compiler",
                {}});
    if (const int signal = signal_of(result); signal != 0)
        refuse({"the compiler of emitted code runs to its end",
                fmt::format("{} was ended by signal {}", compiler(), signal),
                "run the command again",
                {}});
    refuse({"emitted code compiles",
            complaint.substr(0, complaint_length),
            "check the compiler named by CXX, or report this text",
            {}});
}

fs::path checksum_file(const fs::path& object) { return fs::path(object) += ".sum"; }

// Loading a shared object that was cut or changed would be the end of the program.
bool is_whole(const fs::path& object) {
    const std::optional<std::string> bytes = read_bytes(object), sum = load_checked(checksum_file(object));
    return bytes && sum && *sum == content_hash(*bytes);
}

template <class Real> constexpr char suffix = 'd';
template <> constexpr char suffix<long double> = 'l';
template <> constexpr char suffix<Float128> = 'q';

template <class Function> Function find(const EvaluatorLibrary& library, const char* stem, char type) {
    return reinterpret_cast<Function>(library.symbol(fmt::format("rf_{}_{}", stem, type)));
}

} // namespace

std::shared_ptr<const EvaluatorLibrary>
EvaluatorLibrary::build(const Program& program, const fs::path& cache,
                        const std::function<void(const std::string&)>& progress) {
    const std::string text = emit_library(program);
    const std::string key = content_hash(compiler() + "\n" + flags + "\n" + runtime_text() + "\n" + text);
    const fs::path source = fs::absolute(cache) / (key + ".cpp"),
                   object = fs::absolute(cache) / (key + ".so");
    // libquadmath is not linked here: the engine has it loaded.
    const auto load = [&object] { return dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL); };
    void* handle = is_whole(object) ? load() : nullptr;
    if (handle == nullptr) { // absent, or damaged
        remove_abandoned_drafts(fs::absolute(cache));
        if (progress)
            progress(fmt::format("compiling the emitted code of {}, order {}", program.scene, program.order));
        write_atomically(source, text);
        compile(source, object);
        store_checked(checksum_file(object), content_hash(read_bytes(object).value_or("")));
        handle = load();
    }
    if (handle == nullptr) {
        const char* why = dlerror(); // NOLINT(concurrency-mt-unsafe)
        refuse({"compiled emitted code can be loaded",
                why == nullptr ? object.string() : why,
                "check the compiler named by CXX",
                {}});
    }
    return std::shared_ptr<const EvaluatorLibrary>(new EvaluatorLibrary(handle));
}

void* EvaluatorLibrary::symbol(const std::string& name) const { return dlsym(handle_, name.c_str()); }

EvaluatorLibrary::~EvaluatorLibrary() { dlclose(handle_); }

template <class Real>
Evaluator<Real>::Evaluator(std::shared_ptr<const EvaluatorLibrary> library, Real eps,
                           const std::vector<Real>& parameters, const std::vector<Real>& start,
                           Real slow_time_end)
    : library_(std::move(library)),
      object_(nullptr, find<void (*)(void*)>(*library_, "delete", suffix<Real>)),
      call_(find<decltype(call_)>(*library_, "call", suffix<Real>)),
      state_(find<decltype(state_)>(*library_, "state", suffix<Real>)),
      batch_(find<decltype(batch_)>(*library_, "batch", suffix<Real>)) {
    using New = void* (*)(const Real*, const Real*, const Real*, const Real*);
    const New make = find<New>(*library_, "new", suffix<Real>);
    object_.reset(make(&eps, parameters.data(), start.data(), &slow_time_end));
}

template <class Real> Status Evaluator<Real>::call(Real t, Real* outputs) const {
    return static_cast<Status>(call_(object_.get(), &t, outputs));
}

template <class Real> Status Evaluator<Real>::state(Real t, Real* values) const {
    return static_cast<Status>(state_(object_.get(), &t, values));
}

template <class Real>
void Evaluator<Real>::batch(const std::vector<Real>& t, const std::vector<Real*>& outputs,
                            std::vector<unsigned char>& status) const {
    batch_(object_.get(), t.data(), static_cast<long>(t.size()), outputs.data(), status.data());
}

template class Evaluator<double>;
template class Evaluator<long double>;
template class Evaluator<Float128>;

} // namespace resonform
