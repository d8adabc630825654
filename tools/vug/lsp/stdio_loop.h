// SPDX-License-Identifier: Apache-2.0
// Runs a language server on two streams.
#pragma once

#include <vug/language/workspace.h>

#include <chrono>
#include <iosfwd>

namespace vug::lsp {

struct LoopOptions {
  language::WorkspaceOptions workspace;
  /// Diagnostics are computed after this time without a message.
  std::chrono::milliseconds debounce{200};
};

/// Answers messages until `exit` or the end of the input. Returns 0 if `exit` followed `shutdown`,
/// else 1.
int run_server(std::istream& in, std::ostream& out, const LoopOptions& options);

}  // namespace vug::lsp
