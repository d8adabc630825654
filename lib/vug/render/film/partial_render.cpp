// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/hash.h>
#include <vug/base/memory.h>
#include <vug/render/film/partial_render.h>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace vug::render {
namespace {

constexpr char kMagic[8] = {'v', 'u', 'g', 'p', 'a', 'r', 't', '\n'};
constexpr uint32_t kVersion = 3;
constexpr uint64_t kDigestBytes = 16;
constexpr size_t kBuffer = 1 << 20;

/// Reading and writing share the functions that list the values, so that they cannot differ.
/// Numbers are stored in the byte order of the processor, which is little-endian.
class Writer {
 public:
  static constexpr bool kReads = false;
  explicit Writer(const std::filesystem::path& path) : out_(path, std::ios::binary) {}

  void bytes(const void* data, size_t count) {
    const auto* from = static_cast<const char*>(data);
    buffer_.insert(buffer_.end(), from, from + count);
    if (buffer_.size() >= kBuffer) flush();
  }
  template <class T>
  void number(const T& value) {
    bytes(&value, sizeof value);
  }
  bool finish() {
    flush();
    const Digest digest = hash_.finish();
    number(digest.high), number(digest.low);
    flush();
    out_.close();
    return !out_.fail();
  }

 private:
  void flush() {
    hash_.add(buffer_.data(), buffer_.size());
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }
  std::vector<char> buffer_;
  std::ofstream out_;
  Hasher hash_;
};

class Reader {
 public:
  static constexpr bool kReads = true;
  Reader(const std::filesystem::path& path, std::string what)
      : path_(path),
        what_(std::move(what)),
        in_(path, std::ios::binary),
        left_(std::filesystem::file_size(path)) {}

  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(ErrorCode::bad_input,
                fmt::format("cannot read the {} '{}': {}", what_, path_.string(), why));
  }
  void bytes(void* data, size_t count) {
    need(count);
    auto* to = static_cast<char*>(data);
    for (size_t copied = 0; copied < count;) {
      if (at_ == buffer_.size()) refill();
      const size_t some = std::min(count - copied, buffer_.size() - at_);
      std::memcpy(to + copied, buffer_.data() + at_, some);
      at_ += some, copied += some, left_ -= some;
    }
  }
  /// The bytes before the hash that are not read yet.
  uint64_t left() const { return left_ - std::min(left_, kDigestBytes); }
  /// Skips to the hash at the end.
  void skip() {
    std::vector<char> some(kBuffer);
    while (left_ > kDigestBytes)
      bytes(some.data(), std::min<uint64_t>(some.size(), left_ - kDigestBytes));
  }
  /// Call this before allocating memory for this many bytes.
  void need(uint64_t count) const {
    if (count > left_) refuse("it is cut short");
  }
  template <class T>
  void number(T& value) {
    bytes(&value, sizeof value);
  }
  void finish() {
    if (left_ != kDigestBytes) refuse("its content was changed");
    const Digest digest = hash_.finish();
    Digest stored;
    number(stored.high), number(stored.low);
    if (!(stored == digest)) refuse("its content was changed");
  }

 private:
  /// Reads the next bytes, up to the hash, or the hash itself.
  void refill() {
    const uint64_t some =
        left_ > kDigestBytes ? std::min<uint64_t>(kBuffer, left_ - kDigestBytes) : left_;
    buffer_.resize(some);
    at_ = 0;
    in_.read(buffer_.data(), static_cast<std::streamsize>(some));
    if (!in_) refuse(std::strerror(errno));
    if (left_ > kDigestBytes) hash_.add(buffer_.data(), some);
  }
  std::vector<char> buffer_;
  size_t at_ = 0;
  std::filesystem::path path_;
  std::string what_;  ///< Name of the expected kind of file.
  std::ifstream in_;
  uint64_t left_;
  Hasher hash_;
};

template <class File, class Items, class Each>
void list(File& file, Items& items, size_t least_bytes, const Each& each) {
  auto count = static_cast<uint32_t>(items.size());
  file.number(count);
  if constexpr (File::kReads) {
    file.need(uint64_t{count} * least_bytes);
    items.resize(count);
  }
  for (auto& item : items) each(item);
}

template <class File, class Text>
void text(File& file, Text& value) {
  auto count = static_cast<uint32_t>(value.size());
  file.number(count);
  if constexpr (File::kReads) {
    file.need(count);
    value.resize(count);
  }
  if (count > 0) file.bytes(value.data(), count);
}

