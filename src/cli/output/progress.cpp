// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/progress.h"

#include "cli/translate.h"
#include "text/bus_text.h"
#include "text/progress_text.h"

namespace cli {
namespace {
constexpr auto initialDelay = std::chrono::seconds(1);
constexpr auto rewriteInterval = std::chrono::milliseconds(100);
constexpr auto lineInterval = std::chrono::seconds(2);
} // namespace

ProgressLine::ProgressLine(Console& console, QString task)
    : m_console(console)
    , m_task(std::move(task))
    , m_next(Clock::now() + initialDelay)
{}

ProgressLine::~ProgressLine()
{
    if (m_shown)
        m_console.showStatus({});
}

void ProgressLine::update(const jobs::Progress& progress)
{
    const auto now = Clock::now();
    const auto left = m_left.estimate(
        progress, std::chrono::duration_cast<base::Duration>(now.time_since_epoch()));
    if (now < m_next)
        return;
    QString state = text::progressText(progress.fraction, left);
    if (progress.baud > 0) {
        state += translate("cli", ", %1 at %2 baud, found: %3")
                     .arg(text::protocolText(progress.protocol))
                     .arg(progress.baud)
                     .arg(progress.found);
    }
    show(state);
}

void ProgressLine::show(const QString& state)
{
    const auto now = Clock::now();
    if (now < m_next || m_console.isStderrFile())
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
