// The statements of one file, put into a document.
#pragma once

#include <vug/scene/expr_parser.h>

#include <functional>

namespace vug::scene {

/// Called for `include "path"`; `where` is the path's token.
using Includer = std::function<void(const std::string& path, const SourceLocation& where)>;

/// Parses every statement up to the end.
void parse_statements(Cursor& cursor, Document& document, const Includer& include);

}  // namespace vug::scene
