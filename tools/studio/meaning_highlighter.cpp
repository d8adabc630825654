// SPDX-License-Identifier: Apache-2.0
#include "meaning_highlighter.h"

#include "theme.h"

#include <QTextDocument>

namespace vug::studio {
namespace {

using language::TokenMeaning;

bool same(const std::vector<language::SemanticToken>& a,
          const std::vector<language::SemanticToken>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.where.column == y.where.column && x.where.end_column == y.where.end_column &&
           x.meaning == y.meaning;
  });
}

}  // namespace

int units_before(const QString& line, int column) {
  int at = 0;
  for (int k = 1; k < column && at < line.size(); ++k)
    at += line[at].isHighSurrogate() && at + 1 < line.size() ? 2 : 1;
  return at;
}

QColor colour_of(TokenMeaning meaning) {
  const bool dark = theme().dark;
  switch (meaning) {
    case TokenMeaning::comment:
      return theme().muted;
    case TokenMeaning::text:
      return QColor(dark ? "#a5d68a" : "#3a6b1f");
    case TokenMeaning::number:
      return QColor(dark ? "#e6b673" : "#8a4b00");
    case TokenMeaning::keyword:
      return QColor(dark ? "#8fb8ff" : "#1a4fa3");
    case TokenMeaning::kind:
    case TokenMeaning::function:
      return QColor(dark ? "#d7a6ff" : "#6d2fa0");
    case TokenMeaning::argument:
    case TokenMeaning::choice:
      return QColor(dark ? "#7fd1c7" : "#0a6259");
    case TokenMeaning::param:
      return QColor(dark ? "#ff9f8a" : "#a3341f");
    case TokenMeaning::declaration:
    case TokenMeaning::symbol:
    case TokenMeaning::module:
    case TokenMeaning::value:
    case TokenMeaning::sign:
      break;
  }
  return theme().text;
}

void MeaningHighlighter::show(const std::vector<language::SemanticToken>& tokens) {
  std::map<int, std::vector<language::SemanticToken>> lines;
  for (const language::SemanticToken& each : tokens) lines[each.where.line].push_back(each);
  const auto before = std::exchange(lines_, std::move(lines));
  // Other lines have moved: their formats are those of other numbers.
  if (std::exchange(block_count_, document()->blockCount()) != document()->blockCount())
    return rehighlight();
  static const std::vector<language::SemanticToken> none;
  const auto on = [](const auto& all, int line) -> const std::vector<language::SemanticToken>& {
    const auto found = all.find(line);
    return found == all.end() ? none : found->second;
  };
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    const int line = block.blockNumber() + 1;
    if (!same(on(before, line), on(lines_, line))) rehighlightBlock(block);
  }
}

const language::SemanticToken* MeaningHighlighter::token_at(int line, int column) const {
  const auto found = lines_.find(line);
  if (found == lines_.end()) return nullptr;
  for (const language::SemanticToken& each : found->second)
    if (each.where.column <= column && column < each.where.end_column) return &each;
  return nullptr;
}

void MeaningHighlighter::highlightBlock(const QString& text) {
  const auto found = lines_.find(currentBlock().blockNumber() + 1);
  if (found == lines_.end()) return;
  for (const language::SemanticToken& each : found->second) {
    const int begin = units_before(text, each.where.column);
    QTextCharFormat format;
    format.setForeground(colour_of(each.meaning));
    if (each.declares) format.setFontWeight(QFont::DemiBold);
    setFormat(begin, units_before(text, each.where.end_column) - begin, format);
  }
}

}  // namespace vug::studio
