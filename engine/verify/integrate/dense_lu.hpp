// SPDX-License-Identifier: GPL-3.0-or-later
// P D A = L U of a dense matrix in double, D dividing each row by its largest entry: rows of a stiff system
// differ by the stiffness, and pivots are to be compared without it (G. H. Golub and C. F. Van Loan, Matrix
// Computations, 4th ed., sections 3.4 and 3.5.2).
#pragma once

#include <cstddef>
#include <vector>

namespace resonform {

class DenseLu {
public:
    // matrix: square, row by row. False if it is singular or holds what is no number.
    bool factor(std::vector<double> matrix);
    // A x = b in place.
    void solve(std::vector<double>& b) const;

private:
    [[nodiscard]] bool scale_rows();
    // Brings the largest entry of column k on and below the diagonal onto it. False if there is none.
    bool pivot(std::size_t k);

    std::size_t size_ = 0;
    std::vector<double> lu_, row_factors_;
    std::vector<std::size_t> rows_; // rows_[k]: the row of A that became row k
};

} // namespace resonform
