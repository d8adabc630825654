// SPDX-License-Identifier: Apache-2.0
// Colours of the words of a scene text by their meaning.
#pragma once

#include <vug/language/semantic_tokens.h>

#include <QColor>
#include <QSyntaxHighlighter>
#include <map>
#include <vector>

namespace vug::studio {

/// A colour of the theme that is readable on its panels.
QColor colour_of(language::TokenMeaning meaning);

/// UTF-16 units of a line before a column, which counts characters from 1.
int units_before(const QString& line, int column);

class MeaningHighlighter : public QSyntaxHighlighter {
 public:
  explicit MeaningHighlighter(QTextDocument* document) : QSyntaxHighlighter(document) {}

  /// Colours the lines whose tokens have changed.
  void show(const std::vector<language::SemanticToken>& tokens);
  void restyle() { rehighlight(); }
  /// Null outside of a token; 1-based.
  const language::SemanticToken* token_at(int line, int column) const;

 protected:
  void highlightBlock(const QString& text) override;

 private:
  std::map<int, std::vector<language::SemanticToken>> lines_;
  int block_count_ = 0;  ///< At the last `show`.
};

}  // namespace vug::studio
