// SPDX-License-Identifier: Apache-2.0
// The header of files about one picture: partial renders, checkpoints and guiding files.
#pragma once

#include <vug/render/film/hashed_file.h>
#include <vug/render/film/partial_render.h>

namespace vug::render {

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

}  // namespace vug::render
