// SPDX-License-Identifier: Apache-2.0
// Messages on a stream, each after a header with its length (base protocol of the Language Server
// Protocol 3.17).
#pragma once

#include <iosfwd>
#include <optional>
#include <string>

namespace vug::lsp {

/// The content of the next message; nothing at the end of the stream. A header without a valid
/// length, or with one above 256 MB, gives an empty content.
std::optional<std::string> read_message(std::istream& in);

void write_message(std::ostream& out, const std::string& content);

}  // namespace vug::lsp
