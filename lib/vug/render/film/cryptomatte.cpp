// SPDX-License-Identifier: Apache-2.0
#include <vug/render/film/aovs.h>
#include <vug/render/film/cryptomatte.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <set>

namespace vug::render {
namespace {

uint32_t rotated(uint32_t v, int bits) { return (v << bits) | (v >> (32 - bits)); }

uint32_t scrambled(uint32_t block) { return rotated(block * 0xcc9e2d51u, 15) * 0x1b873593u; }

/// Quotes a text for JSON. UTF-8 is copied unchanged.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + "\"";
}

}  // namespace

std::vector<std::string> crypto_channels(const std::string& layer) {
  std::vector<std::string> names;
  for (size_t rank = 0; rank < kCryptoRanks; rank += 2)
    for (const char* channel : {"R", "G", "B", "A"})
      names.push_back(fmt::format("{}{:02}.{}", layer, rank / 2, channel));
  return names;
}

uint32_t murmur3(std::string_view text) {
  const size_t blocks = text.size() / 4;
  uint32_t hash = 0;
  for (size_t i = 0; i < blocks; ++i) {
    uint32_t block = 0;
    std::memcpy(&block, text.data() + 4 * i, 4);
    hash = rotated(hash ^ scrambled(block), 13) * 5 + 0xe6546b64u;
  }
  uint32_t tail = 0;
  for (size_t i = text.size(); i > 4 * blocks; --i)
    tail = tail << 8 | static_cast<unsigned char>(text[i - 1]);
  hash ^= scrambled(tail);  // 0 stays 0
  hash ^= static_cast<uint32_t>(text.size());
  hash = (hash ^ (hash >> 16)) * 0x85ebca6bu;
  hash = (hash ^ (hash >> 13)) * 0xc2b2ae35u;
  return hash ^ (hash >> 16);
}

uint32_t crypto_id(const std::string& name) {
  const uint32_t hash = murmur3(name), exponent = hash >> 23 & 255;
  return exponent == 0 || exponent == 255 ? hash ^ 1u << 23 : hash;
}

CryptoIds crypto_ids(const std::vector<std::string>& names) {
  CryptoIds ids;
  for (const std::string& name : names) ids.push_back(crypto_id(name));
  return ids;
}

float* write_ranks(CryptoShares shares, float* to) {
  std::stable_sort(shares.begin(), shares.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  shares.resize(kCryptoRanks);
  for (const auto& [id, share] : shares) {
    std::memcpy(to++, &id, 4);
    *to++ = share;
  }
  return to;
}

float* write_crypto(const Coverage& coverage, uint32_t samples, const CryptoIds& ids, float* to) {
  std::vector<std::pair<uint32_t, uint32_t>> shares;  // id, samples
  for (const auto& [object, count] : coverage) {
    const uint32_t id = object < ids.size() ? ids[object] : crypto_id(fmt::format("{}", object));
    const auto same = [id](const auto& share) { return share.first == id; };
    const auto known = std::find_if(shares.begin(), shares.end(), same);
    if (known != shares.end())
      known->second += count;  // objects of one material
    else
      shares.emplace_back(id, count);
  }
  CryptoShares parts;
  for (const auto& [id, count] : shares)
    parts.emplace_back(id, static_cast<float>(count) / static_cast<float>(samples));
  return write_ranks(std::move(parts), to);
}

image::Metadata crypto_metadata(const AovPlan& plan) {
  image::Metadata all;
  for (const std::string& layer : plan.names) {
    if (!is_from(layer, AovSource::cryptomatte)) continue;
    const std::string key = fmt::format("cryptomatte/{:08x}", murmur3(layer)).substr(0, 19) + "/";
    const std::vector<std::string> names = plan.crypto_names(layer);
    std::string manifest;
    for (const std::string& name : std::set<std::string>(names.begin(), names.end()))
      manifest += fmt::format("{}{}:\"{:08x}\"", manifest.empty() ? "" : ",", quoted(name),
                              crypto_id(name));
    all.insert(all.end(), {{key + "name", layer},
                           {key + "hash", "MurmurHash3_32"},
                           {key + "conversion", "uint32_to_float32"},
                           {key + "manifest", "{" + manifest + "}"}});
  }
  return all;
}

}  // namespace vug::render
