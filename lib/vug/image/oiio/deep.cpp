// SPDX-License-Identifier: Apache-2.0
// Writing of deep EXR files with OpenImageIO.
#include <vug/image/backend.h>
#include <vug/image/oiio/exr_spec.h>

#include <OpenImageIO/deepdata.h>

#include <algorithm>

namespace vug::image::oiio {
namespace {

OIIO::ImageSpec deep_spec(const DeepView& view) {
  const ExrOptions& options = view.options;
  OIIO::ImageSpec spec = exr_spec(view.image.width, view.image.height, options);
  spec.tile_width = spec.tile_height = 0;
  spec.deep = true;
  spec.nchannels = 6;
  spec.channelnames = {"R", "G", "B", "A", "Z", "ZBack"};
  spec.alpha_channel = 3, spec.z_channel = 4;
  const OIIO::TypeDesc colour = options.half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT;
  spec.channelformats = {
      colour, colour, colour, colour, OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::FLOAT};
  spec.attribute("compression", "zips");
  if (!view.name.empty()) {
    spec.attribute("view", view.name);
    spec.attribute("oiio:subimagename", view.name);
  }
  for (const auto& [name, text] : options.metadata) spec.attribute(name, text);
  return spec;
}

OIIO::DeepData deep_data(const DeepView& view, const OIIO::ImageSpec& spec) {
  const DeepImage& deep = view.image;
  OIIO::DeepData data(spec);
  for (size_t p = 0; p < deep.pixels.size(); ++p)
    data.set_samples(static_cast<int64_t>(p), static_cast<int>(deep.pixels[p].size()));
  const auto stored = [&](float v) {
    return view.options.half ? std::clamp(v, -65504.0f, 65504.0f) : v;
  };
  for (size_t p = 0; p < deep.pixels.size(); ++p)
    for (size_t i = 0; i < deep.pixels[p].size(); ++i) {
      const DeepSample& s = deep.pixels[p][i];
      const float values[] = {stored(s.r), stored(s.g), stored(s.b), s.alpha, s.near, s.far};
      for (int c = 0; c < 6; ++c)
        data.set_deep_value(static_cast<int64_t>(p), c, static_cast<int>(i), values[c]);
    }
  return data;
}

}  // namespace

void write_deep_exr(const std::filesystem::path& path, const std::filesystem::path& temporary,
                    const std::vector<DeepView>& views) {
  std::vector<OIIO::ImageSpec> specs;
  for (const DeepView& view : views) specs.push_back(deep_spec(view));
  ExrOutput output(path, temporary, specs);
  for (size_t i = 0; i < views.size(); ++i) {
    output.begin(i);
    output.check(output->write_deep_image(deep_data(views[i], specs[i])));
  }
  output.close();
}

}  // namespace vug::image::oiio
