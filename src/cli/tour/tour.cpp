// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/tour/tour.h"

#include "cli/output/report_text.h"
#include "cli/translate.h"
#include "device/reader.h"
#include "protocol/codec.h"
#include "text/language.h"

#include <algorithm>

namespace cli {
namespace {
/// Time to read the output.
constexpr auto readingTime = std::chrono::milliseconds(1200);
constexpr int chapters = 9;
constexpr int hexCells = 26;
constexpr int meaningCells = 40;

QString elided(const QString& text, int cells)
{
    return text.size() <= cells ? text : text.left(cells - 1) + QStringLiteral("…");
}
} // namespace

void Tour::print(const QString& text)
{
    m_run.console().print(text + QLatin1Char('\n'));
}

void Tour::chapter(const QString& title)
{
    if (m_chapter > 0 && m_run.console().isStdoutTerminal() && !m_run.console().isJson()) {
        base::SystemClock clock;
        clock.sleepFor(readingTime, &m_run.stop());
    }
    ++m_chapter;
    print(QStringLiteral("\n== %1/%2 %3").arg(m_chapter).arg(chapters).arg(title));
}

/// The frames on the bus since the last call.
void Tour::showWire()
{
    const auto ready = context();
    for (const bus::TraceEntry& entry : ready->bus.takeTrace()) {
        const bool sent = entry.kind == bus::TraceKind::Sent;
        if (!sent && entry.kind != bus::TraceKind::Received)
            continue;
        const QString bytes = elided(base::toHex(entry.bytes), hexCells);
        const QString meaning = protocol::codecFor(entry.protocol).explain(entry.bytes, sent);
        print(QStringLiteral("  %1 %2  %3")
                  .arg(sent ? QStringLiteral("→") : QStringLiteral("←"), padded(bytes, hexCells),
                       elided(meaning, meaningCells)));
    }
}

base::Result<Exit> Tour::run()
{
    if (const auto connected = m_run.connect(); !connected)
        return tl::unexpected(connected.error());
    for (const auto step :
         {&Tour::search, &Tour::showMemory, &Tour::saveSnapshot, &Tour::changeSafely,
          &Tour::powerCycleServos, &Tour::restoreValues, &Tour::move, &Tour::explainAlarms,
          &Tour::showNewServos, &Tour::summarize}) {
        if (m_run.stop().isRequested())
            return base::fail(base::ErrorCode::Stopped, QStringLiteral("tour"));
        if (const auto done = (this->*step)(); !done)
            return tl::unexpected(done.error());
    }
    const bool isAsShown =
        m_persistentSurvived && m_temporaryReset && m_differing.isEmpty() && m_duplicatesSuspected;
    return isAsShown ? Exit::Success : Exit::Failed;
}

base::Result<void> Tour::summarize()
{
    const auto ready = context();
    Json::Array found;
    for (const jobs::FoundServo& one : m_found.found)
        found.push_back(one.servo.id);
    const bus::Statistics statistics = ready->bus.statistics();
    const bus::Counters& total = statistics.total;
    print(translate("cli", "\nTotals: servos found %1, requests %2, replies %3, retries %4; median "
                           "reply time below %5 ms.")
              .arg(m_found.found.size())
              .arg(total.sent)
              .arg(total.ok)
              .arg(total.retried)
              .arg(double(total.roundTripP50.count()) / 1000, 0, 'f', 2));
    print(m_differing.isEmpty()
              ? translate("cli", "Servo %1 has the same settings as before.").arg(m_servo.id)
              : translate("cli", "Servo %1 differs from its previous state in these registers: %2")
                    .arg(m_servo.id)
                    .arg(text::joinItems(m_differing)));
    print(translate("cli", "Next: run \"servodesk-cli ports\" to list your adapters and "
                           "\"servodesk-cli --port PORT scan\" to find your servos."));
    m_run.finish(Json::object()
                     .add("port", m_found.port)
                     .add("found", std::move(found))
                     .add("servo", m_servo.id)
                     .add("snapshot", m_snapshotFile)
                     .add("kept_survived", m_persistentSurvived)
                     .add("temporary_gone", m_temporaryReset)
                     .add("moves", m_moves)
                     .add("twins_suspected", m_duplicatesSuspected)
                     .add("differing", m_differing)
                     .add("requests", std::int64_t(total.sent))
                     .add("answered", std::int64_t(total.ok)),
                 {});
    return {};
}
} // namespace cli
