// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/front_end.h"

#include "text/translate.h"

#include <atomic>

namespace text {
namespace {
std::atomic<FrontEnd> current{FrontEnd::CommandLine};
}

void setFrontEnd(FrontEnd frontEnd)
{
    current = frontEnd;
}

QString recoveryName()
{
    return current == FrontEnd::Window ? translate("text", "Port → Interrupted writes")
                                       : translate("text", "recover", "command");
}

QString withRecoveryName(QString sentence)
{
    return sentence.replace(QLatin1String("%recover"), recoveryName());
}
} // namespace text
