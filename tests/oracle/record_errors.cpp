// SPDX-License-Identifier: GPL-3.0-or-later
// Loaded before a program of resonform (LD_PRELOAD), writes every Error that it throws to the file
// $RESONFORM_ERRORS, a line each: the exit code that it asks for and the message, line ends as \n. Programs
// that it starts write to the same file. scripts/oracle.sh compares these lines between two commits.
#include "algebra/number/error.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <typeinfo>

namespace {

using Throw = void (*)(void*, void*, void (*)(void*));

// In one write, so that lines of several processes do not mix.
void append(const char* file, const std::string& line) {
    const int out = open(file, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0644);
    if (out < 0) return;
    if (write(out, line.data(), line.size()) < 0) std::abort();
    close(out);
}

void record(const resonform::Error& error) {
    const char* file = std::getenv("RESONFORM_ERRORS");
    if (file == nullptr) return;
    std::string line = std::to_string(static_cast<int>(error.kind())) + " ";
    for (const char* c = error.what(); *c != '\0'; ++c)
        line += *c == '\n' ? std::string("\\n") : std::string(1, *c);
    append(file, line + "\n");
}

} // namespace

// The type is known by its name: the program has its own copy of it.
extern "C" [[noreturn]] void __cxa_throw(void* thrown, void* type, void (*destroy)(void*)) {
    if (std::string(static_cast<std::type_info*>(type)->name()) == typeid(resonform::Error).name())
        record(*static_cast<const resonform::Error*>(thrown));
    reinterpret_cast<Throw>(dlsym(RTLD_NEXT, "__cxa_throw"))(thrown, type, destroy);
    std::abort();
}
