// Rendered pictures as Python holds them.
#pragma once

#include "binding.h"

#include <vug/session/views.h>

#include <memory>
#include <vector>

namespace vug::python {

/// What was rendered, and which view of it this is. Immutable; its arrays share what it points to.
struct Image {
  std::shared_ptr<const std::vector<session::Rendered>> rendered;
  size_t view = 0;
  std::filesystem::path checkpoint = {};  ///< Of its rendering; needed until it is in a file.

  const session::Rendered& part() const { return (*rendered)[view]; }
  const image::Image& image() const { return *part().image; }
};

}  // namespace vug::python
