// SPDX-License-Identifier: Apache-2.0
#include <vug/image/exr/header.h>

#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>

namespace vug::image::exr {
namespace {

Imf::Chromaticities chromaticities_of(const Chromaticities& space) {
  const auto point = [&](size_t i) {
    return Imath::V2f(static_cast<float>(space[i]), static_cast<float>(space[i + 1]));
  };
  return {point(0), point(2), point(4), point(6)};
}

void add_matrix(Imf::Header& header, const char* name,
                const std::optional<std::array<float, 16>>& values) {
  if (!values) return;
  Imath::M44f matrix;
  std::copy(values->begin(), values->end(), matrix.getValue());
  header.insert(name, Imf::M44fAttribute(matrix));
}

}  // namespace

Imf::Header header_of(int width, int height, const ExrOptions& options, const std::string& view) {
  const ExrOptions::Window& window = options.window;
  const bool crop = window.full_width > 0;
  const Imath::V2i corner = crop ? Imath::V2i(window.x, window.y) : Imath::V2i(0, 0);
  const Imath::Box2i data(corner, corner + Imath::V2i(width - 1, height - 1));
  const Imath::Box2i display(
      Imath::V2i(0, 0),
      crop ? Imath::V2i(window.full_width - 1, window.full_height - 1) : data.max);
  Imf::Header header(display, data);
  header.compression() = Imf::ZIP_COMPRESSION;
  // A constant, because equal images must have equal bytes.
  Imf::addCapDate(header, "1970:01:01 00:00:00");
  const WorkingSpaceInfo& space = info(options.space);
  Imf::addChromaticities(header, chromaticities_of(space.chromaticities));
  header.insert("colorInteropID", Imf::StringAttribute(space.public_name));
  add_matrix(header, "worldToCamera", options.world_to_camera);
  add_matrix(header, "worldToNDC", options.world_to_ndc);
  if (!view.empty()) header.setView(view);
  return header;
}

}  // namespace vug::image::exr
