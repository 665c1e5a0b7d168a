// SPDX-License-Identifier: GPL-3.0-or-later
// The coefficients of normal form and map that a program reads.
#pragma once

#include "certify/points/plan.hpp"
#include "certify/points/reader.hpp"

#include <array>
#include <span>
#include <vector>

namespace resonform {

// The series that a program reads, at some points, by one pass over their terms.
class PointReadings {
public:
    // Through weight `through`. Throws UnluckyPoint. Points: 1 ... PointReader::most_points.
    PointReadings(const CertificatePlan& plan, const NormalForm& normal_form, const NearIdentityMap& map,
                  const std::vector<Point>& points, int through);

    // The coefficient of t^weight by point, in Montgomery's form.
    struct Coefficient {
        Slot slot;
        int weight;
        std::array<Residue, PointReader::most_points> value;
    };
    [[nodiscard]] const std::vector<Coefficient>& coefficients() const { return coefficients_; }

private:
    struct Part {
        const CertificatePlan::Reading* reading;
        const Fractions* numbers;
    };

    void read(const Ring& ring, std::span<const Point> points, std::size_t first);

    std::vector<Part> parts_;
    std::vector<Coefficient> coefficients_; // of the parts, one after the other
};

// The series that a name stands for.
const Series& series_of(SeriesName name, const CertificateProgram& program, const NormalForm& normal_form,
                        const NearIdentityMap& map);

} // namespace resonform
