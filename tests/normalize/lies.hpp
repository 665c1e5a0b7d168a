// SPDX-License-Identifier: GPL-3.0-or-later
// Lies about a normalisation, of which the certificate must find each.
#pragma once

#include "normalize/certified.hpp"

#include <gtest/gtest.h>

namespace resonform::test {

inline Polynomial with_coefficient(const Polynomial& p, std::size_t k, const Rational& value) {
    std::vector<Term> terms = p.terms();
    terms[k].coefficient = value;
    return Polynomial::from_terms(std::move(terms));
}

// Changes every coefficient: + 1, the other sign, dropped. certify(n) is its certificate.
template <class Certify> int expect_all_lies_found(Normalization n, const Certify& certify) {
    int lies = 0;
    for (const SeriesOfForm& item : all_series(n)) {
        for (int weight = 0; weight <= item.series->through(); ++weight) {
            const Polynomial truth = item.series->part(weight);
            for (std::size_t k = 0; k < truth.size(); ++k) {
                const Rational c = truth.terms()[k].coefficient;
                for (const Rational& lie : {Rational(c + 1), Rational(-c), Rational(0)}) {
                    item.series->set(weight, with_coefficient(truth, k, lie));
                    EXPECT_FALSE(certify(n).holds) << item.name << ", weight " << weight << ", term " << k
                                                   << ": " << to_string(c) << " -> " << to_string(lie);
                    ++lies;
                }
            }
            item.series->set(weight, truth);
        }
    }
    EXPECT_TRUE(certify(n).holds) << certify(n).complaint;
    return lies;
}

inline int expect_all_lies_found(Normalization n) {
    return expect_all_lies_found(std::move(n), [](const Normalization& lie) { return certificate_of(lie); });
}

} // namespace resonform::test
