// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/exchange/crate_tables.h>

#include <fmt/format.h>

#include <limits>

namespace vug::exchange {
namespace {

/// Indices are written as signed numbers of 32 bits.
uint32_t next_crate_index(size_t size, const char* what) {
  if (size >= static_cast<size_t>(std::numeric_limits<int32_t>::max()))
    throw Error(ErrorCode::too_large, fmt::format("a binary USD file has at most 2^31 {}", what),
                {}, "export to .usda, or export parts of the scene");
  return static_cast<uint32_t>(size);
}

}  // namespace

uint32_t CrateTokens::token(const std::string& text) {
  const auto found = token_of_.find(text);
  if (found != token_of_.end()) return found->second;
  if (text.find('\0') != std::string::npos)
    throw Error(ErrorCode::bad_input, "a text with a zero byte cannot be in a binary USD file", {},
                "remove the zero byte from the scene");
  const auto added = token_of_.emplace(text, next_crate_index(tokens_.size(), "tokens")).first;
  tokens_.push_back(&added->first);
  return added->second;
}

uint32_t CrateTokens::string(const std::string& text) {
  const auto [found, fresh] =
      string_of_.try_emplace(token(text), next_crate_index(strings_.size(), "strings"));
  if (fresh) strings_.push_back(found->first);
  return found->second;
}

uint32_t CrateFields::add(const Set& set) {
  std::vector<int32_t> indices;
  for (const auto& field : set) {
    const auto [found, fresh] = index_of_.try_emplace(
        field, static_cast<int32_t>(next_crate_index(fields_.size(), "fields")));
    if (fresh) fields_.push_back(field);
    indices.push_back(found->second);
  }
  indices.push_back(-1);
  const auto [found, fresh] =
      set_of_.try_emplace(indices, next_crate_index(sets_.size(), "entries of sets of fields"));
  if (fresh) sets_.insert(sets_.end(), indices.begin(), indices.end());
  return found->second;
}

uint32_t CratePaths::child(uint32_t parent, const std::string& element, bool property) {
  const uint32_t token = tokens_.token(element);
  const int64_t key = property ? -static_cast<int64_t>(token) : token;
  const auto [found, fresh] =
      child_of_.try_emplace({parent, key}, next_crate_index(nodes_.size(), "paths"));
  if (fresh) {
    nodes_.push_back({token, property});
    nodes_[parent].children.push_back(found->second);
  }
  return found->second;
}

uint32_t CratePaths::path(std::string_view text) {
  const size_t dot = text.find('.');
  std::string_view prims = text.substr(0, dot);
  uint32_t at = kRoot;
  while (!prims.empty()) {
    prims.remove_prefix(1);  // the slash
    const std::string_view name = prims.substr(0, prims.find('/'));
    if (!name.empty()) at = child(at, std::string(name));
    prims.remove_prefix(name.size());
  }
  return dot == std::string_view::npos ? at : child(at, std::string(text.substr(dot + 1)), true);
}

uint32_t CratePaths::empty() {
  if (empty_ == 0) {
    empty_ = next_crate_index(nodes_.size(), "paths");
    nodes_.push_back({});
  }
  return empty_;
}

CratePaths::Encoded CratePaths::encode() const {
  Encoded out;
  encode(kRoot, false, out);
  return out;
}

void CratePaths::encode(uint32_t node, bool has_sibling, Encoded& out) const {
  const Node& here = nodes_[node];
  const auto token = static_cast<int32_t>(here.token);
  const size_t at = out.paths.size();
  out.paths.push_back(static_cast<int32_t>(node));
  out.elements.push_back(here.property ? -token : token);
  out.jumps.push_back(0);
  for (const uint32_t& child : here.children) encode(child, &child != &here.children.back(), out);
  const bool has_child = !here.children.empty();
  out.jumps[at] = has_sibling && has_child ? static_cast<int32_t>(out.paths.size() - at)
                  : has_sibling            ? 0
                  : has_child              ? -1
                                           : -2;
}

}  // namespace vug::exchange
