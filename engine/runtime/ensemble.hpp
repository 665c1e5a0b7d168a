// SPDX-License-Identifier: MIT
// Many members, each with parameters, a start and one final time of its own. In double they are computed
// several side by side (runtime/pack.hpp) wherever that leaves no doubt about a status; what does not, and
// other types, is answered by at_end, one by one. Which of the two answers a member depends on it alone.
#ifndef RESONFORM_RUNTIME_ENSEMBLE
#define RESONFORM_RUNTIME_ENSEMBLE

#include "runtime/decay.hpp"
#include "runtime/final_sums.hpp"
#include "runtime/layer.hpp"
#include "runtime/pack.hpp"
#include "runtime/pack_pair.hpp"
#include "runtime/report.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

namespace resonform {

// A phase up to this, in radians, is good to 4e-13 in double; one up to that keeps its digits in two of them.
inline constexpr double plain_radians = 1000, packed_radians = 1e6;

// Columns, cosines and sines of phases and powers of e at the end of [0, T] for several members.
template <class Course> class PackedEnd {
public:
    using Pack = kernel::Pack;
    using PackPair = kernel::PackPair;
    using Mask = kernel::Mask;
    std::array<Pack, Course::columns> tables{};
    std::array<Pack, Course::angles> cosine{}, sine{}, power{};
    bool in_range = true; // false: the constants of some member left the range of a double

    PackedEnd(const Course& course, const Pack& eps, const Pack& t) : course_(course), eps_(eps), t_(t) {}

    // The members that are answered. full_phase: to all digits of a double.
    Mask reach(Mask members, bool full_phase) {
        const Pack T = eps_ * t_;
        if constexpr (requires { course_.margins(T); }) members = members & clear_of_doubt(course_, T);
        Mask open = members, done = members & ~members;
        if (!full_phase || Course::angles == 0) {
            done = integrate<Pack>(T, open, plain_radians);
            open = open & ~done;
        }
        // two lanes and products split into halves would be slower than at_end
        if constexpr (Course::angles > 0 && kernel::lanes > 2)
            if (open.any())
                done = done | integrate<PackPair>(PackPair::product(eps_, t_), open, packed_radians);
        spread(done);
        return done;
    }

private:
    static constexpr std::size_t nodes = 20; // of a panel

    // Of the members that are open, those that 1, 2, 4 or 8 panels resolve.
    template <class Number> Mask integrate(const Number& end, Mask open, double most) {
        Mask done = open & ~open;
        const typename Course::template Angles<Number> turning(course_);
        if (turning.lost.status != Status::ok) {
            in_range = false;
            return done;
        }
        if constexpr (Course::angles > 0)
            open = open &
                   (FinalSums<Pack, Course, Number, nodes>(course_, turning).first_turn(end) < Pack(most));
        for (int parts = 1; parts <= 8 && open.any(); parts *= 2) {
            FinalSums<Pack, Course, Number, nodes> sums(course_, turning);
            const Mask resolved = open & sums.integrate_evenly(end, parts);
            Mask now = resolved;
            for (std::size_t k = 0; k < Course::angles; ++k)
                if (Course::decays[k])
                    power[k] = select(
                        resolved, exponential<Pack>(Number(turning.start[k] + sums.angles()[k])), power[k]);
            for (std::size_t k = 0; k < Course::angles; ++k) {
                if (Course::decays[k]) continue;
                const Pack size = turn(turning.start[k] + sums.angles()[k], resolved, cosine[k], sine[k]);
                now = now & (all_faded(Course::fades[k], power) | (size < Pack(most)));
            }
            for (std::size_t k = 0; k < Course::columns; ++k)
                tables[k] = select(now, sums.tables()[k], tables[k]);
            done = done | now;
            open = open & ~resolved;
        }
        return done;
    }

    // A lane without an answer takes the columns of one that has one: outputs computed from zeros would leave
    // their domain, and all members would be computed one by one.
    void spread(Mask known) {
        std::size_t j = 0;
        while (j < kernel::pack_lanes && !known[j]) ++j;
        if (j == kernel::pack_lanes || known) return;
        const auto put = [&](auto& all) {
            for (Pack& x : all) x = select(known, x, Pack(x[j]));
        };
        put(tables);
        put(cosine);
        put(sine);
        put(power);
    }

    // Sets cosine and sine of `members`; returns |theta|.
    static Pack turn(const Pack& theta, Mask members, Pack& cosine, Pack& sine) {
        return turn(PackPair(theta), members, cosine, sine);
    }
    static Pack turn(const PackPair& theta, Mask members, Pack& cosine, Pack& sine) {
        const PackPair quarters = theta * PackPair(Pack(0.63661977236758138), Pack(-3.9357353350364972e-17));
        const Pack whole = kernel::whole(quarters.high);
        Pack c, s;
        kernel::cosine_and_sine((quarters.high - whole) + quarters.low, kernel::turned(whole), c, s);
        cosine = select(members, c, cosine);
        sine = select(members, s, sine);
        return math::magnitude(theta.high);
    }

    const Course& course_;
    const Pack &eps_, &t_;
};

struct Ensemble {
    // Single: the emitted class in the type of the members; Packed: the same class in kernel::Pack.
    template <class Single, class Packed, class Real, class Members, std::size_t Count>
    static BatchReport run(std::size_t n, const Members& members, const Real* t,
                           const std::array<Real*, Count>& outputs, Status* status) noexcept {
        BatchReport report{Status::ok, 0, n};
        constexpr std::size_t lanes = kernel::pack_lanes;
        for (std::size_t i = 0; i < n; i += lanes) {
            const std::size_t count = std::min(lanes, n - i);
            std::array<Status, lanes> seen;
            std::array<std::array<Real, lanes>, Count> numbers;
            std::size_t rest = (std::size_t(1) << count) - 1; // members that are not answered
            if constexpr (std::is_same_v<Real, double> && Single::Course::packs) {
                if (members.eps != nullptr && t != nullptr) {
                    const Gathered<Packed> some = gather<Single, Packed>(members, t, i, count);
                    bool full_phase = false;
                    if constexpr (requires { members.full_phase; }) full_phase = members.full_phase;
                    rest &= ~side_by_side(some, full_phase, numbers);
                    seen.fill(Status::ok);
                }
            }
            for (std::size_t j = 0; j < count; ++j) {
                if ((rest >> j & 1) != 0) seen[j] = alone<Single>(members, t, i + j, j, numbers);
                if (status != nullptr) status[i + j] = seen[j];
                note(report, seen[j], i + j);
            }
            for (std::size_t k = 0; k < Count; ++k)
                if (outputs[k] != nullptr) std::copy_n(numbers[k].begin(), count, outputs[k] + i);
        }
        return report;
    }

private:
    template <class Packed> struct Gathered {
        kernel::Pack eps, t;
        typename Packed::Parameters parameters;
        typename Packed::Start start;
        kernel::Mask fit; // the member's arguments are moderate

        // Where a member is not to stay it gets the arguments of member j.
        void spread(kernel::Mask stay, std::size_t j) {
            const auto put = [&](kernel::Pack& x) { x = select(stay, x, kernel::Pack(x[j])); };
            put(eps);
            put(t);
            for (const auto field : Packed::parameter_fields) put(parameters.*field);
            for (const auto field : Packed::start_fields) put(start.*field);
        }
    };

