// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/run/machine.hpp"

#include "runtime/batch.hpp"
#include "verify/run/shared_object.hpp"

#include <sched.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>

namespace resonform {

namespace {

std::string processor_name() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
            return line.substr(line.find(": ") + 2);
    return "unknown";
}

const char* name_of(Simd width) {
    switch (width) {
    case Simd::baseline: return "baseline";
    case Simd::avx2: return "avx2";
    case Simd::avx512: return "avx512";
    case Simd::neon: return "neon";
    }
    return "unknown";
}

} // namespace

std::string instruction_set() {
#if defined(__x86_64__)
    return __builtin_cpu_supports("fma") != 0 && __builtin_cpu_supports("avx2") != 0
               ? "x86-64, functions with fused multiply-add"
               : "x86-64";
#else
    return "one of its kind";
#endif
}

Machine this_machine() {
    Machine machine{processor_name(),  instruction_set(),
                    name_of(simd()),   std::nullopt,
                    compile_command(), static_cast<int>(std::thread::hardware_concurrency())};
    double load = 0;
    if (getloadavg(&load, 1) == 1) machine.load = load;
    return machine;
}

OnOneProcessor::OnOneProcessor() {
    cpu_set_t allowed, one;
    const int here = sched_getcpu();
    if (here < 0 || here >= CPU_SETSIZE || sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
    CPU_ZERO(&one);
    CPU_SET(static_cast<std::size_t>(here), &one);
    if (sched_setaffinity(0, sizeof one, &one) != 0) return;
    processor_ = here;
    before_.assign(reinterpret_cast<const char*>(&allowed), sizeof allowed);
}

OnOneProcessor::~OnOneProcessor() {
    if (!processor_) return;
    cpu_set_t allowed;
    std::memcpy(&allowed, before_.data(), sizeof allowed);
    sched_setaffinity(0, sizeof allowed, &allowed);
}

} // namespace resonform
