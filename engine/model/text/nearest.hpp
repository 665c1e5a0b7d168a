// SPDX-License-Identifier: GPL-3.0-or-later
// The known name that a misspelt one most likely means.
#pragma once

#include <string>
#include <vector>

namespace resonform {

// The known name nearest to `name` by edit distance (insert, delete, replace, swap neighbours), at
// most 1 + (length - 1)/3 away; the first of equals; "" if there is none.
//   nearest("oder", {"order", "outputs"}) = "order"
std::string nearest(const std::string& name, const std::vector<std::string>& known);

// The hint for an unknown name: "did you mean 'order'? Known are: order, outputs" (at most 20 listed).
std::string suggest(const std::string& name, const std::vector<std::string>& known);

} // namespace resonform
