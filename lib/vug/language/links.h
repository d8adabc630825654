// SPDX-License-Identifier: Apache-2.0
// The files that a text names.
#pragma once

#include <vug/language/workspace.h>

#include <vector>

namespace vug::language {

/// A file that the text names.
struct Link {
  SourceLocation range;  ///< Without the quotes.
  std::filesystem::path target;
};
/// The included files, and other files in quotes that exist.
std::vector<Link> links_of(const Workspace& workspace, const Analysis& analysis);

}  // namespace vug::language
