// SPDX-License-Identifier: Apache-2.0
// The commands of .svx files, one function each; commands.cpp has the table of their names.
#pragma once

#include <vug/survey_files/svx/reader.h>

namespace vug::survey::svx {

// commands_scope.cpp
void command_begin(Reader& reader, Line& line);
void command_end(Reader& reader, Line& line);
void command_prefix(Reader& reader, Line& line);

// commands_readings.cpp: settings of data lines
void command_calibrate(Reader& reader, Line& line);
void command_cartesian(Reader& reader, Line& line);
void command_data(Reader& reader, Line& line);
void command_date(Reader& reader, Line& line);
void command_declination(Reader& reader, Line& line);
void command_sd(Reader& reader, Line& line);
void command_units(Reader& reader, Line& line);

// commands_stations.cpp
void command_cs(Reader& reader, Line& line);
void command_entrance(Reader& reader, Line& line);
void command_equate(Reader& reader, Line& line);
void command_export(Reader& reader, Line& line);
void command_fix(Reader& reader, Line& line);

// commands_text.cpp: settings of names and characters, texts
void command_alias(Reader& reader, Line& line);
void command_case(Reader& reader, Line& line);
void command_flags(Reader& reader, Line& line);
void command_infer(Reader& reader, Line& line);
void command_require(Reader& reader, Line& line);
void command_set(Reader& reader, Line& line);
void command_title(Reader& reader, Line& line);
void command_truncate(Reader& reader, Line& line);

/// Reads ON or OFF.
bool read_switch(Line& line);

}  // namespace vug::survey::svx
