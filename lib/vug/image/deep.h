// SPDX-License-Identifier: Apache-2.0
// Deep images: samples with depth per pixel, between which other programs can composite objects.
#pragma once

#include <vug/image/io.h>

#include <string>
#include <vector>

namespace vug::image {

/// Content visible from `near` to `far`, in metres as in the layer Z. The colour is premultiplied
/// by alpha; alpha is the opacity towards everything behind.
struct DeepSample {
  float near = 0, far = 0;
  float alpha = 0;
  float r = 0, g = 0, b = 0;

  bool operator==(const DeepSample&) const = default;
};

/// The samples of each pixel, row by row from the top, nearest first and without overlap.
struct DeepImage {
  int width = 0, height = 0;
  std::vector<std::vector<DeepSample>> pixels;

  DeepImage() = default;
  DeepImage(int w, int h)
      : width(w), height(h), pixels(static_cast<size_t>(w) * static_cast<size_t>(h)) {}
  std::vector<DeepSample>& at(int x, int y) {
    return pixels[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)];
  }
};

/// Composites a deep image front to back into R, G, B, A.
Image flatten(const DeepImage& deep);

/// Writes a deep scan-line EXR with the channels R, G, B, A, Z, ZBack (ZIPS compression). The
/// option `half` applies to colours and alpha; `parts` and `tiles` are ignored. Throws the same
/// errors as write_exr.
void write_deep_exr(const std::filesystem::path& path, const DeepImage& deep,
                    const ExrOptions& options = {});

/// See ExrView.
struct DeepView {
  std::string name;
  const DeepImage& image;
  ExrOptions options;
};
/// Writes several views, each as one part.
void write_deep_exr(const std::filesystem::path& path, const std::vector<DeepView>& views);

}  // namespace vug::image
