// SPDX-License-Identifier: Apache-2.0
// Cryptomatte: ids and coverage of the objects, materials and elements in each pixel, for
// compositing programs. Friedman and Jones 2015, "Fully automatic ID mattes with support for motion
// blur and transparency" (cite friedman2015cryptomatte), and version 1.2 of its specification.
#pragma once

#include <vug/image/io.h>
#include <vug/render/film/film.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vug::render {

struct AovPlan;

inline constexpr const char* kCryptoObject = "CryptoObject";
inline constexpr const char* kCryptoMaterial = "CryptoMaterial";
/// For elements of objects: Object::elements.
inline constexpr const char* kCryptoElement = "CryptoElement";
/// Number of ids per pixel, those with the largest coverage; in pairs, R G and B A of a layer.
constexpr size_t kCryptoRanks = 6;
std::vector<std::string> crypto_channels(const std::string& layer);

/// MurmurHash3_x86_32 with seed 0 (Appleby 2011), as the specification requires.
uint32_t murmur3(std::string_view text);
/// The hash of a name, with a bit changed if needed to make it a normal float.
uint32_t crypto_id(const std::string& name);

/// Ids of the names, by index.
using CryptoIds = std::vector<uint32_t>;
CryptoIds crypto_ids(const std::vector<std::string>& names);
/// Pairs of an id and its share of the pixel.
using CryptoShares = std::vector<std::pair<uint32_t, float>>;
/// Writes id and share for each rank, sorted by descending share and padded with zeros; returns the
/// pointer past the end.
float* write_ranks(CryptoShares shares, float* to);
/// Writes the ranks of coverage counts out of `samples`.
float* write_crypto(const Coverage& coverage, uint32_t samples, const CryptoIds& ids, float* to);

/// The header metadata of the picture's Cryptomatte layers, with the manifest of names.
image::Metadata crypto_metadata(const AovPlan& plan);

}  // namespace vug::render
