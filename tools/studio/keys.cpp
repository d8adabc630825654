// SPDX-License-Identifier: Apache-2.0
#include "keys.h"

#include <vug/workbench/scene_command.h>

#include <fmt/format.h>
#include <vector>

namespace vug::studio {
namespace {

struct KeyRow {
  const char *action, *keys, *effect;
};

const std::vector<KeyRow>& window_rows() {
  static const std::vector<KeyRow> rows = {
      {"act 1", "1", "Applies the first action to the selected part; 2 to 9 apply the others"},
      {"act 2", "2", ""},
      {"act 3", "3", ""},
      {"act 4", "4", ""},
      {"act 5", "5", ""},
      {"act 6", "6", ""},
      {"act 7", "7", ""},
      {"act 8", "8", ""},
      {"act 9", "9", ""},
      {"retract", "Del", "Retracts the rule of the selected part"},
      {"separate", "Ctrl+Shift+J", "Makes mirrored or repeated parts independent"},
      {"join", "Ctrl+J", "Makes separated parts copies of the first one again"},
      {"next open", "N", "Selects the next part that no rule divides"},
      {"next handle", "]", "Selects the next line or edge of the selected part"},
      {"previous handle", "[", "Selects the previous line or edge"},
      {"set scale", "Ctrl+L", "Sets the scale by two clicks and a length"},
      {"save as", "Ctrl+Shift+S", "Saves the session to another file"},
      {"frame", "F; Home", "Shows the whole facade"},
      {"zoom in", "Ctrl++; Ctrl+=", "Magnifies the view"},
      {"zoom out", "Ctrl+-", "Shrinks the view"},
      {"cancel", "Esc", "Cancels a drag or the setting of the scale; deselects the handle"},
      {"palette", "Ctrl+Shift+P", "Opens the command palette"},
      {"quit", "Ctrl+Q", "Closes the window"}};
  return rows;
}

/// Keys and buttons that the canvas handles itself.
constexpr KeyRow kCanvasRows[] = {
    {"", "Arrow keys", "Selects the parent (left), the first part (right) or a sibling (up, down)"},
    {"", "Arrow keys, with a handle", "Moves the handle by 1 cm; 10 cm with Ctrl, 1 mm with Shift"},
    {"", "Left button", "Selects a part, then the part around it; drags a handle"},
    {"", "Double click", "Removes the window of a cell, or restores it"},
    {"", "Right button", "Opens the menu of the available actions"},
    {"", "Wheel", "Zooms to the mouse"},
    {"", "Middle button, Alt + left button", "Pans"}};

/// The window of scenes.
const std::vector<KeyRow>& scene_rows() {
  static const std::vector<KeyRow> rows = {
      {"complete", "Ctrl+Space", "Lists the words that can be written at the caret"},
      {"edit text", "Ctrl+1", "Goes to the text"},
      {"look at picture", "Ctrl+2", "Goes to the picture"},
      {"list problems", "Ctrl+3", "Lists the problems"},
      {"list pictures", "Ctrl+4", "Lists the kept pictures"},
      {"list renders", "Ctrl+5", "Lists the renders of the queue"},
      {"save as", "Ctrl+Shift+S", "Saves the text to another file"},
      {"palette", "Ctrl+Shift+P", "Opens the command palette"},
      {"quit", "Ctrl+Q", "Closes the window"}};
  return rows;
}

/// Keys and buttons that the picture of a scene handles itself.
constexpr KeyRow kPictureRows[] = {
    {"", "Left button, drag", "Turns the view around its target"},
    {"", "Middle button, or Alt + left button, drag", "Moves the view"},
    {"", "Shift + left button, drag",
     "Renders only this part of the picture, until a click or Esc"},
    {"", "Ctrl + left button, drag; wheel", "Moves the eye nearer or farther away"},
    {"", "Left button, click", "Selects the declaration of the object, then its next one"},
    {"", "Left button on a handle, drag", "Changes its numbers in the text"},
    {"", "Left button on a light or a camera", "Selects its declaration"},
    {"", "Ctrl + left button, click", "Reads the values of a pixel"},
    {"", "Ctrl + Shift + left button, click", "Selects the material of the pixel"},
    {"", "Right button", "Lists all declarations of the object"},
    {"", "Left button on the edge of a wipe, drag", "Moves the edge"},
    {"", "In the list of pictures: Enter; R; Del", "Shows a picture; compares with it; forgets it"},
    {"", "Arrow keys; + and -", "Turn the view; move the eye nearer or farther away"},
    {"", "Shift + arrow keys", "Move the view"},
    {"", "Enter", "Selects the declaration of the object in the middle"}};

QString keys_in(const std::vector<KeyRow>& rows, const QString& action) {
  for (const KeyRow& row : rows)
    if (action == row.action) return row.keys;
  return "";
}

std::string row_text(const std::string& keys, const std::string& effect) {
  return fmt::format("| {} | {} |\n", keys, effect);
}

}  // namespace

QString window_keys(const QString& action) { return keys_in(window_rows(), action); }

QString scene_keys(const QString& action) { return keys_in(scene_rows(), action); }

std::string key_table() {
  std::string out = "| keys | effect |\n|---|---|\n";
  for (const workbench::Command* each : workbench::all_commands())
    if (!each->keys.empty()) out += row_text(each->keys, each->doc.substr(0, each->doc.size() - 1));
  for (const KeyRow& row : window_rows())
    if (*row.effect) out += row_text(row.keys, row.effect);
  for (const KeyRow& row : kCanvasRows) out += row_text(row.keys, row.effect);
  return out;
}

std::string scene_key_table() {
  std::string out = "| keys | effect |\n|---|---|\n";
  for (const workbench::SceneCommand* each : workbench::scene_commands())
    if (!each->keys.empty()) out += row_text(each->keys, each->doc.substr(0, each->doc.size() - 1));
  for (const KeyRow& row : scene_rows()) out += row_text(row.keys, row.effect);
  for (const KeyRow& row : kPictureRows) out += row_text(row.keys, row.effect);
  return out;
}

}  // namespace vug::studio
