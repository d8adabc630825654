// SPDX-License-Identifier: Apache-2.0
#include <vug/loading/provenance.h>
#include <vug/scene/lsystem_document.h>

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace vug::loading {

ProvenanceTable::ProvenanceTable(const scene::Document& document) {
  for (const scene::Declaration& each : document.declarations)
    declared_.push_back({each.kind, each.name, each.extent});
  for (const scene::Def& each : document.defs) declared_.push_back({"def", each.name, each.extent});
  for (const scene::Grammar& grammar : document.grammars) {
    declared_.push_back({"grammar", grammar.name, grammar.extent});
    const auto add = [&](const std::string& head, const SourceLocation& where) {
      declared_.push_back({"rule", fmt::format("{}/{}", grammar.name, head), where});
    };
    for (const scene::Rule& rule : grammar.rules) add(rule.head, rule.extent);
    if (grammar.lsystem)
      scene::for_each_production(*grammar.lsystem, [&](const scene::Production& production) {
        add(production.head.name, production.extent);
      });
  }
  std::map<std::string, size_t> rank;
  for (const auto& source : document.sources) {
    rank.emplace(source->file, rank.size());
    if (source->included_from.known()) included_from_[source->file] = source->included_from;
  }
  std::stable_sort(declared_.begin(), declared_.end(), [&](const Declared& a, const Declared& b) {
    return std::tuple(rank[a.where.file], a.where.line, a.where.column) <
           std::tuple(rank[b.where.file], b.where.line, b.where.column);
  });
}

const ProvenanceTable::Declared* ProvenanceTable::find(const std::string& kind,
                                                       const std::string& element) const {
  const std::string name = scene::name_without_index(element);
  for (const Declared& each : declared_)
    if (each.kind == kind && each.name == name) return &each;
  return nullptr;
}

const scene::Provenance* ProvenanceTable::find(const field::NodePtr& node) const {
  const auto found = nodes_.find(node);
  return found == nodes_.end() ? nullptr : &found->second;
}

std::vector<ProvenanceTable::Step> ProvenanceTable::chain(
    const scene::Provenance& provenance) const {
  std::vector<Step> steps;
  for (const scene::Frame* each = provenance.frame.get(); each; each = each->outer.get())
    steps.push_back({"in " + each->what, each->where});
  auto from = included_from_.find(provenance.where.file);
  for (; from != included_from_.end(); from = included_from_.find(from->second.file))
    steps.push_back({"included from", from->second});
  return steps;
}

std::string ProvenanceTable::describe(const scene::Provenance& provenance) const {
  std::string out = range_text(provenance.where);
  for (const Step& step : chain(provenance)) {
    const bool includes = step.what == "included from";
    out += fmt::format(", {}{}{}", step.what, includes ? " " : " at ", to_string(step.where));
  }
  return out;
}

void ProvenanceTable::record(const field::NodePtr& node, const scene::Provenance& provenance) {
  std::vector<field::NodePtr> pending = {node};
  while (!pending.empty()) {
    const field::NodePtr next = std::move(pending.back());
    pending.pop_back();
    if (!nodes_.emplace(next, provenance).second) continue;
    for (field::NodePtr& child : next->children()) pending.push_back(std::move(child));
  }
}

void ProvenanceTable::record_files(const std::vector<std::filesystem::path>& files) {
  for (const std::filesystem::path& file : files)
    if (std::find(network_files_.begin(), network_files_.end(), file) == network_files_.end())
      network_files_.push_back(file);
}

}  // namespace vug::loading
