// SPDX-License-Identifier: Apache-2.0
// Checks that tables of materials by rock and the rocks of the scene match.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/scene/document.h>
#include <vug/shot/shot.h>

#include <functional>
#include <string>
#include <vector>

namespace vug::loading {

/// Calls `visit` for each expression of the lets, functions and declarations of a text, without the
/// entries of cells.
void each_expression(const scene::Document& document,
                     const std::function<void(const scene::Expr&)>& visit);

/// Reports as errors the rocks of a table `by rock { ... }` that are not among `rocks`, the rocks
/// of all meshes, and the rocks of an object for which its table has no material. Included texts
/// may serve other scenes as well: there, a name similar to a rock is a warning, and others are
/// correct. In a text without any rock, which may only declare materials, the names are warnings.
/// A material that one rock has with two hardnesses is an error.
void check_rocks(const scene::Document& document, const shot::Shot& shot,
                 const std::vector<std::string>& rocks, Diagnostics& diagnostics);

}  // namespace vug::loading