    template <class Members, class Arrays>
    static bool gives_all(const Members& members, const Arrays& arrays) {
        return std::all_of(arrays.begin(), arrays.end(),
                           [&](const auto array) { return members.*array != nullptr; });
    }

    // A member's arguments; what has no array has its default.
    template <class Single, class Members, class Real>
    static void arguments(const Members& members, std::size_t i, Real& eps,
                          typename Single::Parameters& parameters, typename Single::Start& start) {
        eps = members.eps == nullptr ? math::not_a_number<Real>() : members.eps[i];
        parameters = {};
        if constexpr (requires { members.give(parameters); }) members.give(parameters); // its functions
        for (std::size_t k = 0; k < Single::parameter_fields.size(); ++k)
            if (const Real* array = members.*Single::parameter_arrays[k]; array != nullptr)
                parameters.*Single::parameter_fields[k] = array[i];
        start = gives_all(members, Single::start_arrays) ? typename Single::Start{}
                                                         : Single::default_start(eps, parameters);
        for (std::size_t k = 0; k < Single::start_fields.size(); ++k)
            if (const Real* array = members.*Single::start_arrays[k]; array != nullptr)
                start.*Single::start_fields[k] = array[i];
    }

    template <class Single, class Members, class Real, std::size_t lanes, std::size_t Count>
    static Status alone(const Members& members, const Real* t, std::size_t i, std::size_t lane,
                        std::array<std::array<Real, lanes>, Count>& numbers) {
        Real eps;
        typename Single::Parameters parameters;
        typename Single::Start start;
        arguments<Single>(members, i, eps, parameters, start);
        typename Single::Values values;
        const Status status =
            Single::at_end(eps, parameters, start, t == nullptr ? math::not_a_number<Real>() : t[i], values);
        std::array<Real, Count> list;
        Single::list(values, list.data());
        for (std::size_t k = 0; k < Count; ++k) numbers[k][lane] = list[k];
        return status;
    }

