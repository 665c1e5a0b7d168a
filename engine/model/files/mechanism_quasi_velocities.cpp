// SPDX-License-Identifier: GPL-3.0-or-later
// [quasi_velocities] of a mechanism, and forces on them.
#include "algebra/number/error.hpp"
#include "model/files/mechanism_reader.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/toml_values.hpp"

#include <algorithm>

namespace resonform {

using GiNaC::ex;

// A quasi-velocity that is a variable of the system has the symbols of that variable.
void MechanismReader::read_quasi_velocities() {
    const TomlNode* table = root_.find("quasi_velocities");
    if (table == nullptr) return;
    check_table(*table);
    for (const TomlEntry& entry : table->entries) {
        const auto is_named_so = [&](const Coordinate& c) { return c.name == entry.key; };
        if (std::any_of(mechanism_.coordinates.begin(), mechanism_.coordinates.end(), is_named_so) ||
            std::any_of(mechanism_.prescribed.begin(), mechanism_.prescribed.end(),
                        [&](const Prescribed& p) { return is_named_so(p.coordinate); }))
            bad_input({"the name of the quasi-velocity is taken",
                       in_quotes(entry.key) + " is a coordinate or prescribed", "choose another name",
                       entry.place});
        const Coordinate symbols = coordinate_of(entry);
        const TomlNode& form = entry.value;
        mechanism_.quasi_velocities.push_back({entry.key,
                                               symbols.unit,
                                               symbols.at,
                                               symbols.velocity,
                                               {expression_of(form, moving()), form.text, form.source},
                                               entry.place});
    }
}

// The power of the force is value * u: on each coordinate the force is value * du/dx'.
bool MechanismReader::add_force_on_quasi_velocity(const TomlEntry& entry) {
    for (const QuasiVelocity& u : mechanism_.quasi_velocities) {
        if (u.name != entry.key) continue;
        const ex value = expression_of(entry.value, moving());
        for (std::size_t k = 0; k < mechanism_.coordinates.size(); ++k) {
            const ex slope = u.form.value.diff(mechanism_.coordinates[k].velocity);
            if (!slope.is_zero()) mechanism_.forces.push_back({k, value * slope, entry.value.source});
        }
        return true;
    }
    return false;
}

} // namespace resonform
