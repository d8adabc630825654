// SPDX-License-Identifier: Apache-2.0
// Code actions: corrections of faults, from their hints, and changes of the text on request.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/language/workspace.h>

#include <string>
#include <vector>

namespace vug::language {

struct Fix {
  std::string title;
  std::vector<TextEdit> edits;  ///< The edits of the text itself.
};

/// The corrections that the hint of a diagnostic names: the nearest name, the include that declares
/// a function, a colour as a call. Empty if the hint is advice only.
std::vector<Fix> fixes_for(const Analysis& analysis, const Diagnostic& diagnostic);

/// Changes of the text at a position that keep its meaning: a number becomes a param.
std::vector<Fix> refactorings_at(const Analysis& analysis, const Position& position);

}  // namespace vug::language
