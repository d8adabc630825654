// Swept stems as a field, for hero culms that are carved or joined with rock.
#pragma once

#include <vug/field/field.h>
#include <vug/flora/tube.h>

namespace vug::flora {

/// The solid of all tubes together: a 1-Lipschitz lower bound of the distance, zero on the very
/// surface that sweep_mesh.h covers with triangles. Far from a stem it is the exact distance to the
/// cones around it, near it what is left to the displaced surface over the most that this changes
/// for a metre. Boxes of stems, and of their parts, are skipped where they cannot be nearest.
/// Without tubes: the empty field.
field::Field swept(std::vector<Tube> tubes);

/// The tubes that a field of `swept` is of; none of any other field.
std::vector<Tube> tubes_of(const field::Field& field);

}  // namespace vug::flora
