// SPDX-License-Identifier: Apache-2.0
#include <vug/base/diagnostics.h>
#include <vug/base/digester.h>
#include <vug/scene/lexer.h>
#include <vug/scene/statement_digests.h>

#include <algorithm>
#include <set>

namespace vug::scene {
namespace {
namespace fs = std::filesystem;

/// The part of a name after the prefix of its module: mentions are compared by it.
std::string own_name(const std::string& full) { return full.substr(full.rfind('.') + 1); }

/// A statement by itself.
struct StatementText {
  Digest digest;
  std::set<std::string> mentions;
};

/// Adds the size and the time of the first file that the text may mean.
void add_file(const std::string& text, const SourceLocation& where,
              const std::vector<fs::path>& folders, Hasher& hash) {
  std::vector<fs::path> candidates = {fs::path(where.file).parent_path() / text};
  for (const fs::path& folder : folders) candidates.push_back(folder / text);
  std::error_code code;
  for (const fs::path& file : candidates) {
    if (!fs::is_regular_file(file, code)) continue;
    hash.add(file.string()).add_value(fs::file_size(file, code));
    hash.add_value(fs::last_write_time(file, code).time_since_epoch().count());
    return;
  }
}

/// Whether the token is the name of an argument, as in f(radius: 1), which means no declaration.
bool names_argument(const std::vector<Token>& all, std::vector<Token>::const_iterator token) {
  return token != all.begin() && (token[-1].is("(") || token[-1].is(",")) && token[1].is(":");
}

/// Adds the names in an expression, and some words that are not names.
void add_names(const Expr& expr, std::set<std::string>& names) {
  if (!expr.text.empty()) names.insert(own_name(expr.text));
  for (const Operand& each : expr.operands)
    if (each.value) add_names(*each.value, names);
}

/// The tokens of the sources of a document.
class StatementTexts {
 public:
  StatementTexts(const Document& document, const std::vector<fs::path>& folders)
      : folders_(folders) {
    Diagnostics known;
    for (const auto& source : document.sources)
      if (!tokens_.count(source->file))
        tokens_[source->file] = lex(source->text, source->file, known);
  }

  std::optional<StatementText> at(const SourceLocation& extent) const {
    const auto found = tokens_.find(extent.file);
    if (found == tokens_.end() || !extent.has_end()) return std::nullopt;
    const std::pair end(extent.end_line, extent.end_column);
    StatementText out;
    Hasher hash;
    hash.add(extent.file);
    auto token = std::lower_bound(found->second.begin(), found->second.end(),
                                  std::pair(extent.line, extent.column),
                                  [](const Token& each, const std::pair<int, int>& position) {
                                    return std::pair(each.line, each.column) < position;
                                  });
    for (; token != found->second.end() && std::pair(token->line, token->column) < end; ++token) {
      hash.add_value(token->kind).add_value(token->text.size()).add(token->text);
      hash.add_value(token->line - extent.line).add_value(token->column);
      if (token->kind == TokenKind::name && !names_argument(found->second, token))
        out.mentions.emplace(token->text);
      if (token->kind == TokenKind::text && !token->faulty)
        add_file(unquote(token->text), extent, folders_, hash);
    }
    out.digest = hash.finish();
    return out;
  }

 private:
  const std::vector<fs::path>& folders_;
  std::map<std::string, std::vector<Token>> tokens_;  ///< By file; views of the sources.
};

/// All that a mention of a name can mean.
struct Meanings {
  std::vector<std::optional<StatementText>> globals;  ///< Parameters, lets and functions.
  std::vector<std::string> kinds;                     ///< For declarations and grammars.
};

std::map<std::string, Meanings> meanings_of(const Document& document, const StatementTexts& texts) {
  std::map<std::string, Meanings> out;
  const auto add = [&](const auto& all, char type) {
    for (const auto& each : all) {
      std::optional<StatementText> text = texts.at(each.extent);
      if (text) {
        Hasher hash;
        hash.add_value(type).add(each.name).add_value(text->digest);
        if constexpr (requires { each.given; })
          if (each.given) hash.add(dump(*each.given)), add_names(*each.given, text->mentions);
        text->digest = hash.finish();
      }
      out[own_name(each.name)].globals.push_back(std::move(text));
    }
  };
  add(document.params, 'p'), add(document.lets, 'l'), add(document.defs, 'd');
  for (const Declaration& each : document.declarations)
    out[own_name(each.name)].kinds.push_back(each.kind + ' ' + each.name);
  for (const Grammar& each : document.grammars)
    out[own_name(each.name)].kinds.push_back("grammar " + each.kind + ' ' + each.name);
  return out;
}

}  // namespace

StatementDigests::StatementDigests(const Document& document, const std::vector<fs::path>& folders) {
  const StatementTexts texts(document, folders);
  const std::map<std::string, Meanings> meanings = meanings_of(document, texts);
  const auto statement_at = [&](const SourceLocation& extent) -> std::optional<Statement> {
    const std::optional<StatementText> own = texts.at(extent);
    if (!own) return std::nullopt;
    std::set<std::string> names = own->mentions;
    std::vector<std::string> added(names.begin(), names.end());
    while (!added.empty()) {
      const auto meaning = meanings.find(added.back());
      added.pop_back();
      if (meaning == meanings.end()) continue;
      for (const std::optional<StatementText>& each : meaning->second.globals) {
        if (!each) return std::nullopt;
        for (const std::string& name : each->mentions)
          if (names.insert(name).second) added.push_back(name);
      }
    }
    Hasher hash;
    hash.add(document.seed ? dump(*document.seed) : "").add_value(own->digest);
    for (const std::string& name : names) {
      const auto meaning = meanings.find(name);
      if (meaning == meanings.end()) continue;
      hash.add_value(name.size()).add(name);
      for (const std::optional<StatementText>& each : meaning->second.globals)
        hash.add_value(each->digest);
      for (const std::string& kind : meaning->second.kinds) hash.add_value(kind.size()).add(kind);
    }
    return Statement{hash.finish(), std::move(names)};
  };
  const auto add = [&](const std::string& kind, const std::string& name,
                       const SourceLocation& extent) {
    const auto [at, is_new] = statements_.try_emplace({kind, name});
    at->second = is_new ? statement_at(extent) : std::nullopt;
    declared_[own_name(name)].emplace_back(kind, name);
  };
  for (const Declaration& each : document.declarations) add(each.kind, each.name, each.extent);
  for (const Grammar& each : document.grammars) add("grammar", each.name, each.extent);
}

std::optional<Digest> StatementDigests::find(const std::string& kind,
                                             const std::string& name) const {
  const auto found = statements_.find({kind, name});
  if (found == statements_.end() || !found->second) return std::nullopt;
  return found->second->digest;
}

std::optional<Digest> StatementDigests::find_with_mentioned(const std::string& kind,
                                                            const std::string& name) const {
  std::map<Name, Digest> all;
  std::vector<Name> added{{kind, name}};
  while (!added.empty()) {
    const Name next = std::move(added.back());
    added.pop_back();
    if (all.count(next)) continue;
    const auto found = statements_.find(next);
    if (found == statements_.end() || !found->second) return std::nullopt;
    const Statement& statement = *found->second;
    if (statement.mentions.count("frame") || statement.mentions.count("keys")) return std::nullopt;
    all.emplace(next, statement.digest);
    for (const std::string& mention : statement.mentions)
      if (const auto declared = declared_.find(mention); declared != declared_.end())
        added.insert(added.end(), declared->second.begin(), declared->second.end());
  }
  return vug::digest_of(all);
}

}  // namespace vug::scene
