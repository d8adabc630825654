// SPDX-License-Identifier: Apache-2.0
// HTML frame of the report pages, self-contained without external resources.
#pragma once

#include <string>

namespace vug::image {

/// Up to and including <body>; `title` is plain text.
std::string page_head(const std::string& title);
std::string page_foot();
/// The buttons and the slider of a comparison of two images, and the script that operates them.
std::string page_controls(bool blocks);
std::string page_script();

}  // namespace vug::image