    // Zero, or between 2^-24 and 2^24: products of less than forty such arguments stay in range.
    static kernel::Mask moderate(const kernel::Pack& x) {
        const kernel::Pack size = math::magnitude(x);
        return (x == kernel::Pack(0)) | ((size > kernel::Pack(0x1p-24)) & (size < kernel::Pack(0x1p24)));
    }

    // All arguments, those of members that do not fit replaced by those of one that does.
    template <class Single, class Packed, class Members>
    static Gathered<Packed> gather(const Members& members, const double* t, std::size_t i,
                                   std::size_t count) {
        using Pack = kernel::Pack;
        Gathered<Packed> some;
        std::array<double, kernel::pack_lanes> eps;
        std::array<typename Single::Parameters, kernel::pack_lanes> parameters;
        std::array<typename Single::Start, kernel::pack_lanes> start;
        const auto from = [&](std::size_t j) { return i + std::min(j, count - 1); };
        const auto load = [&](const double* array) {
            Pack x(0);
            if (count == kernel::pack_lanes) return Pack::load(array + i);
            for (std::size_t j = 0; j < kernel::pack_lanes; ++j) x.set(j, array[from(j)]);
            return x;
        };
        some.eps = load(members.eps);
        some.t = load(t);
        const Pack T = some.eps * some.t;
        some.fit = moderate(some.eps) & (some.eps > Pack(0)) & (T > Pack(0x1p-60)) & (T < Pack(0x1p24));
        if (!gives_all(members, Single::parameter_arrays) || !gives_all(members, Single::start_arrays))
            for (std::size_t j = 0; j < kernel::pack_lanes; ++j)
                arguments<Single>(members, from(j), eps[j], parameters[j], start[j]);
        const auto take = [&](const double* array, Pack& field, const auto& fallback) {
            if (array != nullptr)
                field = load(array);
            else
                for (std::size_t j = 0; j < kernel::pack_lanes; ++j) field.set(j, fallback(j));
            some.fit = some.fit & moderate(field);
        };
        for (std::size_t k = 0; k < Single::parameter_fields.size(); ++k)
            take(members.*Single::parameter_arrays[k], some.parameters.*Packed::parameter_fields[k],
                 [&](std::size_t j) { return parameters[j].*Single::parameter_fields[k]; });
        for (std::size_t k = 0; k < Single::start_fields.size(); ++k)
            take(members.*Single::start_arrays[k], some.start.*Packed::start_fields[k],
                 [&](std::size_t j) { return start[j].*Single::start_fields[k]; });
        if (!some.fit)
            for (std::size_t j = 0; j < kernel::pack_lanes; ++j)
                if (some.fit[j]) {
                    some.spread(some.fit, j);
                    break;
                }
        return some;
    }