/// The options of a deep picture, after a flag that says whether there is one.
template <class File, class Deep>
void deep_options(File& file, Deep& deep) {
  uint8_t present = deep.has_value() ? 1 : 0;
  file.number(present);
  if (present == 0) return;
  if constexpr (File::kReads) deep.emplace();
  file.number(deep->tolerance), file.number(deep->max_samples);
}

template <class File, class R>
void region(File& file, R& r) {
  file.number(r.x0), file.number(r.y0), file.number(r.x1), file.number(r.y1);
}

template <class File, class H>
void header_of(File& file, H& h) {
  text(file, h.identity);
  file.number(h.width), file.number(h.height), file.number(h.spp), file.number(h.seed);
  region(file, h.crop);
  file.number(h.noise);
  list(file, h.aovs.names, 4, [&](auto& name) { text(file, name); });
  list(file, h.aovs.groups, 4, [&](auto& name) { text(file, name); });
  list(file, h.aovs.attributes, 8,
       [&](auto& attribute) { text(file, attribute.name), file.number(attribute.arity); });
  list(file, h.aovs.objects, 4, [&](auto& name) { text(file, name); });
  list(file, h.aovs.materials, 4, [&](auto& name) { text(file, name); });
  deep_options(file, h.deep);
  list(file, h.notes, 8, [&](auto& note) { text(file, note.first), text(file, note.second); });
}

template <class File, class Sum>
void pixel(File& file, Sum& s) {
  for (size_t i = 0; i < 3; ++i) file.number(s.light[i]), file.number(s.square[i]);
  for (size_t i = 0; i < 3; ++i)
    file.number(s.normal[i]), file.number(s.position[i]), file.number(s.albedo[i]);
  file.number(s.alpha), file.number(s.depth);
  file.number(s.samples), file.number(s.hits), file.number(s.invalid), file.number(s.clamped);
}

template <class File, class Fragments>
void fragments_of(File& file, Fragments& fragments) {
  static_assert(sizeof(DeepFragment) == 24, "written without padding");
  auto count = static_cast<uint32_t>(fragments.size());
  file.number(count);
  const uint64_t bytes = uint64_t{count} * sizeof(DeepFragment);
  if constexpr (File::kReads) {
    file.need(bytes);
    fragments.resize(count);
  }
  if (count > 0) file.bytes(fragments.data(), bytes);
}

template <class File, class F>
void film_of(File& file, F& film) {
  const Region& r = film.region();
  for (int y = r.y0; y < r.y1; ++y)
    for (int x = r.x0; x < r.x1; ++x) {
      pixel(file, film.at(x, y));
      if (film.layout().colours > 0)
        file.bytes(film.colours(x, y), film.layout().colours * 3 * sizeof(Wide));
      if (film.layout().coverage)
        list(file, film.coverage(x, y), 8,
             [&](auto& entry) { file.number(entry.first), file.number(entry.second); });
      if (film.layout().deep) fragments_of(file, film.fragments(x, y));
    }
}

/// True if the fragments are numbers, in the order of the samples, and samples of the state.
bool has_valid_fragments(const RenderState& state) {
  if (!state.film.layout().deep) return true;
  const Region& r = state.region;
  for (int y = r.y0; y < r.y1; ++y)
    for (int x = r.x0; x < r.x1; ++x) {
      uint64_t next = state.begin;
      for (const DeepFragment& f : state.film.fragments(x, y)) {
        const auto values = {f.depth, f.alpha, f.r, f.g, f.b};
        if (f.sample < next || f.sample >= state.end ||
            !std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); }))
          return false;
        next = uint64_t{f.sample} + 1;
      }
    }
  return true;
}

template <class File, class Tiles>
void tiles_of(File& file, Tiles& tiles) {
  region(file, tiles.region);
  file.number(tiles.begin), file.number(tiles.end);
}

template <class File, class Tiles>
void done_of(File& file, Tiles& tiles) {
  list(file, tiles.done, 4, [&](auto& n) { file.number(n); });
  list(file, tiles.converged, 1, [&](auto& n) { file.number(n); });
}

