// SPDX-License-Identifier: Apache-2.0
// Parts of a text by their location.
#pragma once

#include <vug/base/error.h>

#include <string_view>

namespace vug::scene {

/// Start byte of a character of a text with "\n" as line ends; its size for positions beyond it.
/// Columns beyond the end of a line mean that end.
size_t byte_at(std::string_view text, int line, int column);

/// The part of the text in that range; empty if the range has no end.
std::string_view text_at(std::string_view text, const SourceLocation& where);

}  // namespace vug::scene
