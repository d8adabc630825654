// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/render/film/partial_render_header.h>

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
void read_preamble(HashedReader& file, PartialRenderHeader& header, TileProgress& tiles) {
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
  HashedWriter file(target.path());
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
  HashedReader file(path, what);
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
  HashedReader file(path, "part");
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
  HashedReader file(path, "part");
  file.skip();
  file.finish();
}

}  // namespace vug::render
