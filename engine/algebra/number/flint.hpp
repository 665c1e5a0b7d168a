// SPDX-License-Identifier: GPL-3.0-or-later
// Integers of CLN as those of GMP and FLINT and back, limb by limb: through decimal text it takes four to ten
// times as long.
#pragma once

#include "algebra/number/number.hpp"

#include <flint/fmpz.h>
#include <gmpxx.h>

#include <cstddef>

namespace resonform {

mpz_class to_mpz(const Integer& value);

// The least significant limb first.
Integer from_limbs(const mp_limb_t* limbs, std::size_t count);

// An integer of FLINT, which frees nothing by itself.
class Whole {
public:
    explicit Whole(slong value = 0) { fmpz_init_set_si(value_, value); }
    explicit Whole(const Integer& value);
    Whole(const Whole& other) { fmpz_init_set(value_, other.value_); }
    Whole& operator=(const Whole& other) {
        fmpz_set(value_, other.value_);
        return *this;
    }
    ~Whole() { fmpz_clear(value_); }

    [[nodiscard]] fmpz* get() { return value_; }
    [[nodiscard]] const fmpz* get() const { return value_; }
    [[nodiscard]] Integer value() const;

private:
    fmpz_t value_;
};

} // namespace resonform
