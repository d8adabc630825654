// SPDX-License-Identifier: Apache-2.0
// URIs of documents and paths of files.
#pragma once

#include <filesystem>
#include <string>

namespace vug::lsp {

/// The path of a file URI. Other URIs, such as those of unsaved texts, are returned as they are.
std::filesystem::path path_of(const std::string& uri);
/// The URI of an absolute path, percent-encoded (RFC 8089); other texts are returned as they are.
std::string uri_of(const std::filesystem::path& path);

}  // namespace vug::lsp
