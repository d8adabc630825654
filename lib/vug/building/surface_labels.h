// SPDX-License-Identifier: Apache-2.0
// The labels of the vertices of a mesh.
#pragma once

#include <vug/mesh/mesh.h>
#include <vug/shot/labels.h>

#include <vector>

namespace vug::building {

/// Adds an attribute for each name among the labels: 1 at vertices where the value of a field with
/// this name is the least of all, else 0. Of equal values the first label counts.
void add_labels(mesh::Mesh& mesh, const std::vector<shot::SurfaceLabel>& labels);

}  // namespace vug::building
