// SPDX-License-Identifier: GPL-3.0-or-later
// The name and version that every JSON document of ServoDesk begins with. What is wrong goes to the
// reader's complaint. Pure; any thread.
#pragma once

#include "files/json_reader.h"

namespace files {
/// The head of a document: "format" is `name`, or the complaint is `mismatchText`; "version" is one
/// that this program knows.
void checkFormat(const JsonReader& json, QLatin1StringView name, int newest,
                 const QString& mismatchText);
} // namespace files
