// Sessions: everything that has been done to a facade, as a file tells it.
#pragma once

#include <vug/modeller/history.h>

#include <functional>
#include <optional>
#include <string>

namespace vug::modeller {

/// What is modelled after. The library never opens it.
struct Photo {
  std::string file;
  int width = 0, height = 0;  ///< Pixels; 0: not known.
  double scale = 0;           ///< Metres that a pixel is wide and high; 0: not known.
};

struct SessionHeader {
  std::string grammar;      ///< A file, as the session names it.
  std::string facade = {};  ///< Which grammar of it; empty: it has only one of kind facade.
  /// Metres; without them those of the photo, else those that the grammar asks for.
  std::optional<double> width = {}, height = {};
  std::optional<Photo> photo = {};
  double min_size = Canvas().min_size;
  uint64_t seed = 0;
};

struct Session {
  SessionHeader header;
  History history;

  const FacadeState& now() const { return history.now(); }
  /// 0 where nothing tells.
  double metres_per_pixel() const;
};

/// The grammar of a file that a session names. Error(bad_input) where there is none.
using StyleLoader = std::function<StylePtr(const std::string& file, const std::string& facade)>;

/// A session without edits. Error(bad_input) where nothing tells how large the facade is.
Session new_session(SessionHeader header, const StyleLoader& load);

/// Reads a session and does its edits. Error(bad_input) with line and column, the value's pointer
/// and a hint for whatever is wrong, an edit that cannot be done among it. `file` names the text in
/// messages.
Session read_session(const std::string& text, const std::string& file, const StyleLoader& load);

/// The file: reading it gives the same state and the same bytes.
std::string session_text(const Session& session);

}  // namespace vug::modeller
