// SPDX-License-Identifier: GPL-3.0-or-later
// The normal form and map that a certificate substitutes at a point: themselves, or, for coefficients in a
// graph, the same with the values of the coefficients.
#pragma once

#include "algebra/graph/replay.hpp"
#include "certify/points/point.hpp"
#include "normalize/recursion/normal_form.hpp"

#include <vector>

namespace resonform {

class RingSource {
public:
    RingSource(const NormalForm& normal_form, const NearIdentityMap& map)
        : normal_form_(normal_form), map_(map) {}

    // How many points may be substituted together.
    static constexpr std::size_t together = PointReader::most_points;
    void go_to(const Point& /*point*/) {}
    [[nodiscard]] const NormalForm& normal_form() const { return normal_form_; }
    [[nodiscard]] const NearIdentityMap& map() const { return map_; }
    // By how much the coefficients raise the probability of an error at a point.
    [[nodiscard]] double error() const { return 0; }

private:
    const NormalForm& normal_form_;
    const NearIdentityMap& map_;
};

// Coefficients are evaluated afresh at each point, without the values by which the graph was made. Where slow
// variables occur, a coefficient c is replaced by c + c' (zeta - zeta_0): a certificate needs no more of it.
class GraphSource {
public:
    explicit GraphSource(const GraphNormalization& normalization);

    static constexpr std::size_t together = 1;
    // Throws UnluckyPoint where a divisor is zero.
    void go_to(const Point& point);
    [[nodiscard]] const NormalForm& normal_form() const { return normal_form_; }
    [[nodiscard]] const NearIdentityMap& map() const { return map_; }
    // The residual of weight n is a sum of products of n coefficients and other factors of the equations;
    // over their common denominator its degree and height are at most n times those of one coefficient.
    [[nodiscard]] double error() const;

private:
    // A term of a sample: residue * monomial (* (zeta - zeta_0)).
    struct Slot {
        std::size_t series;
        int weight;
        Monomial monomial;
        GeneratorId slow; // -1: the coefficient itself
    };
    void add(const BasicSeries<GraphPart>& series);
    void add(const GraphPart& part, std::size_t series, int weight, GeneratorId slow);
    void distribute(std::vector<Series> series);
    [[nodiscard]] std::vector<Residue> values_at(const Point& point) const;

    const GraphNormalization& normalization_;
    std::size_t series_ = 0;
    std::vector<Slot> slots_;
    std::vector<Coefficient> coefficients_;
    NormalForm normal_form_;
    NearIdentityMap map_;
};

} // namespace resonform
