// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/progress.h"

#include "cli/translate.h"

#include <cmath>

namespace cli {
namespace {
constexpr auto initialDelay = std::chrono::seconds(1);
constexpr auto rewriteInterval = std::chrono::milliseconds(100);
constexpr auto lineInterval = std::chrono::seconds(2);
} // namespace

ProgressLine::ProgressLine(Console& console, QString task)
    : m_console(console)
    , m_task(std::move(task))
    , m_next(m_start + initialDelay)
{}

ProgressLine::~ProgressLine()
{
    if (m_shown && m_console.isStderrTerminal())
        m_console.showStatus({});
}

void ProgressLine::update(const jobs::Progress& progress)
{
    if (Clock::now() < m_next)
        return;
    const auto remaining = std::chrono::duration_cast<std::chrono::seconds>(progress.remaining);
    QString state = translate("cli", "%1 %, about %2 s left")
                        .arg(std::lround(progress.fraction * 100))
                        .arg(remaining.count() + 1);
    if (progress.baud > 0) {
        state += translate("cli", ", %1 at %2 baud, found: %3")
                     .arg(base::protocolName(progress.protocol))
                     .arg(progress.baud)
                     .arg(progress.found);
    }
    show(state);
}

void ProgressLine::show(const QString& state)
{
    const auto now = Clock::now();
    if (now < m_next)
        return;
    const QString line = QStringLiteral("%1: %2").arg(m_task, state);
    if (m_console.isStderrTerminal()) {
        m_console.showStatus(line);
        m_next = now + rewriteInterval;
    } else {
        m_console.printMessage(line);
        m_next = now + lineInterval;
    }
    m_shown = true;
}
} // namespace cli
