// SPDX-License-Identifier: Apache-2.0
// Swept stems as a field, for hero culms that are carved or joined with rock.
#pragma once

#include <vug/field/field.h>
#include <vug/flora/tube.h>

namespace vug::flora {

/// The union of all tubes: a 1-Lipschitz lower bound of the distance whose zero set is exactly the
/// surface that sweep_mesh.h triangulates. Far from a stem it is the exact distance to the
/// enclosing cones; near it, it is the distance to the displaced surface divided by the Lipschitz
/// constant of the displacement. Boxes around stems, and around their segments, cull whatever
/// cannot be nearest. Without tubes it is the empty field.
field::Field swept(std::vector<Tube> tubes);

/// The tubes of a field created by `swept`; empty for any other field.
std::vector<Tube> tubes_of(const field::Field& field);

}  // namespace vug::flora
