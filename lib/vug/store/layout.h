// SPDX-License-Identifier: Apache-2.0
// Internal to store/: the files of a store.
#pragma once

#include <vug/store/key.h>

#include <filesystem>
#include <optional>
#include <string>

namespace vug::store {

inline constexpr const char* kObjects = "objects";
inline constexpr const char* kActions = "actions";
inline constexpr const char* kNames = "names";
inline constexpr const char* kTemporary = "tmp";

/// CLASS/ab/abcdef..., the name of a file in the store.
std::string name_of(const char* files, const std::string& hex);
/// FOLDER/CLASS/ab/abcdef...
std::filesystem::path file_of(const std::filesystem::path& folder, const char* files,
                              const std::string& hex);

/// The digest of a file's content; nothing if it cannot be read.
std::optional<Digest> digest_of_file(const std::filesystem::path& file);

/// Whether a file's content has the digest; false for a file that cannot be read.
bool is_intact(const std::filesystem::path& file, const std::string& hex);

/// The content of a small file whose last line is a digest of the rest; nothing if it is absent or
/// damaged.
std::optional<std::string> read_sealed(const std::filesystem::path& file);
/// Writes such a file. Returns false if it could not be written.
bool write_sealed(const std::filesystem::path& store, const std::filesystem::path& file,
                  const std::string& text);

/// Removes a file if it exists and can be removed; returns whether it did.
bool discard(const std::filesystem::path& file);

/// An unused name in the folder of temporary files.
std::filesystem::path temporary_file(const std::filesystem::path& store,
                                     const std::string& extension);
/// Moves a temporary file to its place. Returns an empty text, or the reason of the failure.
std::string move_into_place(const std::filesystem::path& temporary,
                            const std::filesystem::path& target);

/// Whether a text from elsewhere is a digest with an extension, and nothing that leads to other
/// folders.
bool is_object_name(const std::string& text);

/// The content of a file of kActions.
struct Action {
  std::string key;  ///< The digest of the key, so that a copied file is not mistaken for another.
  std::string kind;
  std::string object;  ///< Name of the file in kObjects.
  uint64_t bytes = 0;
  double seconds = 0;
};
std::string to_text(const Action& action);
std::optional<Action> parse_action(const std::string& text);

/// Removes the least recently used objects of the object's shard, those whose names begin with the
/// same digit, if they have more than a sixteenth of `max_bytes`: down to 0.8 of that, but not the
/// object itself.
void trim_shard(const std::filesystem::path& store, const std::string& object, uint64_t max_bytes);

}  // namespace vug::store
