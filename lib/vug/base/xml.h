// SPDX-License-Identifier: Apache-2.0
// Escaping of text for SVG, HTML and XML.
#pragma once

#include <string>

namespace vug {

/// The text for use between tags or in double quotes: markup is escaped, and control characters
/// (which XML 1.0 forbids) become spaces. UTF-8 is unchanged.
std::string xml_text(const std::string& text);

}  // namespace vug
