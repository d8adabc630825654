// SPDX-License-Identifier: Apache-2.0
// Merging of partial renders (`vug merge`): checks of their cover, and exact sums.
#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/render/film/partial_render.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace vug::render {
namespace {

struct NamedPart {
  std::string path;
  PartialRenderInfo info;
};

std::string range_text(const Region& r) {
  return fmt::format("x {}..{}, y {}..{}", r.x0, r.x1 - 1, r.y0, r.y1 - 1);
}

/// Checks that each cell between neighbouring edges of the regions has every sample exactly once.
void require_cover(const std::vector<NamedPart>& parts) {
  const PartialRenderHeader& header = parts.front().info.header;
  std::set<int> xs = {header.crop.x0, header.crop.x1}, ys = {header.crop.y0, header.crop.y1};
  for (const NamedPart& part : parts) {
    xs.insert({part.info.region.x0, part.info.region.x1});
    ys.insert({part.info.region.y0, part.info.region.y1});
  }
  const auto refuse = [](const std::string& what) {
    return Error(
        ErrorCode::bad_input, what, {},
        "give each part of the picture once: the tiles of --tile, the ranges of --samples");
  };
  for (auto y = ys.begin(); std::next(y) != ys.end(); ++y)
    for (auto x = xs.begin(); std::next(x) != xs.end(); ++x) {
      const Region cell{*x, *y, *std::next(x), *std::next(y)};
      std::vector<const NamedPart*> here;
      for (const NamedPart& part : parts)
        if (part.info.region.overlap(cell) == cell) here.push_back(&part);
      std::sort(here.begin(), here.end(), [](const NamedPart* a, const NamedPart* b) {
        return a->info.begin < b->info.begin;
      });
      uint32_t reached = 0;
      const NamedPart* last = nullptr;
      const auto gap = [&](uint32_t end) {
        return refuse(fmt::format("the samples {}..{} of the pixels {} are missing", reached, end,
                                  range_text(cell)));
      };
      for (const NamedPart* part : here) {
        if (part->info.begin < reached)
          throw refuse(fmt::format("'{}' and '{}' both have the samples {}..{} of the pixels {}",
                                   last->path, part->path, part->info.begin,
                                   std::min(reached, part->info.end), range_text(cell)));
        if (part->info.begin > reached) throw gap(part->info.begin);
        reached = part->info.end, last = part;
      }
      if (reached < static_cast<uint32_t>(header.spp)) throw gap(static_cast<uint32_t>(header.spp));
    }
}

}  // namespace

std::string difference(const PartialRenderHeader& a, const PartialRenderHeader& b) {
  // Each frame has its own seed, which would not be meaningful to users.
  const auto frame = [](const PartialRenderHeader& header) {
    for (const auto& [name, value] : header.notes)
      if (name.ends_with("vug:frame")) return value;
    return std::string();
  };
  if (!frame(a).empty() && !frame(b).empty() && frame(a) != frame(b))
    return fmt::format("frames, {} and {}", frame(a), frame(b));
  if (a.width != b.width || a.height != b.height)
    return fmt::format("sizes, {} x {} and {} x {}", a.width, a.height, b.width, b.height);
  if (a.seed != b.seed) return fmt::format("seeds, {} and {}", a.seed, b.seed);
  if (a.spp != b.spp) return fmt::format("samples per pixel, {} and {}", a.spp, b.spp);
  if (!(a.crop == b.crop)) return "crops";
  if (!(a.aovs == b.aovs)) return "layers";
  if (!(a.deep == b.deep)) return "deep pictures";
  if (a.noise < b.noise || a.noise > b.noise) return "noise thresholds";
  if (a.identity != b.identity) return "scenes";
  return a.notes == b.notes ? "" : "settings";
}

PartialRender merge(const std::vector<std::filesystem::path>& paths, Progress& progress) {
  if (paths.empty()) throw Error(ErrorCode::bad_input, "there are no parts to merge");
  std::vector<NamedPart> parts;
  for (const auto& path : paths) {
    parts.push_back({path.string(), read_partial_render_info(path)});
    const PartialRenderInfo &first = parts.front().info, &part = parts.back().info;
    if (part.fraction < 1)
      throw Error(ErrorCode::bad_input,
                  fmt::format("'{}' is only {:.0f} % complete", path.string(), 100 * part.fraction),
                  {}, "finish it with --resume");
    if (const std::string what = difference(first.header, part.header); !what.empty())
      throw Error(ErrorCode::bad_input, fmt::format("'{}' and '{}' have different {}",
                                                    parts.front().path, path.string(), what));
  }
  require_cover(parts);
  PartialRender whole;
  whole.header = parts.front().info.header;
  const PartialRenderHeader& header = whole.header;
  const FilmLayout layout = header.aovs.layout(header.deep.has_value());
  require_memory(Film::pixel_bytes(layout, header.spp) * static_cast<double>(header.crop.pixels()),
                 available_memory(), "the picture", "merge on a machine with more memory");
  RenderState& state = whole.state;
  state = RenderState({header.crop, 0, static_cast<uint32_t>(header.spp)}, layout);
  state.done.assign(state.done.size(), state.end);
  progress.begin("merging", paths.size());
  for (const auto& path : paths) {
    progress.check();
    state.film.merge(read_partial_render(path).state.film);
    progress.advance();
  }
  progress.end();
  return whole;
}

}  // namespace vug::render
