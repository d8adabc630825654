// What writers of SVG, HTML and XML need.
#pragma once

#include <string>

namespace vug {

/// The text as it stands between tags or in double quotes: markup escaped, control characters
/// (which XML 1.0 forbids) as spaces. UTF-8 stays as it is.
std::string xml_text(const std::string& text);

}  // namespace vug
