// SPDX-License-Identifier: Apache-2.0
// The binary form of a mesh from which it returns unchanged, unlike the formats for other programs.
#pragma once

#include <vug/mesh/mesh.h>

#include <iosfwd>

namespace vug::mesh {

void write_exact(std::ostream& out, const Attribute& attribute);
void write_exact(std::ostream& out, const Mesh& mesh);
/// Throw Error(bad_input) if the stream ends before.
Attribute read_exact_attribute(std::istream& in);
Mesh read_exact_mesh(std::istream& in);

}  // namespace vug::mesh
