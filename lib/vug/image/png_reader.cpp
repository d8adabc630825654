// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/memory.h>
#include <vug/image/part_channels.h>
#include <vug/image/png_errors.h>
#include <vug/image/png_reader.h>
#include <vug/image/read_error.h>

#include <fmt/format.h>
#include <png.h>

#include <array>
#include <bit>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <string_view>

namespace vug::image {
namespace {

/// An open file and the libpng structures that read it.
struct PngFile {
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file;
  png_structp png =
      png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, jump_out, ignore_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;

  explicit PngFile(const std::filesystem::path& path)
      : file(std::fopen(path.c_str(), "rb"), std::fclose) {}
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;
  ~PngFile() { png_destroy_read_struct(&png, &info, nullptr); }

  bool begins_like_a_png() const {
    std::array<png_byte, 8> signature{};
    return file && std::fread(signature.data(), 1, 8, file.get()) == 8 &&
           png_sig_cmp(signature.data(), 0, 8) == 0;
  }
};

/// Reads the chunks before the pixels and asks for grey or R, G, B of 8 or 16 bits. It has no
/// objects with destructors, because errors leave it by a jump.
bool read_header(const PngFile& in) {
  if (setjmp(png_jmpbuf(in.png))) return false;
  png_init_io(in.png, in.file.get());
  png_set_sig_bytes(in.png, 8);
  png_read_info(in.png, in.info);
  png_set_palette_to_rgb(in.png);
  png_set_expand_gray_1_2_4_to_8(in.png);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(in.png);
  png_set_interlace_handling(in.png);
  png_read_update_info(in.png, in.info);
  return true;
}

bool read_rows(const PngFile& in, png_bytep* rows) {
  if (setjmp(png_jmpbuf(in.png))) return false;
  png_read_image(in.png, rows);
  png_read_end(in.png, nullptr);
  return true;
}

Metadata texts_of(const PngFile& in) {
  Metadata out;
  png_textp texts = nullptr;
  int count = 0;
  png_get_text(in.png, in.info, &texts, &count);
  for (int i = 0; i < count; ++i) out.emplace_back(texts[i].key, texts[i].text);
  return out;
}

bool is_plain_png(const PngFile& in) {
  if (png_get_color_type(in.png, in.info) & PNG_COLOR_MASK_ALPHA) return false;
  if (png_get_valid(in.png, in.info, PNG_INFO_tRNS | PNG_INFO_eXIf)) return false;
  if (png_get_x_offset_pixels(in.png, in.info) != 0 ||
      png_get_y_offset_pixels(in.png, in.info) != 0)
    return false;
  for (const auto& [name, text] : texts_of(in))
    if (name == "XML:com.adobe.xmp" || name.rfind("Raw profile type", 0) == 0) return false;
  return true;
}

/// Opens a file whose pixels this reader understands.
std::unique_ptr<PngFile> open_plain(const std::filesystem::path& path) {
  if (extension_of(path) != ".png") return nullptr;
  auto in = std::make_unique<PngFile>(path);
  if (!in->info || !in->begins_like_a_png()) return nullptr;
  if (!read_header(*in)) throw unreadable_beginning(path, ".png");
  return is_plain_png(*in) ? std::move(in) : nullptr;
}

FileInfo png_info_of(const PngFile& in) {
  FileInfo info;
  info.width = static_cast<int>(png_get_image_width(in.png, in.info));
  info.height = static_cast<int>(png_get_image_height(in.png, in.info));
  if (png_get_channels(in.png, in.info) == 1)
    info.channels = {"Y"};
  else
    info.channels = {"R", "G", "B"};
  const bool wide = png_get_bit_depth(in.png, in.info) == 16;
  info.formats.assign(info.channels.size(), wide ? "uint16" : "uint8");
  info.metadata = texts_of(in);
  return info;
}

template <class Code>
void scale(const std::vector<png_byte>& bytes, std::vector<float>& values) {
  constexpr float kUnit = 1.0f / static_cast<float>(std::numeric_limits<Code>::max());
  for (size_t i = 0; i < values.size(); ++i) {
    Code code;
    std::memcpy(&code, bytes.data() + i * sizeof(Code), sizeof(Code));
    values[i] = static_cast<float>(code) * kUnit;
  }
}

}  // namespace

std::optional<Image> read_plain_png(const std::filesystem::path& path) {
  const std::unique_ptr<PngFile> in = open_plain(path);
  if (!in) return std::nullopt;
  const FileInfo info = png_info_of(*in);
  require_reasonable_size(path, info.width, info.height, info.channels.size());
  require_memory(6.0 * info.width * info.height * static_cast<double>(info.channels.size()),
                 available_memory(), fmt::format("the picture '{}'", path.string()));
  const size_t row = png_get_rowbytes(in->png, in->info);
  std::vector<png_byte> bytes(row * static_cast<size_t>(info.height));
  std::vector<png_bytep> rows;
  for (size_t y = 0; y < static_cast<size_t>(info.height); ++y)
    rows.push_back(bytes.data() + y * row);
  if (!read_rows(*in, rows.data())) throw unreadable_pixels(path);
  Image image(info.width, info.height, info.channels);
  if (info.formats[0] == "uint16")
    scale<uint16_t>(bytes, image.pixels);
  else
    scale<uint8_t>(bytes, image.pixels);
  return image;
}

std::optional<FileInfo> read_plain_png_info(const std::filesystem::path& path) {
  const std::unique_ptr<PngFile> in = open_plain(path);
  if (!in) return std::nullopt;
  const FileInfo info = png_info_of(*in);
  require_reasonable_size(path, info.width, info.height, info.channels.size());
  return info;
}

}  // namespace vug::image
