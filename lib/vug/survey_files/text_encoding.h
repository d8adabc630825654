// SPDX-License-Identifier: Apache-2.0
// Conversion of texts to UTF-8 from the encodings of survey files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vug::survey {

enum class Encoding { utf8, latin1, latin2, windows1250, windows1252 };

/// The encoding of this name in any case, e.g. "ISO8859-2", "utf-8", "cp1250"; nothing for others.
std::optional<Encoding> find_encoding(std::string_view name);

/// The text in UTF-8; nothing if the bytes are not valid in the encoding.
std::optional<std::string> to_utf8(std::string_view bytes, Encoding encoding);

/// The text, if it is UTF-8; else its bytes read as those of Windows-1252, or of Latin-1 where the
/// former has no character. For formats that do not name their encoding.
std::string as_utf8(std::string_view bytes);

}  // namespace vug::survey
