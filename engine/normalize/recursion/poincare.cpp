// SPDX-License-Identifier: GPL-3.0-or-later
#include "normalize/recursion/poincare.hpp"

#include "algebra/number/error.hpp"
#include "expand/expansion/graded_field.hpp"
#include "normalize/recursion/normalizer.hpp"

namespace resonform {

namespace {

constexpr int largest_weight = 99;

// Each monomial by itself: nonresonant ones go into the correction, the others stay in the normal form.
template <class Domain> class PoincareStyle : public HomologicalStyle<Domain> {
public:
    using Part = typename Domain::Part;
    using Equations = typename HomologicalStyle<Domain>::Equations;

    explicit PoincareStyle(const Domain& domain) : domain_(domain) {}

    void solve(int weight, const Equations& equations, const std::vector<Part>& right) const override {
        for (std::size_t k = 0; k < equations.size(); ++k) {
            auto shares = equations[k]->divided(weight, right[k]);
            equations[k]->accept(weight, std::move(shares.quotient),
                                 domain_.combination({{1, &shares.exact}, {1, &shares.near}}));
        }
    }

private:
    Domain domain_;
};

} // namespace

void check_order(const GradedField& field, int through) {
    const System& system = field.system();
    const std::string order = to_string(system.weight(through));
    if (through < 1 || through > largest_weight * system.eps_root)
        bad_input({fmt::format("the order of a normal form is from 1 to {}", largest_weight),
                   order,
                   "choose an order in this range",
                   {}});
    for (const Variable& v : system.variables)
        if (v.weight > through)
            bad_input(
                {"the order of a normal form is not below the weight of a fast variable",
                 fmt::format("order {}, {} has weight {}", order, v.name, to_string(system.weight(v.weight))),
                 "choose a higher order, or scale eps", v.place});
}

Normalization normalize_poincare(std::shared_ptr<const GradedField> field, int through,
                                 const NormalizeOptions& options) {
    check_order(*field, through);
    return normalize_in_ring(std::move(field), through, options, [](const GradedField& f) {
        return std::make_unique<PoincareStyle<RingDomain>>(RingDomain(f.ring));
    });
}

NormalizationOf<NumberPart> normalize_over(const std::shared_ptr<const GradedField>& field, int through,
                                           const NumberDomain& domain, const NormalizeOptions& options) {
    check_order(*field, through);
    Normalizer<NumberDomain> normalizer(field, domain, std::make_unique<PoincareStyle<NumberDomain>>(domain),
                                        through);
    static_cast<void>(advance_through(normalizer, through, options)); // none missing: balls exclude 0
    return normalizer.result();
}

GraphNormalization normalize_in_graph(std::shared_ptr<const GradedField> field, int through,
                                      const NormalizeOptions& options) {
    check_order(*field, through);
    field = with_derivatives(std::move(field), through + 1);
    const GraphDomain domain(field->ring, through + 1);
    Normalizer<GraphDomain> normalizer(field, domain, std::make_unique<PoincareStyle<GraphDomain>>(domain),
                                       through);
    NormalizeOptions counted;
    if (options.progress)
        counted.progress = [&](int weight, std::size_t) { options.progress(weight, domain.graph().terms()); };
    static_cast<void>(advance_through(normalizer, through, counted)); // a graph divides by any node
    return {domain, normalizer.result()};
}

} // namespace resonform
