// SPDX-License-Identifier: MIT
// Many points of an emitted evaluator from tables (runtime/kernel), which the first call builds and copies of
// the evaluator share. What the tables have no number for is asked of the evaluator, point by point.
//
// The loops are those of resonform::batch where that is linked (RESONFORM_BATCH), else they are compiled
// here.
#ifndef RESONFORM_RUNTIME_TABULATED
#define RESONFORM_RUNTIME_TABULATED

#include "runtime/kernel/tables.hpp"
#include "runtime/points.hpp"
#ifdef RESONFORM_BATCH
#include "runtime/batch.hpp"
#else
#include "runtime/kernel/grid.hpp"
#endif

#include <new>
#include <utility>

namespace resonform {

// Tables of an evaluator and its copies. Copies may be taken, and calls made, while another thread builds:
// each thread that comes first builds for itself, and one of them is kept. (No standard header of threads:
// their macros would be in the way of the names of users.)
class SharedTables {
public:
    SharedTables() : state_(new State) {}
    SharedTables(const SharedTables& other) noexcept : state_(other.state_) {
        __atomic_fetch_add(&state_->owners, 1, __ATOMIC_RELAXED);
    }
    SharedTables& operator=(const SharedTables& other) noexcept {
        SharedTables copy(other);
        std::swap(state_, copy.state_);
        return *this;
    }
    ~SharedTables() {
        if (__atomic_sub_fetch(&state_->owners, 1, __ATOMIC_ACQ_REL) > 0) return;
        delete state_->built;
        delete state_;
    }

    // build(tables) -> Status is called unless it has been, and once more where there was no memory.
    template <class Build> Status prepare(const Build& build) const noexcept {
        Built* seen = __atomic_load_n(&state_->built, __ATOMIC_ACQUIRE);
        if (seen != nullptr) return seen->status;
        Built* own = new (std::nothrow) Built;
        if (own == nullptr) return Status::no_memory;
        own->status = build(own->tables);
        const Status status = own->status;
        if (status == Status::no_memory || !__atomic_compare_exchange_n(&state_->built, &seen, own, false,
                                                                        __ATOMIC_ACQ_REL, __ATOMIC_ACQUIRE))
            delete own;
        return status;
    }
    // Precondition: prepare() has said ok.
    [[nodiscard]] const kernel::View& view() const noexcept {
        return __atomic_load_n(&state_->built, __ATOMIC_ACQUIRE)->tables.view();
    }

private:
    struct Built {
        Status status = Status::ok;
        kernel::Tables tables;
    };
    struct State {
        long owners = 1;
        Built* built = nullptr;
    };
    State* state_;
};

// Evaluator: as of Points; prepare_tables() -> Status, view(); ok from there on.
struct Tabulated {
    // The tables of Evaluator::Rows up to the last t with eps t <= end that the evaluator answers with ok.
    template <class Evaluator>
    static Status build(const Evaluator& evaluator, double eps, double end, bool rounded,
                        kernel::Tables& tables) noexcept {
        if (!(end > 0)) return Status::outside_domain; // t = 0 alone: there is nothing to tabulate
        typename Evaluator::Values values;
        const auto answers = [&](double t) { return evaluator.at(t, 0, values) == Status::ok; };
        double reach = kernel::last_time(eps, end);
        if (!answers(0)) return Status::outside_domain;
        kernel::Options options;
        options.ends = !answers(reach);
        if (options.ends)
            for (double bad = reach, good = 0;;) {
                const double middle = good + (bad - good) / 2;
                if (!(good < middle && middle < bad)) {
                    reach = good;
                    break;
                }
                (answers(middle) ? good : bad) = middle;
            }
        if (rounded) options.resolution = math::epsilon<double>();
        return tables.build(typename Evaluator::Rows{evaluator, eps, reach}, options);
    }

    template <class Evaluator, class Real, std::size_t Count>
    static BatchReport batch(const Evaluator& evaluator, const Real* t, std::size_t n,
                             const std::array<Real*, Count>& outputs, Status* status) noexcept {
        if constexpr (std::is_same_v<Real, double>)
            if (n > 0 && has_tables(evaluator)) {
                const kernel::Direct direct{&evaluator, &direct_at<Evaluator>};
                return loops().batch(evaluator.view(), t, n, outputs.data(), status, &direct);
            }
        return Points::batch(evaluator, t, n, outputs, status);
    }

    template <class Evaluator, class Real, std::size_t Count>
    static BatchReport grid(const Evaluator& evaluator, const Real& t0, const Real& dt, std::size_t n,
                            const std::array<Real*, Count>& outputs, Status* status) noexcept {
        if constexpr (std::is_same_v<Real, double>)
            if (n > 0 && has_tables(evaluator)) {
                const kernel::Direct direct{&evaluator, &direct_at<Evaluator>};
                return loops().grid(evaluator.view(), t0, dt, n, outputs.data(), status, &direct);
            }
        return Points::grid(evaluator, t0, dt, n, outputs, status);
    }

private:
    // Of a construction that failed nothing is built.
    template <class Evaluator> static bool has_tables(const Evaluator& evaluator) noexcept {
        return evaluator.construction_status() == Status::ok && evaluator.prepare_tables() == Status::ok;
    }
    template <class Evaluator>
    static Status direct_at(const void* evaluator, double t, double low, double* numbers) noexcept {
        typename Evaluator::Values values;
        const Status status = static_cast<const Evaluator*>(evaluator)->at(t, low, values);
        Evaluator::list(values, numbers);
        return status;
    }
#ifdef RESONFORM_BATCH
    static const kernel::Loops& loops() noexcept { return kernel::loops(); }
#else
    struct Loops {
        static constexpr auto batch = &kernel::batch;
        static constexpr auto grid = &kernel::grid;
    };
    static constexpr Loops loops() noexcept { return {}; }
#endif
};

} // namespace resonform

#endif
