#include <vug/scene/lexer.h>
#include <vug/session/inputs.h>

namespace vug::session {
namespace fs = std::filesystem;

std::vector<fs::path> files_named(const Loaded& scene) {
  std::vector<fs::path> files;
  std::error_code code;
  for (const auto& source : scene.sources) {
    const fs::path text = source->file;
    files.push_back(text);
    Diagnostics known;
    for (const scene::Token& token : scene::lex(source->text, source->file, known)) {
      if (token.kind != scene::TokenKind::text || token.faulty) continue;
      const fs::path named = text.parent_path() / scene::unquote(token.text);
      if (fs::is_regular_file(named, code)) files.push_back(named);
    }
  }
  return files;
}

}  // namespace vug::session