    // Sets the outputs of all lanes; returns the members that are answered. `status` is ok if every lane's
    // outputs are and no lane's constants left the range of a double. Not inlined, so that a member has the
    // same bits whether it is computed among others or alone.
    template <class Packed, std::size_t Count>
    [[gnu::noinline, gnu::flatten]] static kernel::Mask compute(const Gathered<Packed>& some, bool full_phase,
                                                                std::array<kernel::Pack, Count>& values,
                                                                Status& status) {
        using Pack = kernel::Pack;
        typename Packed::template Constants<Pack> c;
        constexpr bool asked = requires { Packed::keep_constants(some.eps, some.parameters, some.start, c); };
        if constexpr (!asked)
            Packed::compute_constants(some.eps, some.parameters, some.start, c);
        else if (Packed::keep_constants(some.eps, some.parameters, some.start, c).status != Status::ok) {
            status = Status::overflow;
            return some.fit;
        }
        const typename Packed::Course course{some.eps, some.parameters, some.start, c};
        kernel::Mask members =
            Pack(0) < Pack(1); // all: lanes that do not fit have the arguments of one that does
        if constexpr (requires { course.conditions(); })
            for (const Pack& condition : course.conditions())
                members = members & (condition > Pack(asked ? 0 : 0x1p-30)) & (condition < Pack(0x1p1000));
        PackedEnd<typename Packed::Course> end(course, some.eps, some.t);
        members = end.reach(members, full_phase);
        if (!end.in_range) {
            status = Status::overflow;
            return some.fit;
        }
        typename Packed::Arguments a;
        a.T = some.eps * some.t;
        Packed::take(end, a);
        typename Packed::Values outputs;
        status = evaluate<Packed>(c, a, outputs);
        Packed::list(outputs, values.data());
        for (const Pack& value : values) members = members & (value - value == Pack(0));
        return members & some.fit;
    }

    // Apart from compute(): it may be so long that a compiler takes minutes for both as one.
    template <class Packed, class Constants, class Arguments, class Values>
    [[gnu::noinline]] static Status evaluate(const Constants& c, const Arguments& a, Values& values) {
        return Packed::outputs(c, a, values);
    }

    // Sets the numbers of members that are answered, a bit each.
    template <class Packed, std::size_t lanes, std::size_t Count>
    static std::size_t side_by_side(const Gathered<Packed>& some, bool full_phase,
                                    std::array<std::array<double, lanes>, Count>& numbers) {
        if (!some.fit.any()) return 0;
        std::array<kernel::Pack, Count> values;
        Status status;
        kernel::Mask members = compute(some, full_phase, values, status);
        std::size_t answered = 0;
        for (std::size_t j = 0; j < lanes; ++j) answered |= std::size_t(members[j]) << j;
        for (std::size_t k = 0; k < Count; ++k) values[k].store(numbers[k].data());
        if (status == Status::ok) return answered;
        for (std::size_t j = 0; j < lanes; ++j) { // each by itself
            if (!members[j]) continue;
            Gathered<Packed> own = some;
            own.spread(members & ~members, j);
            const kernel::Mask alone = compute(own, full_phase, values, status);
            if (status != Status::ok || !alone[j]) answered &= ~(std::size_t(1) << j);
            for (std::size_t k = 0; k < Count; ++k) numbers[k][j] = values[k][j];
        }
        return answered;
    }
};

} // namespace resonform

#endif
