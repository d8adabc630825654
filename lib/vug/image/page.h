// The look of the project's report pages: HTML around their content, without anything from outside.
#pragma once

#include <string>

namespace vug::image {

/// Up to and with <body>; `title` is plain text.
std::string page_head(const std::string& title);
std::string page_foot();
/// The buttons and the slider of a stage with two pictures, and the script that moves them.
std::string page_controls(bool blocks);
std::string page_script();

}  // namespace vug::image
