// Rendered pictures as Python holds them.
#pragma once

#include "binding.h"

#include <vug/picture/stereo_views.h>

#include <memory>
#include <optional>
#include <vector>

namespace vug::python {

/// What was rendered, or one view of it. Immutable; its arrays share what it points to.
struct Image {
  std::shared_ptr<const std::vector<picture::RenderResult>> rendered;
  std::optional<size_t> view = {};        ///< None: all, of which arrays show the left one.
  std::filesystem::path checkpoint = {};  ///< Of its rendering; needed until it is in a file.

  const picture::RenderResult& part() const { return (*rendered)[view.value_or(0)]; }
  bool in_stereo() const { return !view && rendered->size() > 1; }
  const image::Image& image() const { return *part().image; }
};

}  // namespace vug::python
