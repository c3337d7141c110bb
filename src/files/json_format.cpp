// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/json_format.h"

namespace files {
void checkFormat(const JsonReader& json, QLatin1StringView name, int newest,
                 const QString& mismatchText)
{
    if (json.text("format") != name)
        json.reportError("format", mismatchText);
    const int version = json.smallInteger("version");
    if (version < 1)
        json.reportError("version", QStringLiteral("there is no format %1").arg(version));
    else if (version > newest)
        json.reportError("version",
                         QStringLiteral("format %1 is of a newer program, this one reads "
                                        "formats up to %2")
                             .arg(version)
                             .arg(newest));
}
} // namespace files
