// Deep pictures: what each pixel sees at which depth, so that others can put things in between.
#pragma once

#include <vug/image/io.h>

#include <string>
#include <vector>

namespace vug::image {

/// Something seen from `near` to `far`, in metres as the layer Z; colour premultiplied by alpha,
/// and alpha as it hides what lies behind.
struct DeepSample {
  float near = 0, far = 0;
  float alpha = 0;
  float r = 0, g = 0, b = 0;

  bool operator==(const DeepSample&) const = default;
};

/// The samples of each pixel, row by row from the top, the nearest first; they do not overlap.
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

/// The picture that compositing a deep one from front to back gives: R, G, B, A.
Image flatten(const DeepImage& deep);

/// A deep EXR of lines with the channels R, G, B, A, Z, ZBack (ZIPS); of the options `half` is for
/// colours and alpha, `parts` and `tiles` have no meaning here. Errors as write_exr.
void write_deep_exr(const std::filesystem::path& path, const DeepImage& deep,
                    const ExrOptions& options = {});

/// See ExrView.
struct DeepView {
  std::string name;
  const DeepImage& image;
  ExrOptions options;
};
/// The same of several views, a part for each.
void write_deep_exr(const std::filesystem::path& path, const std::vector<DeepView>& views);

}  // namespace vug::image
