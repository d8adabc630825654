// SPDX-License-Identifier: Apache-2.0
// The text from which the things of a loaded scene were made.
#pragma once

#include <vug/field/field.h>
#include <vug/scene/document.h>
#include <vug/scene/provenance.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vug::loading {

/// A side table: the values do not contain their provenance, so that it changes neither their
/// identity nor their costs.
class ProvenanceTable {
 public:
  /// A declaration, a function, or a rule of a grammar.
  struct Declared {
    std::string kind;  ///< "volume", "light", ..., "def", "grammar" or "rule".
    std::string name;  ///< A rule has those of its grammar and its head: "cave/Room".
    SourceLocation where;
  };
  /// One line of an answer, e.g. "included from" and a location.
  struct Step {
    std::string what;
    SourceLocation where;
  };

  ProvenanceTable() = default;
  explicit ProvenanceTable(const scene::Document& document);

  /// Declarations, functions and rules by file in the order of the text.
  const std::vector<Declared>& declared() const { return declared_; }
  /// The declaration of that kind and name, such as an object, light, material or camera; null if
  /// there is none.
  const Declared* find(const std::string& kind, const std::string& name) const;
  /// The expression that made a field's node. Null for nodes of other scenes and of declarations
  /// that were taken from a StaticCache.
  const scene::Provenance* find(const field::NodePtr& node) const;

  /// What led to the text: the evaluated declarations, names and rules from the innermost on, then
  /// the includes of its file.
  std::vector<Step> chain(const scene::Provenance& provenance) const;
  /// "parts.vug:3:12-3:30, in let 'ball' at cave.vug:5:9, included from cave.vug:1:9".
  std::string describe(const scene::Provenance& provenance) const;

  /// Records the nodes of a field that have no provenance yet.
  void record(const field::NodePtr& node, const scene::Provenance& provenance);

  /// The files of networks, also of those without a name, in the order in which they were read;
  /// each once. Networks that were taken from a StaticCache are not included.
  const std::vector<std::filesystem::path>& network_files() const { return network_files_; }
  void record_files(const std::vector<std::filesystem::path>& files);

 private:
  std::vector<Declared> declared_;
  std::map<std::string, SourceLocation> included_from_;  ///< By file.
  // By control block: the entry of a deleted node cannot be taken for that of a new one.
  std::map<std::weak_ptr<const field::Node>, scene::Provenance, std::owner_less<>> nodes_;
  std::vector<std::filesystem::path> network_files_;
};

}  // namespace vug::loading
