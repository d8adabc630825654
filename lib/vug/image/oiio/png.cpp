// SPDX-License-Identifier: Apache-2.0
// PNG encoding with OpenImageIO.
#include <vug/base/error.h>
#include <vug/image/backend.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

namespace vug::image::oiio {

std::string encode_png(const std::vector<uint8_t>& bytes, int width, int height, bool srgb,
                       const Metadata& metadata) {
  const size_t pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
  OIIO::ImageSpec spec(width, height, static_cast<int>(bytes.size() / pixels),
                       OIIO::TypeDesc::UINT8);
  if (srgb) spec.attribute("oiio:ColorSpace", "sRGB");
  for (const auto& [name, text] : metadata) spec.attribute(name, text);
  std::vector<unsigned char> out;
  OIIO::Filesystem::IOVecOutput memory(out);
  const auto output = OIIO::ImageOutput::create("memory.png", &memory);
  if (!output || !output->open("memory.png", spec) ||
      !output->write_image(OIIO::TypeDesc::UINT8, bytes.data()) || !output->close()) {
    (void)(output ? output->geterror()
                  : OIIO::geterror());  // Otherwise OpenImageIO prints it at exit.
    throw Error(ErrorCode::internal,
                fmt::format("cannot make a PNG of {} x {} pixels", width, height));
  }
  return {out.begin(), out.end()};
}

}  // namespace vug::image::oiio
