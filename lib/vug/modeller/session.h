// SPDX-License-Identifier: Apache-2.0
// Modelling sessions: the complete history of a facade, stored as a file.
#pragma once

#include <vug/modeller/history.h>

#include <functional>
#include <optional>
#include <string>

namespace vug::modeller {

/// The photo that is modelled after. The library never opens the file.
struct Photo {
  std::string file;
  int width = 0, height = 0;  ///< Pixels; 0: unknown.
  double scale = 0;           ///< Pixel size in metres; 0: unknown.
};

struct SessionHeader {
  std::string grammar;  ///< File name as written in the session.
  /// Name of the grammar in the file; empty if the file has only one of kind facade.
  std::string facade = {};
  /// Metres; by default the size of the photo, else the size that the grammar asks for.
  std::optional<double> width = {}, height = {};
  std::optional<Photo> photo = {};
  double min_size = Canvas().min_size;
  uint64_t seed = 0;
};

struct Session {
  SessionHeader header;
  History history;

  const FacadeState& current() const { return history.current(); }
  /// 0 if unknown.
  double metres_per_pixel() const;
};

/// Loads the grammar of a file named in a session. Error(bad_input) if the file has none.
using StyleLoader = std::function<StylePtr(const std::string& file, const std::string& facade)>;

/// A session without edits. Error(bad_input) if the size of the facade is unknown.
Session new_session(SessionHeader header, const StyleLoader& load);

/// Reads a session and performs its edits. Error(bad_input) with line and column, the value's JSON
/// pointer and a hint for any fault, including an edit that cannot be performed. `file` names the
/// text in messages.
Session read_session(const std::string& text, const std::string& file, const StyleLoader& load);

/// The session as a file. Reading it and writing it again reproduces the same bytes.
std::string session_text(const Session& session);

}  // namespace vug::modeller
