// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/run/shared_object.hpp"

#include "algebra/number/error.hpp"
#include "verify/run/cache.hpp"
#include "verify/run/child.hpp"
#include "verify/run/drafts.hpp"
#include "verify/run/installation.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <locale>
#include <optional>
#include <sstream>
#include <system_error>
#include <vector>

namespace resonform {

namespace {

namespace fs = std::filesystem;

constexpr const char* flags = "-O2 -std=gnu++20 -shared -fPIC";
constexpr std::size_t complaint_length = 800; // bytes of a compiler's complaint that are shown

// Joins every text, and tells of arithmetic that is reckoned anew by the rules of the real numbers, by which
// it is 0. (clang says nothing of -funsafe-math-optimizations alone: no header can ask for it.)
constexpr const char* probe_name = "resonform_rounding_error";
constexpr const char* probe =
    "\nextern \"C\" double resonform_rounding_error(double a, double b) { return b - ((a + b) - a); }\n";

std::string compiler() {
    const char* chosen = std::getenv("CXX"); // NOLINT(concurrency-mt-unsafe): nobody sets it here
    return chosen != nullptr && *chosen != '\0' ? chosen : RESONFORM_CXX_COMPILER;
}

// The headers that emitted code includes: a change in them is a change of the code.
std::string runtime_text() {
    std::error_code failed;
    std::vector<fs::path> headers;
    const fs::path folder = installation().headers / "runtime";
    for (const auto& entry : fs::recursive_directory_iterator(folder, failed))
        if (entry.path().extension() == ".hpp") headers.push_back(entry.path());
    if (headers.empty())
        refuse(Reason::compiler, {"emitted code is compiled with the engine's runtime headers",
                                  folder.string(),
                                  "keep the headers where they were installed, or the source folder where it "
                                  "was when the engine was built",
                                  {}});
    std::sort(headers.begin(), headers.end());
    std::string text;
    for (const fs::path& header : headers) text += read_bytes(header).value_or("");
    return text;
}

// The signal that ended a command of the shell, or 0.
int signal_of(int status) {
    if (WIFSIGNALED(status)) return WTERMSIG(status);
    return WIFEXITED(status) && WEXITSTATUS(status) > 128 ? WEXITSTATUS(status) - 128 : 0;
}

// The words of a command that make a compiler reckon without NaN, infinities and rounding errors.
std::string fast_math_flags(const std::string& command) {
    std::istringstream words(command);
    std::string found;
    for (std::string word; words >> word;)
        if (word == "-Ofast" || (word.rfind("-f", 0) == 0 && word.rfind("-fno-", 0) != 0 &&
                                 word.find("-math") != std::string::npos))
            found += (found.empty() ? "" : " ") + word;
    return found;
}

[[noreturn]] void refuse_fast_math(const std::string& found) {
    refuse(Reason::compiler, {"emitted code is compiled with the arithmetic of IEEE 754: NaN, infinities and "
                              "rounding errors count",
                              found,
                              "leave out -Ofast, -ffast-math and its parts",
                              {}});
}

[[noreturn]] void refuse_hidden_fast_math() { refuse_fast_math("a flag that " + compiler() + " adds"); }

// Also where a later flag takes it back: whoever writes it wants it.
void require_exact_arithmetic(const std::string& command) {
    const std::string flags_found = fast_math_flags(command);
    if (!flags_found.empty()) refuse_fast_math(flags_found + " in CXX");
}

// The compiler writes beside the object, and that file is renamed, so that nobody ever sees half a file.
void compile(const fs::path& source, const fs::path& object) {
    const fs::path draft = draft_of(object);
    const auto [complaint, result, late] = run_child(
        fmt::format("{} {} -I{} {} -o {} 2>&1 >/dev/null", compiler(), flags,
                    shell_quoted(installation().headers), shell_quoted(source), shell_quoted(draft)),
        {draft});
    std::error_code failed, ignored;
    const bool made = result == 0 && fs::exists(draft, ignored);
    if (made)
        fs::rename(draft, object, failed);
    else
        failed = room_beside(object); // the compiler had none either
    if (made && !failed) return;
    fs::remove(draft, ignored);
    if (failed) cache_not_writable(object, failed);
    if (WIFEXITED(result) && WEXITSTATUS(result) == 127)
        refuse(Reason::compiler, {"emitted code is checked by compiling it with a C++20 compiler",
                                  compiler(),
                                  "install g++ (Debian: apt install g++) or set CXX to a compiler",
                                  {}});
    if (const int signal = signal_of(result); signal != 0)
        refuse(Reason::compiler, {"the compiler of emitted code runs to its end",
                                  fmt::format("{} was ended by signal {}", compiler(), signal),
                                  "run the command again",
                                  {}});
    if (complaint.find("evaluators want IEEE arithmetic") != std::string::npos) // said by the runtime
        refuse_hidden_fast_math();
    refuse(Reason::compiler, {"emitted code compiles",
                              complaint.empty() ? compiler() + " says nothing and makes nothing"
                                                : complaint.substr(0, complaint_length),
                              "check the compiler named by CXX, or report this text",
                              {}});
}

// The rounding error of 1 + 2^-60, as the shared object reckons it.
bool keeps_rounding_errors(void* handle) {
    void* function = dlsym(handle, probe_name);
    const double small = 0x1p-60;
    return function != nullptr &&
           reinterpret_cast<double (*)(double, double)>(function)(1, small) == small; // NOLINT
}

fs::path checksum_file(const fs::path& object) { return fs::path(object) += ".sum"; }

// Beside the object: its hash, and the seconds that its compiler took.
void store_checksum(const fs::path& object, double seconds) {
    store_checked(checksum_file(object),
                  fmt::format("{} {}", content_hash(read_bytes(object).value_or("")), seconds));
}

// The seconds that the compiler took. nullopt: the object is absent, or was cut or changed, and loading it
// would be the end of the program.
std::optional<double> seconds_of_whole(const fs::path& object) {
    const std::optional<std::string> bytes = read_bytes(object), sum = load_checked(checksum_file(object));
    if (!bytes || !sum) return std::nullopt;
    std::istringstream words(*sum);
    std::string hash;
    double seconds = 0;
    words.imbue(std::locale::classic());
    if (!(words >> hash >> seconds) || hash != content_hash(*bytes)) return std::nullopt;
    return seconds;
}

} // namespace

std::string compile_command() { return compiler() + " " + flags; }

SharedObject SharedObject::load(const std::string& text, const fs::path& cache,
                                const std::function<void()>& announce) {
    require_exact_arithmetic(compiler());
    const std::string probed = text + probe;
    const std::string key = content_hash(compiler() + "\n" + flags + "\n" + runtime_text() + "\n" + probed);
    const fs::path source = fs::absolute(cache) / (key + ".cpp"),
                   object = fs::absolute(cache) / (key + ".so");
    // libquadmath is not linked here: the engine has it loaded.
    const auto open = [&object] { return dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL); };
    std::optional<double> seconds = seconds_of_whole(object);
    void* handle = seconds ? open() : nullptr;
    if (handle == nullptr) { // absent, or damaged
        remove_abandoned_drafts(fs::absolute(cache));
        announce();
        write_atomically(source, probed);
        const auto begin = std::chrono::steady_clock::now();
        compile(source, object);
        seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        handle = open();
        if (handle != nullptr && !keeps_rounding_errors(handle)) {
            dlclose(handle);
            fs::remove(object);
            refuse_hidden_fast_math();
        }
        store_checksum(object, *seconds);
    }
    if (handle == nullptr) {
        const char* why = dlerror(); // NOLINT(concurrency-mt-unsafe)
        refuse(Reason::compiler, {"compiled emitted code can be loaded",
                                  why == nullptr ? object.string() : why,
                                  "check the compiler named by CXX",
                                  {}});
    }
    return {handle, *seconds};
}

SharedObject::SharedObject(void* handle, double seconds)
    : handle_(handle, dlclose), compile_seconds_(seconds) {}

void* SharedObject::symbol(const std::string& name) const { return dlsym(handle_.get(), name.c_str()); }

} // namespace resonform
