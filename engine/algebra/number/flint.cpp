// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/flint.hpp"

namespace resonform {

static_assert(GMP_NUMB_BITS == 64, "integers are read and written in limbs of 64 bits");

namespace {

bool is_small(const Integer& value) { return cln::integer_length(value) < 63; }

void assign(mpz_ptr target, const Integer& value) {
    const Integer size = cln::abs(value);
    const auto count = static_cast<mp_size_t>((cln::integer_length(size) + 63) / 64);
    mp_limb_t* limbs = mpz_limbs_write(target, count);
    for (mp_size_t k = 0; k < count; ++k)
        limbs[k] = cln::cl_I_to_UQ(cln::ldb(size, cln::cl_byte(64, static_cast<uintC>(64 * k))));
    mpz_limbs_finish(target, cln::minusp(value) ? -count : count);
}

} // namespace

mpz_class to_mpz(const Integer& value) {
    if (is_small(value)) return cln::cl_I_to_long(value);
    mpz_class result;
    assign(result.get_mpz_t(), value);
    return result;
}

Integer from_limbs(const mp_limb_t* limbs, std::size_t count) {
    if (count > 16) { // by halves: one by one, each step would copy all limbs before it
        const std::size_t low = count / 2;
        return cln::ash(from_limbs(limbs + low, count - low), static_cast<sintC>(64 * low)) +
               from_limbs(limbs, low);
    }
    Integer value = 0;
    for (std::size_t k = count; k-- > 0;) value = cln::ash(value, 64) + Integer(limbs[k]);
    return value;
}

Whole::Whole(const Integer& value) {
    fmpz_init(value_);
    if (is_small(value))
        fmpz_set_si(value_, cln::cl_I_to_long(value));
    else
        assign(_fmpz_promote(value_), value);
}

Integer Whole::value() const {
    if (!COEFF_IS_MPZ(*value_)) return Integer(static_cast<long>(*value_));
    const mpz_srcptr large = COEFF_TO_PTR(*value_);
    const Integer size = from_limbs(mpz_limbs_read(large), mpz_size(large));
    return mpz_sgn(large) < 0 ? -size : size;
}

} // namespace resonform
