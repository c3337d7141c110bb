// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run.h"

#include "cli/input/arguments.h"
#include "cli/output/report_text.h"
#include "cli/translate.h"
#include "device/reader.h"
#include "device/write_access.h"
#include "session/snapshot/safety_snapshot.h"
#include "text/error_text.h"
#include "text/language.h"
#include "text/notice_text.h"
#include "transport/port_lease.h"
#include "transport/port_opener.h"

#include <algorithm>

namespace cli {
using base::ErrorCode;

Run::Run(Globals globals, Console& console, const base::StopToken& stop)
    : m_globals(std::move(globals))
    , m_console(console)
    , m_stop(stop)
{}

session::Session& Run::session()
{
    if (!m_session) {
        m_session = std::make_unique<session::Session>();
        for (const catalog::LoadWarning& warning : m_session->warnings()) {
            m_console.printMessage(translate("cli", "Warning: %1, %2: %3")
                                       .arg(warning.file, warning.where, warning.detail));
        }
    }
    return *m_session;
}

void Run::setDefaultPort(const QString& port)
{
    if (m_globals.port.isEmpty())
        m_globals.port = port;
}

/// Without --port the only adapter is used; with none or several the user must choose.
base::Result<QString> Run::choosePort()
{
    if (!m_globals.port.isEmpty())
        return m_globals.port;
    const auto adapters = session::adapters();
    if (adapters.size() == 1) {
        m_console.printNote(translate("cli", "Using the only adapter, %1.").arg(adapters[0].path));
        return adapters[0].path;
    }
    QStringList names;
    for (const transport::PortInfo& info : adapters)
        names << info.path;
    names += session::simulatedPorts();
    const QString why = adapters.empty()
                            ? translate("cli", "no adapter is connected; select a port with "
                                               "--port: %1")
                            : translate("cli", "several adapters are connected; select one with "
                                               "--port: %1");
    return badArgument(why.arg(text::joinItems(names)));
}

base::Result<session::Connection*> Run::connect()
{
    if (m_connection)
        return m_connection.get();
    const auto port = choosePort();
    if (!port)
        return tl::unexpected(port.error());
    m_port = *port;
    auto connection = session().connect(requestFor(m_port));
    if (!connection)
        return tl::unexpected(connection.error());
    m_connection = std::move(*connection);
    if (m_connection->isSimulated())
        m_console.printNote(
            translate("cli", "SIMULATED bus %1").arg(m_connection->bus().portName()));
    if (!m_listsOpenChanges)
        warnOfOpenChanges();
    return m_connection.get();
}

session::PortRequest Run::requestFor(const QString& port) const
{
    session::PortRequest request;
    request.name = port;
    request.baud = m_globals.baud;
    request.protocol = m_globals.protocol;
    request.frameSilence = m_globals.frameSilence;
    request.maxReplyLateness = m_globals.maxReplyLateness;
    request.retries = m_globals.retries;
    return request;
}

QString Run::portName() const
{
    return m_port.isEmpty() ? QString() : transport::canonicalPath(m_port);
}

/// On stderr in JSON mode too, because not every document has notes.
void Run::warn(const char* code, int id, const QString& text)
{
    m_console.printMessage(text);
    Json note = Json::object().add("code", QString::fromLatin1(code));
    if (id >= 0)
        note.add("id", id);
    m_warnings.push_back(note.add("text", text));
}

/// Silent if the history cannot be read: the first write reports that.
void Run::warnOfOpenChanges()
{
    const auto open = session().journal().open();
    if (!open)
        return;
    const QString port = m_connection->bus().portName();
    QStringList ids;
    for (const base::Intent& intent : *open) {
        if (intent.servo.port != port || intent.isActiveElsewhere)
            continue;
        m_openChanges.push_back(intent);
        ids << QString::number(intent.servo.id);
    }
    ids.removeDuplicates();
    if (ids.isEmpty())
        return;
    warn("open-change", ids.size() == 1 ? ids.front().toInt() : -1,
         translate("cli", "A change on this port was interrupted (servo ID %1). To see, finish or "
                          "undo the change: %2")
             .arg(text::joinItems(ids), recoverCommand()));
}

bool Run::hasOpenChange(int id) const
{
    return std::any_of(m_openChanges.begin(), m_openChanges.end(),
                       [id](const base::Intent& intent) { return intent.servo.id == id; });
}

QString Run::recoverCommand() const
{
    return QStringLiteral("servodesk-cli recover --port ") + m_connection->bus().portName();
}

/// The check takes some reads, so it runs only after something unusual.
void Run::reportDuplicates(const device::Servo& servo)
{
    bus::Bus& bus = m_connection->bus();
    const auto strays = bus.takeUnexpectedFrames();
    const bool second =
        std::any_of(strays.begin(), strays.end(),
                    [&](const bus::UnexpectedFrame& stray) { return stray.id == servo.id; });
    const bus::Counters total = bus.statistics().total;
    const bool broken =
        total.badChecksums > 0 || total.foreign > 0 || total.noiseBytes > 0 || total.retried > 0;
    const auto ready = context();
    if (!(second || broken) || !ready)
        return;
    const auto alone = device::requireUniqueId(*ready, servo, QStringLiteral("read"));
    if (alone || alone.error().code != ErrorCode::DuplicateId)
        return;
    const text::Description words = text::describe(alone.error());
    warn("several-servos", servo.id,
         QStringList{words.message, words.cause, words.remedy}.join(QLatin1Char('\n')));
}

base::Result<device::Context> Run::context()
{
    const auto connection = connect();
    if (!connection)
        return tl::unexpected(connection.error());
    return (*connection)->context(m_stop, m_notices);
}

namespace {
/// Whether anything is received in one of the protocols.
bool heard(const device::Context& context, int id, const std::vector<base::Protocol>& protocols,
           base::Duration timeout)
{
    return std::any_of(protocols.begin(), protocols.end(), [&](base::Protocol protocol) {
        bus::Transaction ping;
        ping.request = protocol::Request::ping(id).in(protocol);
        ping.retries = 1;
        ping.timeout = timeout;
        ping.stop = &context.stop;
        const auto outcome = context.bus.transact(ping);
        return outcome || (outcome.error().code != ErrorCode::NoReply &&
                           outcome.error().code != ErrorCode::BadArgument);
    });
}
} // namespace

/// --baud auto: uses the first baud rate at which the servo replies. The first pass does not wait
/// for slow adapters.
base::Result<device::Servo> Run::findRate(const device::Context& context, int id)
{
    for (const auto timeout : {context.bus.statistics().timeout, context.bus.maxReplyLateness()}) {
        for (const int rate : transport::standardBaudRates()) {
            if (m_stop.isRequested())
                return base::fail(ErrorCode::Stopped, QStringLiteral("identify"), {}, id);
            const auto set = context.bus.setBaud(rate);
            if (!set && set.error().code == ErrorCode::RateUnsupported)
                continue;
            if (!set)
                return tl::unexpected(set.error());
            if (!heard(context, id, m_connection->protocols(), timeout))
                continue;
            auto servo = device::identifyAmong(context, id, m_connection->protocols());
            if (servo) {
                m_rateFound = true;
                m_console.printNote(
                    translate("cli", "Servo %1 replies at %2 baud.").arg(id).arg(rate));
                return servo;
            }
            if (servo.error().code == ErrorCode::LinkLost ||
                servo.error().code == ErrorCode::AmbiguousProtocol)
                return servo;
        }
    }
    return base::fail(ErrorCode::NoReply, QStringLiteral("identify"),
                      translate("cli", "all known baud rates were tried"), id);
}

base::Result<device::Servo> Run::servo(int id)
{
    const auto ready = context();
    if (!ready)
        return tl::unexpected(ready.error());
    const bool search = m_globals.autoBaud && !m_rateFound && ready->bus.canSetBaud();
    auto found = search ? findRate(*ready, id)
                        : device::identifyAmong(*ready, id, m_connection->protocols());
    if (found)
        m_connection->addStopTarget(*found);
    return found;
}

base::Result<device::Servo> Run::servoWithSettings(int id)
{
    auto found = servo(id);
    if (!found)
        return found;
    const auto ready = context();
    if (const auto read = device::readSettings(*ready, *found); !read)
        return tl::unexpected(read.error());
    return found;
}

base::Result<device::Servo> Run::servo(const Values& values)
{
    return parseId(values.argument("ID")).and_then([this](int id) { return servo(id); });
}

base::Result<device::Servo> Run::servoWithSettings(const Values& values)
{
    return parseId(values.argument("ID")).and_then([this](int id) {
        return servoWithSettings(id);
    });
}

base::Result<void> Run::backupTable(device::Servo& servo)
{
    const auto ready = context();
    return ready ? backupTable(*ready, servo) : base::Result<void>(tl::unexpected(ready.error()));
}

base::Result<void> Run::backupTable(const device::Context& context, device::Servo& servo)
{
    const bool done = std::any_of(m_saved.begin(), m_saved.end(),
                                  [&](const auto& saved) { return saved.first == servo.id; });
    if (done)
        return {};
    if (const auto writable = device::beginWriting(context, servo, QStringLiteral("write"));
        !writable)
        return writable;
    const auto saved = session::saveSafetySnapshot(context, servo);
    if (!saved) {
        m_console.printMessage(
            translate("cli",
                      "The settings of servo %1 could not be saved, so nothing was written to it.")
                .arg(servo.id));
        return tl::unexpected(saved.error());
    }
    m_saved.emplace_back(servo.id, *saved);
    m_console.printNote(translate("cli", "Present settings saved to %1").arg(*saved));
    return {};
}

base::Result<void> Run::backupTableAndReport(device::Servo& servo)
{
    const std::size_t before = m_saved.size();
    const auto saved = backupTable(servo);
    if (m_console.isJson() && m_saved.size() > before)
        m_console.printMessage(
            translate("cli", "Present settings saved to %1").arg(m_saved.back().second));
    return saved;
}

void Run::removeUnusedSnapshots()
{
    if (m_saved.empty() || session().journal().intentCount() > 0)
        return;
    for (const auto& [id, file] : m_saved) {
        session::removeSafetySnapshot(file);
        m_console.printNote(
            translate("cli", "No settings were changed, so %1 was deleted.").arg(file));
    }
    m_saved.clear();
}

/// "snapshot" for one servo, "snapshots" for several.
void Run::addSaved(Json& document) const
{
    if (m_saved.size() == 1)
        document.add("snapshot", m_saved.front().second);
    if (m_saved.size() < 2)
        return;
    Json::Array all;
    for (const auto& [id, file] : m_saved)
        all.push_back(Json::object().add("id", id).add("file", file));
    document.add("snapshots", std::move(all));
}

bool Run::hasUnrecordedChange() const
{
    return m_notRecorded;
}

/// The steps of one task may report the same.
void Run::removeRepeatedNotices()
{
    device::Notices once;
    for (const device::Notice& notice : m_notices) {
        if (std::find(once.begin(), once.end(), notice) == once.end())
            once.push_back(notice);
        m_notRecorded |= notice.code == device::NoticeCode::NotRecorded;
    }
    m_notices = std::move(once);
}

QString Run::takeNotices()
{
    removeRepeatedNotices();
    QString lines;
    for (const device::Notice& notice : m_notices) {
        const QString sentence = text::describe(notice);
        lines += notice.id < 0
                     ? sentence
                     : translate("cli", "Servo %1: %2", "notice").arg(notice.id).arg(sentence);
        lines += QLatin1Char('\n');
    }
    m_notices.clear();
    return lines;
}

Json Run::takeNoticesAsJson()
{
    removeRepeatedNotices();
    Json::Array notes = std::move(m_warnings);
    m_warnings.clear();
    for (const device::Notice& notice : m_notices) {
        Json note = Json::object();
        note.add("code", text::noticeName(notice.code));
        if (notice.id >= 0)
            note.add("id", notice.id);
        if (!notice.key.isEmpty())
            note.add("key", notice.key);
        note.add("a", notice.a).add("b", notice.b).add("text", text::describe(notice));
        notes.push_back(std::move(note));
    }
    m_notices.clear();
    return notes;
}

void Run::finish(Json document, const QString& text)
{
    if (!m_console.isJson()) {
        m_console.print(text + takeNotices());
        return;
    }
    addSaved(document);
    if (!m_notices.empty() || !m_warnings.empty())
        document.add("notes", takeNoticesAsJson());
    m_console.write(document.text());
}

void Run::fail(const base::Error& error)
{
    removeUnusedSnapshots();
    if (m_console.isJson()) {
        finish(Json::object().add("error", jsonError(error)), {});
        return;
    }
    m_console.print(takeNotices());
    m_console.printMessage(errorText(error));
}
} // namespace cli
