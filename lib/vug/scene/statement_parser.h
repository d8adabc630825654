// SPDX-License-Identifier: Apache-2.0
// Parser of the statements of one file, with the entries of their blocks in "{" and "}".
#pragma once

#include <vug/scene/expr_parser.h>

#include <functional>

namespace vug::scene {

/// Called for each `include`; reads the file into the document.
using Includer = std::function<void(const Include& include)>;

/// Parses all statements up to the end and adds them to the document.
void parse_statements(Cursor& cursor, Document& document, const Includer& include);

}  // namespace vug::scene
