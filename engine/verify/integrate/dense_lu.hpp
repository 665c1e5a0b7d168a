// SPDX-License-Identifier: GPL-3.0-or-later
// P D A = L U of a dense matrix in double by SUNDIALS, D dividing each row by its largest entry: rows of a
// stiff system differ by the stiffness, and pivots are to be compared without it (G. H. Golub and C. F. Van
// Loan, Matrix Computations, 4th ed., section 3.5.2).
#pragma once

#include <sundials/sundials_dense.h>

#include <cstddef>
#include <vector>

namespace resonform {

class DenseLu {
public:
    DenseLu() = default;
    DenseLu(const DenseLu&) = delete; // columns_ are places in lu_
    DenseLu& operator=(const DenseLu&) = delete;

    // matrix: square, row by row. False if it is singular, or holds NaN or infinity.
    bool factor(const std::vector<double>& matrix);
    // A x = b in place. Precondition: factor() returned true.
    void solve(std::vector<double>& b);

private:
    [[nodiscard]] bool scale_rows(const std::vector<double>& matrix);

    std::size_t size_ = 0;
    std::vector<double> lu_, row_factors_; // column by column
    std::vector<double*> columns_;
    std::vector<sunindextype> pivots_;
};

} // namespace resonform
