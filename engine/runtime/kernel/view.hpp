// SPDX-License-Identifier: MIT
// The tables of a solution as the loops see them: plain numbers, the same for every width.
//
//   u_o(t) = sum_r P_r(v) g_r(theta_1, ..., theta_p),   g = 1, cos(k.theta), sin(k.theta)
//
// Times are cut into pieces of equal width; edges are exact doubles, and so is d = t - left. v = 2^n d - m
// lies within -m ... m, where m = 2^n width/2 is exact and between 1/2 and 1, and so is v but for its last
// place. In quarter turns each phase is  w d + q(v)  with |q| of about 1, or, where many turns are curved in
// one piece, a polynomial in d whose first coefficients are pairs of doubles (`wide` of them). An exponent is
// such a polynomial, too, in units of ln 2; of e^chi nothing is left below 2^-1021.
//
// Or each u_o is a polynomial in the cosines and sines of the phases themselves and in atoms, functions of
// slow time: then the rows are the atoms, and operations make the outputs of them. They work on slots: 2p and
// 2p + 1 hold the cosine and the sine of phase p (2p the exponential of an exponent), atoms come next.
#ifndef RESONFORM_RUNTIME_KERNEL_VIEW
#define RESONFORM_RUNTIME_KERNEL_VIEW

#include "runtime/report.hpp"
#include "runtime/status.hpp"

#include <cstddef>

namespace resonform {

namespace kernel {

inline constexpr unsigned group = 8;           // rows side by side in a piece, whatever the width
inline constexpr unsigned most_outputs = 16;   // of one table
inline constexpr unsigned most_factors = 1024; // cosines and sines, or slots
inline constexpr unsigned most_rows = 4096;
inline constexpr unsigned no_factor = 0xffff; // of a row without a phase
// 1.5*2^52: adding it to a double below 2^51 rounds that to a whole number, which stands in the last bits of
// the sum.
inline constexpr double rounding_shift = 6755399441055744;

struct Row {                                // coefficients, highest power first, are `group` numbers apart
    unsigned offset, degree, factor, place; // place: among the rows of all groups
    unsigned long long outputs = ~0ULL;     // of an atom: which need it; `factor` is its slot
};
// g: slots, k: constants.
enum class Kind : unsigned char {
    product,           // g[to] = g[a] g[b]
    scaled,            // k[a] g[b]
    sum,               // g[a] + g[b]
    difference,        // g[a] - g[b]
    shifted,           // k[a] + g[b]
    multiply_add,      // g[c] + g[a] g[b]
    multiply_subtract, // g[c] - g[a] g[b]
    scaled_add,        // g[c] + k[a] g[b]
    scaled_subtract,   // g[c] - k[a] g[b]
    constant           // k[a]
};
struct Operation {
    Kind kind = Kind::constant;
    unsigned short to = 0, a = 0, b = 0, c = 0;
    unsigned long long outputs = 0; // which need it
};
// e^{i a} e^{+-i b}: the angles are those of factors 2a, 2a + 1 (cosine, sine).
struct Step {
    unsigned to, from, by;
    double sign;                // of the angle that is added
    unsigned long long outputs; // which need it
    unsigned long long lasting; // which need it where no exponential is left
};
struct Output {
    unsigned first,
        count;       // rows; one without a factor is the last, so that its size rounds as little as may be
                     // (of operations: `first` is the slot of the output)
    unsigned fading; // of them, the first ones: those that decay
};
// Offsets in a piece. wide = 0: q (degree + 1 coefficients), w by halves, whole quarter turns. Else the plain
// coefficients of d^wide+1 ..., the pairs from d^wide to d, the constant, whole quarter turns.
struct PhaseRow {
    unsigned offset, degree, wide, harmonic;
    bool exponent;
    unsigned long long outputs, lasting; // as of a step
};
struct Group {
    unsigned offset, degree;
};

struct View {
    const double* pieces = nullptr; // the left edge is the first number of each
    std::size_t stride = 0;
    int last = 0;                                   // piece
    int faded = 0;                                  // from this piece on no exponential is left
    double per_width = 0, to_local = 0, middle = 0; // v = to_local d - middle; to_local is a power of two
    double begin = 0, reach = 0, precise = 0;       // times that are answered; the last of them that is ok
    unsigned phases = 0, steps = 0, rows = 0, outputs = 0, groups = 0;
    const PhaseRow* phase = nullptr;
    const Step* step = nullptr;
    const Row* row = nullptr;
    const Output* output = nullptr;
    const Group* groups_of_rows = nullptr;
    unsigned operations = 0;
    const Operation* operation = nullptr;
    const double* constant = nullptr; // null: outputs are sums of rows
    double shortest_period = 0;       // of any harmonic that lasts, in t
    double shortest_layer = 0;        // 2 pi over the largest |chi' + i theta'| of all that fades
};

// Who answers for t + low where the tables do not: beyond their reach, or with less than full precision.
struct Direct {
    const void* evaluator;
    Status (*at)(const void* evaluator, double t, double low, double* values) noexcept;
};

} // namespace kernel
} // namespace resonform

#endif
