// SPDX-License-Identifier: GPL-3.0-or-later
// The constants of an emitted evaluator as numbers of any range, and the first of them that does not fit into
// the evaluator's real type, which its status names.
#pragma once

#include "runtime/scaled.hpp"
#include "verify/evaluate/graph_function.hpp"
#include "verify/evaluate/graph_walk.hpp"
#include "verify/evaluate/interpretation.hpp"
#include "verify/run/spline.hpp"

#include <functional>
#include <map>
#include <vector>

namespace resonform {

template <class Number> class ConstantWalk {
public:
    // `inputs`: eps, parameters and start values by their symbols.
    ConstantWalk(const Interpretation& shared, const std::map<Graph::Node, Number>& inputs)
        : plan_(&shared.plan), numbers_(&shared.plan_numbers), values_(shared.plan.code.size()) {
        std::vector<StraightLine::Value> roots;
        for (const auto& member : plan_->members) roots.push_back(member.first);
        for (const StraightLine::Value v : plan_->code.behind(roots, true))
            values_[static_cast<std::size_t>(v)] = value(v, inputs);
    }

    // The status of the construction, as in emitted code.
    [[nodiscard]] Cause cause() const {
        Keeper keep;
        for (const auto& [v, reader] : plan_->kept) {
            Number kept;
            keep(values_[static_cast<std::size_t>(v)], kept, reader.c_str());
        }
        return keep.cause;
    }

private:
    using Wide = Scaled<Number>;

    Wide value(StraightLine::Value v, const std::map<Graph::Node, Number>& inputs) const {
        using namespace resonform::math;
        const StraightLine::Instruction& i = plan_->code.at(v);
        const auto x = [&](std::size_t k) { return values_[static_cast<std::size_t>(i.operands[k])]; };
        const std::size_t positive = i.operands.size() - i.negative;
        Wide result(i.op == StraightLine::Op::multiply ? 1 : 0);
        switch (i.op) {
        case StraightLine::Op::number: return to_number<Wide>((*numbers_)[static_cast<std::size_t>(v)]);
        case StraightLine::Op::symbol: return Wide(inputs.at(i.symbol));
        case StraightLine::Op::add:
            for (std::size_t k = 0; k < i.operands.size(); ++k)
                result = k < positive ? result + x(k) : result - x(k);
            return result;
        case StraightLine::Op::multiply:
            for (std::size_t k = 0; k < i.operands.size(); ++k) result = result * x(k);
            return result;
        case StraightLine::Op::reciprocal: return Wide(1) / x(0);
        case StraightLine::Op::root: return i.index == 2 ? sqrt(x(0)) : root(x(0), i.index);
        case StraightLine::Op::doubled: return x(0); // only its range is asked
        case StraightLine::Op::function: break;
        }
        if (i.data != nullptr) return spline(spline_of(*i.data), i.index, x(0));
        return graph_function(i.function, x(0), x(i.operands.size() - 1));
    }

    const CppPlan* plan_;
    const std::vector<BinaryParts>* numbers_;
    std::vector<Wide> values_;
};

} // namespace resonform