bool is_valid(const PartialRenderHeader& h, const TileProgress& tiles) {
  const Region all{0, 0, h.width, h.height};
  const auto inside = [](const Region& in, const Region& out) {
    return !in.empty() && in.overlap(out) == in;
  };
  return h.aovs.is_consistent() && h.width > 0 && h.height > 0 && h.width <= 65535 &&
         h.height <= 65535 && h.spp > 0 && inside(h.crop, all) && inside(tiles.region, h.crop) &&
         tiles.begin < tiles.end && tiles.end <= static_cast<uint32_t>(h.spp) &&
         (!h.deep || std::isfinite(h.deep->tolerance));
}

/// Reads everything before the sums.
void read_preamble(Reader& file, PartialRenderHeader& header, TileProgress& tiles) {
  char magic[sizeof kMagic];
  uint32_t version = 0;
  file.bytes(magic, sizeof magic);
  if (std::memcmp(magic, kMagic, sizeof magic) != 0) file.refuse("it is not a part of a picture");
  file.number(version);
  if (version != kVersion)
    file.refuse(fmt::format("its version is {}, this program reads {}", version, kVersion));
  header_of(file, header);
  tiles_of(file, tiles);
  if (!is_valid(header, tiles)) file.refuse("its content was changed");
  done_of(file, tiles);
  if (tiles.done.size() != tiles.region.tiles(tiles.tile_size) ||
      tiles.converged.size() != tiles.done.size() ||
      !std::all_of(tiles.done.begin(), tiles.done.end(),
                   [&](uint32_t n) { return n >= tiles.begin && n <= tiles.end; }))
    file.refuse("its content was changed");
}

Reader open(const std::filesystem::path& path, const std::string& what = "part") {
  if (const std::string why = unreadable_reason(path); !why.empty())
    throw Error(ErrorCode::bad_input,
                fmt::format("cannot read the {} '{}': {}", what, path.string(), why));
  return Reader(path, what);
}

}  // namespace

PartialRenderHeader partial_render_header(const Options& options) {
  PartialRenderHeader header;
  header.width = options.width, header.height = options.height, header.spp = options.spp;
  header.seed = options.seed;
  header.crop = render_region(options);
  header.noise = options.noise;
  header.aovs = options.aovs;
  header.deep = options.deep;
  return header;
}

void write_partial_render(const std::filesystem::path& path, const PartialRenderHeader& header,
                          const RenderState& state) {
  AtomicFile target(path);
  Writer file(target.path());
  file.bytes(kMagic, sizeof kMagic);
  file.number(kVersion);
  header_of(file, header);
  tiles_of(file, state);
  done_of(file, state);
  film_of(file, state.film);
  if (!file.finish())
    throw Error(ErrorCode::io,
                fmt::format("cannot write '{}': {}", path.string(), std::strerror(errno)));
  target.commit();
}

PartialRender read_partial_render(const std::filesystem::path& path, const std::string& what) {
  Reader file = open(path, what);
  PartialRender part;
  TileProgress tiles;
  read_preamble(file, part.header, tiles);
  const FilmLayout layout = part.header.aovs.layout(part.header.deep.has_value());
  const auto pixels = static_cast<double>(tiles.region.pixels());
  file.need(tiles.region.pixels() * 200);
  // The fragments of a deep picture are as large as in the file.
  require_memory(
      Film::pixel_bytes(layout, 0) * pixels + (layout.deep ? static_cast<double>(file.left()) : 0),
      available_memory(), fmt::format("the {} '{}'", what, path.string()),
      "merge on a machine with more memory");
  part.state = RenderState(std::move(tiles), layout);
  film_of(file, part.state.film);
  file.finish();
  if (!has_valid_fragments(part.state)) file.refuse("its content was changed");
  return part;
}

PartialRenderInfo read_partial_render_info(const std::filesystem::path& path) {
  Reader file = open(path);
  PartialRenderInfo info;
  TileProgress tiles;
  read_preamble(file, info.header, tiles);
  info.region = tiles.region, info.begin = tiles.begin, info.end = tiles.end;
  info.fraction = tiles.fraction();
  info.samples_left = tiles.missing();
  return info;
}

bool is_partial_render(const std::filesystem::path& path) {
  if (!unreadable_reason(path).empty()) return false;
  char magic[sizeof kMagic] = {};
  std::ifstream(path, std::ios::binary).read(magic, sizeof magic);
  return std::memcmp(magic, kMagic, sizeof magic) == 0;
}

void verify_partial_render(const std::filesystem::path& path) {
  Reader file = open(path);
  file.skip();
  file.finish();
}

}  // namespace vug::render
