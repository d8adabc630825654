// SPDX-License-Identifier: Apache-2.0
// Examples and synonyms of kinds, for `vug list` and the manual. Those of a kind are in a file next
// to its source: primitives/torus.vug next to primitives/torus.cpp.
#pragma once

#include <vug/base/schema.h>

#include <string>
#include <vector>

namespace vug::loading {

/// The file of a kind: a line "# synonyms: ring, doughnut", if there are any, and a statement that
/// uses the kind, or nothing.
struct KindText {
  const KindInfo* kind;
  const char* text;
};
/// All of them; tools/cmake/VugKinds.cmake generates the table.
const std::vector<KindText>& kind_texts();

/// Words of other programs for the kind.
std::vector<std::string> synonyms_of(const KindInfo& kind);

/// Whether other programs have this word for the kind, in upper or lower case.
bool is_synonym(const std::string& word, const KindInfo& kind);

/// A use of the kind that can be copied: that of its file, or one made from its required
/// parameters, in a statement that the kinds of its category need. It may use the names of
/// `example_scene`. An example that begins with "vug " is a command.
std::string example_of(const KindInfo& kind);

/// The declarations to which examples refer: the field `rock`, its volume `cave` and mesh `skin`,
/// the object `pebble`, the L-system `fern`, the grammar `front` and a light of the group `key`.
std::string example_scene();

}  // namespace vug::loading
