// Which objects and materials a pixel shows, with their share of it, as compositing programs read
// it: Friedman and Jones 2015, "Fully automatic ID mattes with support for motion blur and
// transparency" (cite friedman2015cryptomatte), and version 1.2 of its specification.
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
/// Of what objects are divided into: Object::elements.
inline constexpr const char* kCryptoElement = "CryptoElement";
bool is_crypto(const std::string& layer);
/// Objects of a pixel that are told, those that show most; in pairs, R G and B A of a layer.
constexpr size_t kCryptoRanks = 6;
std::vector<std::string> crypto_channels(const std::string& layer);

/// MurmurHash3_x86_32 with seed 0 (Appleby 2011), which the specification asks for.
uint32_t murmur3(std::string_view text);
/// The hash of a name with its bits changed so that it is a usable float.
uint32_t crypto_id(const std::string& name);

/// Of the names by their index.
using CryptoIds = std::vector<uint32_t>;
CryptoIds crypto_ids(const std::vector<std::string>& names);
/// Ids with their shares of a pixel.
using CryptoShares = std::vector<std::pair<uint32_t, float>>;
/// Writes id and share for each rank, those that show most, nothing as 0; returns the place behind.
float* write_ranks(CryptoShares shares, float* to);
/// The same for shares of `samples`.
float* write_crypto(const Coverage& coverage, uint32_t samples, const CryptoIds& ids, float* to);

/// What a picture's header must say of its Cryptomatte layers, with the list of names.
image::Metadata crypto_metadata(const AovPlan& plan);

}  // namespace vug::render
