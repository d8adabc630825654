// SPDX-License-Identifier: Apache-2.0
// Digests of the declarations of a document, which change if the text that determines their values
// changes, and not if another part of the text does.
#pragma once

#include <vug/base/hash.h>
#include <vug/scene/document.h>

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vug::scene {

/// The digest of a declaration covers its tokens with their positions relative to its first line,
/// the parameters, lets and functions that it mentions, directly or through others, the seed, and
/// the sizes and times of the files that its texts name. Comments and empty lines around it do not
/// count, and neither do the values of other declarations: only the kinds that have a name which it
/// mentions. Every name but those of arguments counts, even if it is a key or a local one, so
/// a digest may change too often, but not too rarely.
class StatementDigests {
 public:
  /// `folders` are searched for files, after the folder of the text.
  StatementDigests(const Document& document, const std::vector<std::filesystem::path>& folders);

  /// The digest of a declaration or ("grammar") a grammar; nothing if there is none or several, or
  /// if its text is not at hand.
  std::optional<Digest> find(const std::string& kind, const std::string& name) const;

  /// A digest that also covers the declarations which this one mentions, directly or through
  /// others: all of the text from which its value follows. Nothing if one of them has no digest, or
  /// if the value may depend on the frame. Overrides of parameters and of the seed are not covered.
  std::optional<Digest> find_with_mentioned(const std::string& kind, const std::string& name) const;

 private:
  using Name = std::pair<std::string, std::string>;  ///< Kind and name.
  struct Statement {
    Digest digest;
    std::set<std::string> mentions;  ///< Also those of the parameters, lets and functions.
  };

  std::map<Name, std::optional<Statement>> statements_;
  std::map<std::string, std::vector<Name>> declared_;  ///< By the name without prefixes.
};

}  // namespace vug::scene
