// SPDX-License-Identifier: Apache-2.0
#include <vug/survey_files/therion/centreline.h>
#include <vug/survey_files/therion/read.h>

#include <fmt/format.h>

#include <algorithm>

namespace vug::survey::therion {
namespace {

constexpr size_t kDeepestNesting = 100;

/// Blocks that do not contain centrelines; "end" and the name closes them.
bool is_skipped_block(const std::string& command) {
  static const std::string_view all[] = {"map", "scrap", "surface", "layout", "lookup", "comment"};
  return std::find(std::begin(all), std::end(all), command) != std::end(all);
}
/// Commands of one line that do not affect centrelines.
bool is_skipped(const std::string& command) {
  static const std::string_view all[] = {"join",   "select", "unselect", "sketch", "maps", "source",
                                         "system", "text",   "export",   "person", "log"};
  return std::find(std::begin(all), std::end(all), command) != std::end(all);
}

/// A survey that is not closed yet.
struct Level {
  std::string id;
  std::string path;
  SourceLocation where;
};

class Reader {
 public:
  Reader(InputFiles& files, Diagnostics& warnings)
      : files_(files),
        stations_(result_.stations),
        context_{result_, stations_, warnings, known_grades()} {}

  Observations read(std::string_view text) {
    read_file(text);
    return std::move(result_);
  }

 private:
  void read_file(std::string_view text) {
    Tokens tokens(text, files_.current().string());
    const size_t depth = levels_.size();
    const bool outside = !centreline_;
    while (tokens.next()) read_line(tokens, depth);
    if (centreline_ && outside)
      fail("'centreline' is not closed", centreline_->start(), "add 'endcentreline'");
    if (levels_.size() > depth)
      fail(fmt::format("the survey {} is not closed", quote_text(levels_.back().id)),
           levels_.back().where, "add 'endsurvey'");
    if (!skipped_.empty())
      fail(fmt::format("'{}' is not closed", skipped_), skipped_where_,
           fmt::format("add 'end{}'", skipped_));
    if (grade_) fail("'grade' is not closed", grade_where_, "add 'endgrade'");
  }

  std::string path() const { return levels_.empty() ? "" : levels_.back().path; }

  void read_line(Tokens& tokens, size_t depth) {
    const std::vector<Token>& line = tokens.line();
    const std::string command = line[0].is_word() ? lower_case(line[0].text) : "";
    if (!skipped_.empty()) {
      if (command == "end" + skipped_) skipped_.clear();
    } else if (command == "encoding") {
      read_encoding(tokens);
    } else if (command == "input") {
      input(line);
    } else if (grade_) {
      if (command == "endgrade") {
        context_.grades[grade_name_] = *std::exchange(grade_, std::nullopt);
      } else {
        read_deviations(line, 0, *grade_);
      }
    } else if (centreline_) {
      if (command == "endcentreline" || command == "endcenterline") {
        centreline_->finish();
        centreline_.reset();
      } else {
        centreline_->read_line(line);
      }
    } else {
      read_command(command, line, depth);
    }
  }

  void read_command(const std::string& command, const std::vector<Token>& line, size_t depth) {
    if (command == "survey") {
      begin_survey(line);
    } else if (command == "endsurvey") {
      if (levels_.size() <= depth)
        fail("'endsurvey' without 'survey'", line[0].where,
             "remove it, or add 'survey NAME' above");
      if (line.size() > 1 && line[1].text != levels_.back().id)
        fail(fmt::format("'endsurvey {}' closes the survey {}", line[1].text,
                         quote_text(levels_.back().id)),
             line[1].where, "close the inner survey first");
      levels_.pop_back();
    } else if (command == "centreline" || command == "centerline") {
      centreline_.emplace(context_, path(), line[0].where);
    } else if (command == "equate") {
      equate(line, path(), context_);
    } else if (command == "grade") {
      if (line.size() < 2) fail("'grade' lacks a name", line[0].where, "write: grade NAME");
      grade_.emplace();
      grade_name_ = line[1].text;
      grade_where_ = line[0].where;
    } else if (is_skipped_block(command)) {
      skipped_ = command;
      skipped_where_ = line[0].where;
    } else if (command == "import" || command == "revise") {
      fail(fmt::format("'{}' is not supported", command), line[0].where,
           command == "import" ? "read the imported file on its own"
                               : "write the changes into the survey");
    } else if (!is_skipped(command)) {
      fail(fmt::format("unknown command {}", quote_text(line[0].text)), line[0].where,
           suggestion(command, {"survey", "endsurvey", "centreline", "centerline", "equate",
                                "grade", "input", "encoding", "map", "scrap", "surface"}));
    }
  }

