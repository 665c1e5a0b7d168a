// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/signs/pairs_of_terms.hpp"

#include "model/text/canonical.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

namespace resonform {

namespace {

using GiNaC::ex;
using GiNaC::numeric;

constexpr std::size_t most_pairable = 400; // terms, after all have one degree
constexpr int highest_degree = 8;          // in the sine and cosine of one argument

using Powers = std::vector<int>; // of the atoms

class Pairs {
public:
    Pairs(const ProvedOf& positive, const ProvedOf& real) : positive_(positive), real_(real) {}

    bool prove(const ex& e) {
        if (!read(e)) return false;
        for (std::size_t a = 0; a < atoms_.size(); ++a)
            if (!make_homogeneous(a)) return false;
        return settle();
    }

private:
    std::size_t atom(const ex& e) {
        const auto found =
            std::find_if(atoms_.begin(), atoms_.end(), [&](const ex& a) { return a.is_equal(e); });
        if (found != atoms_.end()) return static_cast<std::size_t>(found - atoms_.begin());
        atoms_.push_back(e);
        return atoms_.size() - 1;
    }

    // Into powers of atoms that are positive or real.
    bool read(const ex& e) {
        std::vector<std::pair<std::map<std::size_t, int>, numeric>> read;
        const std::vector<ex> addends = operands(e);
        for (const ex& addend : addends) {
            std::map<std::size_t, int> powers;
            numeric number = 1;
            const auto take = [&](const ex& factor) {
                if (factor.info(GiNaC::info_flags::rational)) {
                    number *= GiNaC::ex_to<numeric>(factor);
                } else if (GiNaC::is_a<GiNaC::power>(factor) &&
                           factor.op(1).info(GiNaC::info_flags::posint)) {
                    powers[atom(factor.op(0))] += GiNaC::ex_to<numeric>(factor.op(1)).to_int();
                } else {
                    ++powers[atom(factor)];
                }
            };
            if (GiNaC::is_a<GiNaC::mul>(addend))
                for (const ex& factor : operands(addend)) take(factor);
            else
                take(addend);
            read.emplace_back(std::move(powers), number);
        }
        for (std::size_t a = 0, n = atoms_.size(); a < n; ++a) partner(a); // may bring one that no term has
        for (const auto& [powers, number] : read) {
            Powers all(atoms_.size(), 0);
            for (const auto& [a, n] : powers) all[a] = n;
            terms_[all] += number;
        }
        for (const ex& a : atoms_) positives_.push_back(positive_(a));
        for (std::size_t a = 0; a < atoms_.size(); ++a)
            if (!positives_[a] && !real_(atoms_[a])) return false;
        return true;
    }

    // The sine that belongs to a cosine.
    std::optional<std::size_t> partner(std::size_t cosine) {
        const ex function = atoms_[cosine];
        if (!GiNaC::is_a<GiNaC::function>(function) ||
            GiNaC::ex_to<GiNaC::function>(function).get_name() != "cos")
            return std::nullopt;
        return atom(GiNaC::sin(function.op(0)));
    }

    // Terms times sin^2 + cos^2 until all have the highest degree; as they are, where degrees are even and
    // odd.
    bool make_homogeneous(std::size_t cosine) {
        const auto sine = partner(cosine);
        if (!sine) return true;
        const auto degree = [&](const Powers& powers) { return powers[cosine] + powers[*sine]; };
        int highest = 0;
        for (const auto& [powers, number] : terms_) highest = std::max(highest, degree(powers));
        if (highest > highest_degree) return false;
        for (const auto& [powers, number] : terms_)
            if ((highest - degree(powers)) % 2 != 0) return true;
        std::map<Powers, numeric> result;
        for (const auto& [powers, number] : terms_) {
            const int missing = (highest - degree(powers)) / 2;
            for (int k = 0; k <= missing; ++k) {
                Powers higher = powers;
                higher[cosine] += 2 * k;
                higher[*sine] += 2 * (missing - k);
                result[higher] += number * GiNaC::binomial(numeric(missing), numeric(k));
            }
        }
        terms_ = std::move(result);
        return terms_.size() <= most_pairable;
    }

    // A term that is not negative wherever its atoms are what they are known to be.
    [[nodiscard]] bool is_square(const Powers& powers) const {
        for (std::size_t a = 0; a < powers.size(); ++a)
            if (!positives_[a] && powers[a] % 2 != 0) return false;
        return true;
    }

    // Whatever the sign of a term is that is no square, its size is what counts.
    bool settle() {
        std::vector<std::pair<Powers, numeric>> wanting;
        std::map<Powers, numeric> squares;
        for (const auto& [powers, number] : terms_) {
            if (number.is_zero()) continue;
            if (is_square(powers) && number.is_positive())
                squares[powers] = number;
            else
                wanting.emplace_back(powers, GiNaC::abs(number));
        }
        return std::all_of(wanting.begin(), wanting.end(),
                           [&](const auto& term) { return settle(term.first, term.second, squares); });
    }

    // p a + q b - c sqrt(a b) >= 0 where 4 p q >= c^2: takes what is needed of two squares.
    static bool settle(const Powers& middle, numeric wanted, std::map<Powers, numeric>& squares) {
        for (auto& [low, p] : squares) {
            if (wanted.is_zero()) break;
            Powers opposite = middle;
            for (std::size_t a = 0; a < middle.size(); ++a) opposite[a] = 2 * middle[a] - low[a];
            const auto other = squares.find(opposite);
            if (other == squares.end() || other->first == low || p.is_zero() || other->second.is_zero())
                continue;
            numeric& q = other->second;
            const numeric even = wanted / 2;
            if (p >= even && q >= even) {
                p -= even;
                q -= even;
                wanted = 0;
            } else if (4 * p * q >= wanted * wanted) {
                numeric& scarce = p < q ? p : q;
                numeric& ample = p < q ? q : p;
                ample -= wanted * wanted / (4 * scarce);
                scarce = 0;
                wanted = 0;
            } else {
                const numeric part = std::min(p, q); // what this pair gives at least
                p -= part;
                q -= part;
                wanted -= 2 * part;
            }
        }
        return wanted.is_zero();
    }

    const ProvedOf &positive_, &real_;
    std::vector<ex> atoms_;
    std::vector<bool> positives_;
    std::map<Powers, numeric> terms_;
};

} // namespace

bool nonnegative_by_pairs(const ex& e, const ProvedOf& positive, const ProvedOf& real) {
    const ex sum = e.expand();
    if (!GiNaC::is_a<GiNaC::add>(sum) || sum.nops() > most_pairable) return false;
    return Pairs(positive, real).prove(sum);
}

} // namespace resonform
