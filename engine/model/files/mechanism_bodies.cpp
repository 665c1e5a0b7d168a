// SPDX-License-Identifier: GPL-3.0-or-later
// [bodies] of a mechanism: in a plane by their angle, in space by Euler's angles.
#include "algebra/number/error.hpp"
#include "model/files/mechanism_reader.hpp"
#include "model/text/diagnostic.hpp"
#include "model/text/toml_values.hpp"

namespace resonform {

using GiNaC::ex;

void MechanismReader::read_body(const TomlEntry& entry) {
    const TomlNode* attitude = entry.value.find("attitude");
    if (attitude == nullptr) {
        PlaneBody body{particle_of(entry, {"mass", "position", "inertia", "angle", "attitude"}), 0, 0};
        body.inertia = inertia_of(needed(entry, "inertia"), "a moment of inertia");
        body.angle = needed(entry, "angle", at_rest());
        mechanism_.plane_bodies.push_back(std::move(body));
        return;
    }
    SpatialBody body{particle_of(entry, {"mass", "position", "inertia", "attitude"}), {}, {}};
    for (const TomlNode& moment : three(entry, "inertia"))
        body.inertia.push_back(inertia_of(moment, "a moment of inertia"));
    std::vector<ex> angles;
    for (const TomlNode& angle : three(entry, "attitude")) angles.push_back(part_of(angle, at_rest()).value);
    body.spin = spin_of(angles);
    mechanism_.spatial_bodies.push_back(std::move(body));
}

const std::vector<TomlNode>& MechanismReader::three(const TomlEntry& entry, const std::string& key) const {
    const TomlNode* node = entry.value.find(key);
    if (node == nullptr || node->type != TomlNode::Type::array || node->items.size() != 3)
        bad_input({"a body in space needs three principal moments of inertia and three Euler angles",
                   in_quotes(entry.key),
                   "write inertia = [\"A\", \"B\", \"C\"], attitude = [\"psi\", \"theta\", \"phi\"]",
                   node == nullptr ? entry.place : place_of(node->source)});
    return node->items;
}

ex MechanismReader::rate_of(const ex& position) const {
    ex rate = 0;
    for (const Coordinate& c : mechanism_.coordinates) rate += position.diff(c.at) * c.velocity;
    for (const Prescribed& p : mechanism_.prescribed)
        rate += position.diff(p.coordinate.at) * p.coordinate.velocity;
    return rate;
}

// Precession about the vertical, nutation about the line of nodes, rotation about the third axis of the body.
std::vector<ex> MechanismReader::spin_of(const std::vector<ex>& angles) const {
    const ex precession = rate_of(angles[0]), nutation = rate_of(angles[1]), rotation = rate_of(angles[2]);
    const ex sine = GiNaC::sin(angles[2]), cosine = GiNaC::cos(angles[2]);
    return {precession * GiNaC::sin(angles[1]) * sine + nutation * cosine,
            precession * GiNaC::sin(angles[1]) * cosine - nutation * sine,
            precession * GiNaC::cos(angles[1]) + rotation};
}

} // namespace resonform