  void begin_survey(const std::vector<Token>& line) {
    if (line.size() < 2)
      fail("'survey' lacks a name", line[0].where, "write: survey NAME -title \"TITLE\"");
    if (levels_.size() >= kDeepestNesting)
      fail(fmt::format("surveys are nested more than {} levels deep", kDeepestNesting),
           line[0].where, "close the surveys");
    if (line[1].text.find_first_of("@.") != std::string::npos)
      fail(fmt::format("the name {} of a survey contains '@' or '.'", quote_text(line[1].text)),
           line[1].where, "use letters, digits, '-' and '_'");
    Level level{line[1].text, full_name(line[1], path()), line[0].where};
    std::string title;
    std::optional<Token> entrance;
    for (size_t i = 2; i < line.size(); ++i) {
      const std::string option = lower_case(line[i].text);
      if (!line[i].is_word() || !option.starts_with('-')) continue;
      if (i + 1 >= line.size())
        fail(fmt::format("the option {} lacks a value", quote_text(option)), line[i].where,
             "write a value after the option");
      if (option == "-title") title = line[i + 1].text;
      if (option == "-namespace" && lower_case(line[i + 1].text) == "off") level.path = path();
      if (option == "-entrance") entrance = line[i + 1];
      if (option == "-declination")
        fail("a declination of a whole survey is not supported", line[i].where,
             "write 'declination VALUE UNIT' into its centrelines");
    }
    if (result_.title.empty()) result_.title = title.empty() ? level.id : title;
    if (entrance)
      result_
          .stations[static_cast<size_t>(
              stations_.find_or_add(full_name(*entrance, level.path), entrance->where))]
          .entrance = true;
    levels_.push_back(std::move(level));
  }

  void read_encoding(Tokens& tokens) {
    const std::vector<Token>& line = tokens.line();
    const auto encoding = line.size() == 2 ? find_encoding(line[1].text) : std::nullopt;
    if (!encoding)
      fail(fmt::format("unknown encoding {}", quote_text(line.size() > 1 ? line[1].text : "")),
           line.back().where, "known: utf-8, iso8859-1, iso8859-2, cp1250, cp1252");
    tokens.set_encoding(*encoding);
  }

  void input(const std::vector<Token>& line) {
    if (line.size() != 2)
      fail("'input' names no file, or more than one", line[0].where,
           "write: input \"FILE.th\", with quotes around spaces");
    const std::string name = lower_case(line[1].text);
    if (name.ends_with(".th2")) return;  // Drawings.
    const std::string text = files_.enter(line[1].text, ".th", line[1].where);
    if (files_.current().extension() != ".th2") read_file(text);
    files_.leave();
  }

  InputFiles& files_;
  Observations result_;
  NamedStations stations_;
  Context context_;
  std::vector<Level> levels_;
  std::optional<Centreline> centreline_;
  std::string skipped_;  ///< The name of the block that is being skipped, or empty.
  SourceLocation skipped_where_;
  std::optional<Grade> grade_;  ///< The grade that is being defined.
  std::string grade_name_;
  SourceLocation grade_where_;
};

}  // namespace

Observations read(std::string_view text, InputFiles& files, Diagnostics& warnings) {
  return Reader(files, warnings).read(text);
}

}  // namespace vug::survey::therion
