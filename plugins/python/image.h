// SPDX-License-Identifier: Apache-2.0
// Rendered pictures, as seen from Python.
#pragma once

#include "binding.h"

#include <vug/picture/stereo_views.h>

#include <memory>
#include <optional>
#include <vector>

namespace vug::python {

/// An immutable rendered picture, or one view of it. Its arrays share the memory that it points to.
struct Image {
  std::shared_ptr<const std::vector<picture::RenderResult>> rendered;
  std::optional<size_t> view = {};        ///< No value: all views; arrays show the left one.
  std::filesystem::path checkpoint = {};  ///< Checkpoint of the rendering; removed after saving.

  const picture::RenderResult& part() const { return (*rendered)[view.value_or(0)]; }
  bool in_stereo() const { return !view && rendered->size() > 1; }
  const image::Image& image() const { return *part().image; }
};

}  // namespace vug::python
