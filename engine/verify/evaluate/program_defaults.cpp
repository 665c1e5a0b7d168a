// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/evaluate/program_defaults.hpp"

#include "emit/program/prune.hpp"
#include "verify/evaluate/graph_walk.hpp"
#include "verify/run/real.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace resonform {

namespace {

// Of nodes in eps and parameters.
template <class Real>
std::vector<Real> values_of(const std::vector<Graph::Node>& roots, const Program& program, const Real& eps,
                            const std::vector<Real>& parameters, const NodeNumbers* numbers) {
    GraphWalk<Scaled<Real>> walk(program.graph, numbers);
    walk.set(program.eps, Scaled<Real>(eps));
    for (std::size_t k = 0; k < parameters.size(); ++k)
        walk.set(program.parameters[k].symbol, Scaled<Real>(parameters[k]));
    const std::vector<bool> used = reachable(program.graph, roots);
    std::vector<Graph::Node> nodes;
    for (std::size_t n = 0; n < used.size(); ++n)
        if (used[n]) nodes.push_back(static_cast<Graph::Node>(n));
    walk.compute(nodes);
    std::vector<Real> values;
    for (const Graph::Node n : roots) values.push_back(walk[n].value());
    return values;
}

} // namespace

template <class Real>
std::vector<Real> default_parameters(const Program& program, Real, const NodeNumbers* numbers) {
    std::vector<Real> values;
    for (const ProgramInput& input : program.parameters)
        values.push_back(input.default_value < 0 ? math::not_a_number<Real>()
                         : numbers != nullptr
                             ? to_number<Real>((*numbers)[static_cast<std::size_t>(input.default_value)])
                             : to_number<Real>(program.graph.at(input.default_value).value));
    return values;
}

template <class Real>
std::vector<Real> default_start(const Program& program, Real eps, const std::vector<Real>& parameters,
                                const NodeNumbers* numbers) {
    std::vector<Graph::Node> roots;
    for (const ProgramInput& input : program.start) roots.push_back(input.default_value);
    return values_of(roots, program, eps, parameters, numbers);
}

template <class Real>
Real default_slow_time_end(const Program& program, Real eps, const std::vector<Real>& parameters,
                           const NodeNumbers* numbers) {
    return values_of({program.slow_time_end}, program, eps, parameters, numbers).front();
}

template <class Real>
ProgramArguments<Real> program_arguments(const Program& program, Real eps, const GivenArguments& given,
                                         const NodeNumbers* numbers) {
    ProgramArguments<Real> arguments{default_parameters(program, eps, numbers), {}};
    for (std::size_t k = 0; k < program.parameters.size(); ++k)
        if (const auto at = given.find(program.parameters[k].name); at != given.end())
            arguments.parameters[k] = Real(at->second);
    arguments.start = default_start(program, eps, arguments.parameters, numbers);
    for (std::size_t k = 0; k < program.start.size(); ++k)
        if (const auto at = given.find(program.start[k].canonical); at != given.end())
            arguments.start[k] = Real(at->second);
    return arguments;
}

template ProgramArguments<double> program_arguments(const Program&, double, const GivenArguments&,
                                                    const NodeNumbers*);
template ProgramArguments<long double> program_arguments(const Program&, long double, const GivenArguments&,
                                                         const NodeNumbers*);
template ProgramArguments<Float128> program_arguments(const Program&, Float128, const GivenArguments&,
                                                      const NodeNumbers*);

#define RESONFORM_INSTANTIATE(Real)                                                                          \
    template std::vector<Real> default_parameters(const Program&, Real, const NodeNumbers*);                 \
    template std::vector<Real> default_start(const Program&, Real, const std::vector<Real>&,                 \
                                             const NodeNumbers*);                                            \
    template Real default_slow_time_end(const Program&, Real, const std::vector<Real>&, const NodeNumbers*);

RESONFORM_INSTANTIATE(double)
RESONFORM_INSTANTIATE(long double)
RESONFORM_INSTANTIATE(Float128)
RESONFORM_INSTANTIATE(boost::multiprecision::cpp_bin_float_50)
RESONFORM_INSTANTIATE(boost::multiprecision::cpp_bin_float_100)

#undef RESONFORM_INSTANTIATE

} // namespace resonform
