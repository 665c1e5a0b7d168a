// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/number/limbs.hpp"

#include <algorithm>

namespace resonform {

static_assert(GMP_NUMB_BITS == 64, "integers are read and written in limbs of 64 bits");

mpz_class to_mpz(const Integer& value) {
    if (cln::integer_length(value) < 63) return cln::cl_I_to_long(value);
    const Integer size = cln::abs(value);
    mpz_class result;
    const std::size_t limbs = (cln::integer_length(size) + 63) / 64;
    mp_limb_t* target =
        mpz_limbs_write(result.get_mpz_t(), static_cast<mp_size_t>(std::max<std::size_t>(limbs, 1)));
    for (std::size_t k = 0; k < limbs; ++k)
        target[k] = cln::cl_I_to_UQ(cln::ldb(size, cln::cl_byte(64, static_cast<uintC>(64 * k))));
    mpz_limbs_finish(
        result.get_mpz_t(),
        static_cast<mp_size_t>(cln::minusp(value) ? -static_cast<long>(limbs) : static_cast<long>(limbs)));
    return result;
}

Integer from_limbs(const mp_limb_t* limbs, std::size_t count) {
    Integer value = 0;
    for (std::size_t k = count; k-- > 0;) value = cln::ash(value, 64) + Integer(limbs[k]);
    return value;
}

} // namespace resonform
