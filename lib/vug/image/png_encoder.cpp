// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/image/png_encoder.h>
#include <vug/image/png_errors.h>

#include <fmt/format.h>
#include <png.h>

#include <csetjmp>

namespace vug::image {
namespace {

void append_bytes(png_structp png, png_bytep bytes, size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), count);
}

/// The libpng structures of one file.
struct Encoder {
  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, jump_out, ignore_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  Encoder() = default;
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
  ~Encoder() { png_destroy_write_struct(&png, &info); }
};

/// The content of a file, as libpng takes it.
struct Content {
  png_uint_32 width, height;
  bool grey, srgb;
  std::vector<png_text> texts;
  std::vector<png_bytep> rows;
};

/// It has no objects with destructors, because errors leave it by a jump.
bool encode(png_structp png, png_infop info, Content& content, std::string* out) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, out, append_bytes, nullptr);
  png_set_IHDR(png, info, content.width, content.height, 8,
               content.grey ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (content.srgb) png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_RELATIVE);
  if (!content.texts.empty())
    png_set_text(png, info, content.texts.data(), static_cast<int>(content.texts.size()));
  png_set_rows(png, info, content.rows.data());
  png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  return true;
}

Content content_of(const std::vector<uint8_t>& bytes, int width, int height, bool srgb,
                   const Metadata& metadata) {
  Content content{
      static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), false, srgb, {}, {}};
  const size_t row = bytes.size() / content.height;
  content.grey = row == content.width;
  // libpng takes pointers to data that it does not change.
  for (size_t y = 0; y < content.height; ++y)
    content.rows.push_back(const_cast<png_bytep>(bytes.data() + y * row));
  for (const auto& [name, text] : metadata) {
    png_text entry{};
    entry.compression = PNG_TEXT_COMPRESSION_NONE;
    entry.key = const_cast<png_charp>(name.c_str());
    entry.text = const_cast<png_charp>(text.c_str());
    content.texts.push_back(entry);
  }
  return content;
}

}  // namespace

std::string encode_png(const std::vector<uint8_t>& bytes, int width, int height, bool srgb,
                       const Metadata& metadata) {
  Content content = content_of(bytes, width, height, srgb, metadata);
  std::string out;
  Encoder encoder;
  if (!encoder.info || !encode(encoder.png, encoder.info, content, &out))
    throw Error(ErrorCode::internal,
                fmt::format("cannot make a PNG of {} x {} pixels", width, height));
  return out;
}

}  // namespace vug::image
