// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/series/series.hpp"

namespace resonform {

Series multiply(const Ring& ring, const Series& a, const Series& b, int through) {
    Series result;
    for (int n = 0; n <= through; ++n) {
        std::vector<Product> products;
        for (int j = std::max(0, n - b.through()); j <= std::min(n, a.through()); ++j)
            products.push_back({1, &a.part(j), &b.part(n - j)});
        result.set(n, ring.dot(products));
    }
    return result;
}

} // namespace resonform
