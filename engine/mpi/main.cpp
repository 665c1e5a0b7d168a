// SPDX-License-Identifier: GPL-3.0-or-later
// resonform_mpi sweep ...: one sweep by all ranks of mpirun. The first derives the scene and compiles its
// code before the others find both in the cache; every rank computes its share of the blocks; the first
// writes the result. A rank that is lost ends the run, as mpirun does, and the same command goes on with the
// blocks that are there.
#include "algebra/number/error.hpp"
#include "cli/command_line.hpp"
#include "cli/complaint.hpp"
#include "cli/output.hpp"
#include "cli/sweep_team.hpp"

#include <fcntl.h>
#include <mpi.h>
#include <unistd.h>

#include <exception>

namespace resonform {

namespace {

constexpr int go_on = -1; // else the exit code of all

class Ranks {
public:
    Ranks(int* argc, char*** argv) {
        MPI_Init(argc, argv);
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &size_);
    }
    ~Ranks() { MPI_Finalize(); }
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    [[nodiscard]] bool leads() const { return rank_ == 0; }

    SweepTeam team() {
        return {true, static_cast<std::uint64_t>(rank_), static_cast<std::uint64_t>(size_),
                [this] {
                    if (leads()) tell(go_on);
                },
                [this] { return worst(done); }};
    }

    // What the first rank says to the others, once: go_on, or how the run ended before there was work for
    // them.
    void tell(int word) {
        if (told_) return;
        told_ = true;
        MPI_Bcast(&word, 1, MPI_INT, 0, MPI_COMM_WORLD);
    }
    int listen() {
        int word = 0;
        MPI_Bcast(&word, 1, MPI_INT, 0, MPI_COMM_WORLD);
        return word;
    }
    // The worst of the codes of all ranks; asked once by each.
    int worst(int code) {
        int all = code;
        if (!agreed_) MPI_Allreduce(&code, &all, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
        agreed_ = true;
        return all;
    }
    // A rank failed while there was work: the others are waiting for its code.
    int failed(int code) {
        if (leads() && !told_)
            tell(code);
        else
            worst(code);
        return code;
    }

private:
    int rank_ = 0, size_ = 1;
    bool told_ = false, agreed_ = false;
};

int run(Ranks& ranks, int argc, char** argv) {
    CLI::App app("The sweep of resonform on many machines: mpirun -n 64 resonform_mpi sweep ...",
                 "resonform_mpi");
    Action action;
    app.require_subcommand(0, 1);
    app.set_version_flag("--version", "resonform_mpi " RESONFORM_VERSION);
    app.set_help_flag("-h,--help", "print this help and exit");
    add_sweep_of(app, action, ranks.team());
    const int code = run_command_line(app, action, argc, argv);
    if (ranks.leads()) ranks.tell(code); // --help and --gather
    return code;
}

// Standard error while all ranks do the same: of the first alone.
class Silence {
public:
    Silence() : before_(dup(STDERR_FILENO)) {
        const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
    }
    void end() const {
        if (before_ >= 0) dup2(before_, STDERR_FILENO);
    }

private:
    int before_;
};

int run_follower(Ranks& ranks, int argc, char** argv) {
    if (const int word = ranks.listen(); word != go_on) return word;
    const Silence silence;
    try {
        return run(ranks, argc, argv);
    } catch (...) {
        silence.end();
        throw;
    }
}

} // namespace

} // namespace resonform

int main(int argc, char** argv) {
    using namespace resonform;
    Ranks ranks(&argc, &argv);
    try {
        hold_streams();
        return ranks.leads() ? run(ranks, argc, argv) : run_follower(ranks, argc, argv);
    } catch (...) {
        const Error error = error_of(std::current_exception());
        tell_error(error, ranks.leads() && asks_for_json(argc, argv));
        return ranks.failed(static_cast<int>(error.kind()));
    }
}
