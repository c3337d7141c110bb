// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/interruption_campaign.h"

#include "integration/raw_client.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"

#include <QDir>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QTemporaryDir>

#include <algorithm>
#include <map>
#include <optional>
#include <random>

namespace support {
namespace {
constexpr int lockAddress = 55;
constexpr int maxTries = 40;
constexpr int maxTimingTries = 5;
constexpr int startMs = 10'000; ///< the longest any of them looks before it writes
constexpr int idleMs = 2000;  ///< a command that has written nothing for so long waits for the user
constexpr int minRounds = 10; ///< of one command, to expect that a break meets an open change

struct Command {
    const char* name;
    const char* servos;
    QString words;
    const char* first = nullptr; ///< a command before it, not broken
    bool rate = false;           ///< changes the rate, which a TCP bridge cannot follow
};

/// A command that nothing happens to.
struct CommandTiming {
    int writes = 0;
    int ms = 0; ///< from its first write
};

/// Where a command is broken: so long after that many frames that change something.
struct InterruptionPoint {
    int writes = 1;
    int afterMs = 0;
};

/// Rows of an STS servo that the claims are held against.
struct RegisterSpan {
    int address;
    int size;
};
const std::map<QString, RegisterSpan>& registerSpans()
{
    static const std::map<QString, RegisterSpan> known{
        {QStringLiteral("id"), {5, 1}},
        {QStringLiteral("baud_rate"), {6, 1}},
        {QStringLiteral("max_temperature"), {13, 1}},
        {QStringLiteral("min_voltage"), {15, 1}},
        {QStringLiteral("position_p"), {21, 1}},
        {QStringLiteral("position_d"), {22, 1}},
        {QStringLiteral("protection_current"), {28, 2}},
        {QStringLiteral("operating_mode"), {33, 1}},
        {QStringLiteral("overload_torque"), {36, 1}},
    };
    return known;
}

QByteArray frame(int id, int instruction, const QByteArray& params)
{
    QByteArray bytes = QByteArray::fromHex("FFFF");
    for (const int byte : {id, int(params.size()) + 2, instruction})
        bytes.append(char(byte));
    bytes.append(params);
    unsigned sum = 0;
    for (qsizetype i = 2; i < bytes.size(); ++i)
        sum += static_cast<unsigned char>(bytes[i]);
    return bytes.append(char(~sum));
}

/// Reads servos through a line that may be noisy. Knows bytes only.
class RawServoReader {
public:
    explicit RawServoReader(const QString& port)
        : m_client(port)
    {}

    void setBaudRate(int baud) { m_client.setRate(baud == 500'000 ? B500000 : B1000000); }

    /// -1: no valid reply.
    int read(int id, RegisterSpan place, int tries = maxTries)
    {
        const QByteArray request =
            frame(id, 2, QByteArray(1, char(place.address)).append(char(place.size)));
        for (int i = 0; i < tries; ++i) {
            m_client.send(request);
            const QByteArray received = m_client.receive(6 + place.size + 4, 30);
            for (qsizetype at = 0; at + 6 + place.size <= received.size(); ++at) {
                const QByteArray reply = received.mid(at, 6 + place.size);
                if (reply != frame(id, reply[4], reply.mid(5, place.size)) || reply == request)
                    continue;
                const int low = static_cast<unsigned char>(reply[5]);
                const int high = place.size == 2 ? static_cast<unsigned char>(reply[6]) : 0;
                return low | high << 8;
            }
        }
        return -1;
    }

private:
    raw::Client m_client;
};

struct ServoAddress {
    int id;
    int baud;
};

/// One campaign's files, made once: a snapshot and a template with other values than the servos'.
class CampaignFiles {
public:
    CampaignFiles()
    {
        const raw::Simulator sim(words("--servos sts3215@1"));
        CliProgram cli;
        cli.setPort(sim.port());
        const auto requireOk = [&](const QString& line) {
            ProgramResult result;
            for (int i = 0; i < maxTries && result.exit != 0; ++i)
                result = cli.run(line.split(u' '));
            if (result.exit != 0)
                qFatal("%s: %s%s", qPrintable(line), qPrintable(result.out),
                       qPrintable(result.err));
        };
        requireOk(
            QStringLiteral("write 1 max_temperature=64 min_voltage=45 position_p=40 position_d=33 "
                           "protection_current=444 overload_torque=70 --dangerous"));
        requireOk(QStringLiteral("snapshot save 1 %1").arg(snapshot()));
        requireOk(QStringLiteral("bundle save %1 1").arg(bundle()));
        requireOk(QStringLiteral("template make 1 %1 max_temperature position_p position_d "
                                 "protection_current")
                      .arg(model()));
    }
    QString snapshot() const { return m_folder.filePath(QStringLiteral("wanted.servo.json")); }
    QString model() const { return m_folder.filePath(QStringLiteral("template.servo.json")); }
    QString bundle() const { return m_folder.filePath(QStringLiteral("wanted.bundle.json")); }
    QString state() const { return m_folder.filePath(QStringLiteral("eproms")); }
    QString batch() const { return m_folder.filePath(QStringLiteral("batch.csv")); }
    void forget() const
    {
        QFile::remove(state());
        // The table and what it is made from.
        const QDir folder(m_folder.path());
        for (const QString& name : folder.entryList({QStringLiteral("batch.*")}, QDir::Files))
            QFile::remove(folder.filePath(name));
    }

private:
    QTemporaryDir m_folder;
};

std::vector<Command> commands(const CampaignFiles& files)
{
    const auto text = [](const char* words) { return QString::fromLatin1(words); };
    return {
        {"write", "sts3215@1",
         text("write 1 max_temperature=61 position_p=50 protection_current=300 min_voltage=50")},
        {"set-id", "sts3215@1", text("set-id 1 9")},
        {"set-baud", "sts3215@1", text("set-baud 1 500000"), nullptr, true},
        {"snapshot restore", "sts3215@1",
         text("snapshot restore 1 ") + files.snapshot() + text(" --dangerous")},
        {"template apply", "sts3215@1,sts3215@2",
         text("template apply ") + files.model() + text(" 1 2")},
        {"center", "sts3215@1", text("center 1"), "write 1 position_p=30"},
        {"restore-defaults", "sts3215@1", text("restore-defaults 1"), "write 1 position_p=30"},
        {"commission", nullptr,
         text("commission --auto --first-id 9 --count 1 --template ") + files.model() +
             text(" --batch ") + files.batch()},
        {"bundle restore", "sts3215@1",
         text("bundle restore ") + files.bundle() + text(" --dangerous")},
        {"mode", "sts3215@1", text("mode 1 speed")},
        {"reboot", "sts3215@1", text("reboot 1")},
        {"identify", "sts3215@1", text("identify 1")},
        {"sweep", "sts3215@1",
         text("sweep 1 --from 1900 --to 2200 --cycles 1 --delay 400 --switch-mode"),
         "mode 1 speed"},
        {"step-response", "sts3215@1",
         text("step-response 1 --size 150 --repeats 1 --try position_p=40,position_d=20")},
    };
}

/// One round: its simulator, its program, its history.
class CampaignRound {
public:
    CampaignRound(const Command& command, const CampaignFiles& files, bool noisy,
                  std::uint32_t seed)
        : m_command(command)
        , m_arguments(simulator(command, files, noisy, seed))
        , m_sim(std::make_unique<raw::Simulator>(m_arguments))
    {
        if (command.servos == nullptr) {
            m_sim->sendLine("next");
            (void)m_sim->nextLine();
        }
        m_cli.setPort(m_sim->port());
        // Some of them are lost in the noise: a round begins when it has worked.
        for (int i = 0; command.first != nullptr && i < maxTries; ++i) {
            if (m_cli.run(command.first).exit == 0)
                break;
        }
    }

    static QStringList simulator(const Command& command, const CampaignFiles& files, bool noisy,
                                 std::uint32_t seed)
    {
        QStringList list = command.servos == nullptr ? words("--preset line")
                                                     : words("--servos") + words(command.servos);
        list << QStringLiteral("--state") << files.state() << QStringLiteral("--seed")
             << QString::number(seed);
        if (noisy)
            list << words("--fault drop=0.02,corrupt=0.02,garbage=0.02,truncate=0.01,"
                          "drop-request=0.02");
        return list;
    }

    CliProgram& cli() { return m_cli; }
    QString port() const { return m_sim->port(); }
    QStringList line() const { return m_command.words.split(u' ') << QStringLiteral("--json"); }

    /// Runs `recover` until nothing is open; false if that never comes.
    bool recover(bool undo, CampaignTotals& tally)
    {
        m_cli.setPort(m_sim->port());
        const QString how = undo ? QStringLiteral("--undo") : QStringLiteral("--finish");
        for (int i = 0; i < maxTries; ++i) {
            const ProgramResult look = m_cli.json("recover --any-port");
            const QJsonArray open = look.json()[QLatin1String("intents")].toArray();
            if (look.exit == 0 && open.isEmpty() && look.json().contains(QLatin1String("intents")))
                return true;
            tally.openChanges += i == 0 ? 1 : 0;
            const ProgramResult done =
                m_cli.run({QStringLiteral("recover"), QStringLiteral("--any-port"), how,
                           QStringLiteral("--json")});
            m_claims = done.json()[QLatin1String("intents")].toArray();
            // The terminal of the cable may be another program's by now; it is the same servo.
            for (const QJsonValue& left : look.json()[QLatin1String("elsewhere")].toArray()) {
                const ProgramResult named =
                    m_cli.run({QStringLiteral("recover"), QStringLiteral("--any-port"),
                               QStringLiteral("--change"), left[QLatin1String("uuid")].toString(),
                               how, QStringLiteral("--json")});
                for (const QJsonValue& one : named.json()[QLatin1String("intents")].toArray())
                    m_claims.append(one);
            }
        }
        return false;
    }

    /// Where each servo is now. A busy machine may answer late, so those that are missing are
    /// looked for again.
    std::vector<ServoAddress> servos()
    {
        constexpr int scanPasses = 5;
        std::vector<ServoAddress> found;
        for (int i = 0; i < scanPasses && found.size() < expected(); ++i)
            found = look(4 << i);
        return found;
    }
    std::size_t expected() const
    {
        return m_command.servos == nullptr
                   ? 1
                   : std::size_t(QString::fromLatin1(m_command.servos).count(u'@'));
    }

    int read(const ServoAddress& servo, RegisterSpan place)
    {
        RawServoReader witness(m_sim->port());
        witness.setBaudRate(servo.baud);
        return witness.read(servo.id, place);
    }

    /// Compares the report of `recover` with the values now and after a power cycle.
    int falseClaims(bool powerCycled)
    {
        int wrong = 0;
        for (const QJsonValue& claim : std::as_const(m_claims)) {
            const QString kind = claim[QLatin1String("kind")].toString();
            const bool restored = kind == QLatin1String("snapshot-restore");
            if (!claim[QLatin1String("done")].toBool() ||
                (kind != QLatin1String("write") && kind != QLatin1String("mode") && !restored))
                continue;
            const bool undone = claim[QLatin1String("action")] == QLatin1String("undo");
            const ServoAddress servo{claim[QLatin1String("found_id")].toInt(),
                                     claim[QLatin1String("found_baud")].toInt()};
            for (const QJsonValue& item : claim[QLatin1String("items")].toArray()) {
                const auto place = registerSpans().find(item[QLatin1String("key")].toString());
                const int claimed = item[QLatin1String(undone ? "old" : "new")].toInt(-1);
                if (place != registerSpans().end() && read(servo, place->second) != claimed)
                    ++wrong;
            }
        }
        m_claims = powerCycled ? QJsonArray() : m_claims;
        return wrong;
    }

    void powerCycle()
    {
        m_sim->end();
        m_sim = std::make_unique<raw::Simulator>(m_arguments);
    }

private:
    std::vector<ServoAddress> look(int tries)
    {
        std::vector<ServoAddress> found;
        RawServoReader witness(m_sim->port());
        for (const int baud : {1'000'000, 500'000}) {
            witness.setBaudRate(baud);
            for (const int id : {1, 2, 9}) {
                if (witness.read(id, {5, 1}, tries) == id)
                    found.push_back({id, baud});
            }
        }
        return found;
    }

    const Command& m_command;
    QStringList m_arguments;
    std::unique_ptr<raw::Simulator> m_sim;
    CliProgram m_cli;
    QJsonArray m_claims;
};

/// Exit code 0 of a program that was cut off is a claim like any other: all is written and locked.
int isFalseSuccess(CampaignRound& round, const ProgramResult& result)
{
    const QJsonObject json = result.json();
    const QJsonArray writes = json[QLatin1String("writes")].toArray();
    int wrong = 0;
    const auto servos = round.servos();
    for (const QJsonValue& write : writes) {
        const auto place = registerSpans().find(write[QLatin1String("key")].toString());
        const QString outcome = write[QLatin1String("outcome")].toString();
        if (place == registerSpans().end() || outcome != QLatin1String("kept") || servos.empty())
            continue;
        const int now = round.read(servos.front(), place->second);
        wrong += now != write[QLatin1String("read_back")].toInt(-1) ? 1 : 0;
    }
    if (json[QLatin1String("lock")] == QLatin1String("closed")) {
        for (const ServoAddress& servo : servos)
            wrong += round.read(servo, {lockAddress, 1}) != 1 ? 1 : 0;
    }
    return wrong;
}

void judge(CampaignRound& round, const Command& command, bool undo, CampaignTotals& tally)
{
    if (!round.recover(undo, tally))
        ++tally.unrecovered;
    const auto servos = round.servos();
    tally.lost += servos.size() < round.expected() ? 1 : 0;
    for (const ServoAddress& servo : servos)
        tally.unlocked += round.read(servo, {lockAddress, 1}) != 1 ? 1 : 0;
    tally.falseClaimCount += round.falseClaims(false);
    if (command.servos == nullptr)
        return; // the bag is packed anew
    round.powerCycle();
    tally.falseClaimCount += round.falseClaims(true);
}

/// Waits for frames that change something; false: the program has ended, or wrote nothing more
/// until patience ended.
bool awaitWrites(const CutCable& cable, QProcess& process, int count)
{
    QElapsedTimer idle;
    idle.start();
    for (int seen = cable.writes(); seen < count;) {
        if (process.state() == QProcess::NotRunning || process.waitForFinished(1) ||
            idle.hasExpired(seen == 0 ? startMs : idleMs))
            return false;
        if (const int now = cable.writes(); now > seen) {
            seen = now;
            idle.start();
        }
    }
    return true;
}

CommandTiming measureCommand(const Command& command, const CampaignFiles& files, std::uint32_t seed)
{
    files.forget();
    CampaignRound round(command, files, false, seed);
    const CutCable cable(round.port(), false);
    round.cli().setPort(cable.port());
    round.cli().start(round.line());
    QProcess& process = round.cli().process();
    if (!awaitWrites(cable, process, 1))
        return {};
    QElapsedTimer timer;
    timer.start();
    constexpr int everything = 1'000'000;
    (void)awaitWrites(cable, process, everything);
    const qint64 waited = process.state() == QProcess::NotRunning ? 0 : idleMs;
    const CommandTiming timing{cable.writes(), int(timer.elapsed() - waited)};
    round.cli().signal(SIGKILL);
    (void)round.cli().finish();
    return timing;
}

ProgramResult interruptRun(CutCable& cable, Interruption how, CampaignRound& round,
                           const InterruptionPoint& point, CampaignTotals& tally)
{
    round.cli().setPort(cable.port());
    round.cli().start(round.line());
    QProcess& process = round.cli().process();
    const bool broken =
        awaitWrites(cable, process, point.writes) && !process.waitForFinished(point.afterMs);
    tally.broken += broken ? 1 : 0;
    if (how == Interruption::LinkCut)
        cable.cut();
    else
        round.cli().signal(SIGKILL);
    const ProgramResult result = round.cli().finish();
    if (process.state() != QProcess::NotRunning) {
        ++tally.hung;
        process.kill();
        process.waitForFinished();
    }
    return result;
}

void interruptOnce(Interruption how, CampaignRound& round, const InterruptionPoint& point, bool tcp,
                   CampaignTotals& tally)
{
    std::optional<CutCable> cable(std::in_place, round.port(), tcp);
    const ProgramResult result = interruptRun(*cable, how, round, point, tally);
    cable.reset(); // it would take the replies to the raw frames
    if (how == Interruption::LinkCut)
        tally.falseClaimCount += isFalseSuccess(round, result);
}

CampaignTotals interruptCommand(Interruption how, const Command& command,
                                const CampaignFiles& files, int rounds, std::mt19937& random)
{
    const bool noisy = how == Interruption::KillDuringNoise;
    CommandTiming timing; // on a busy machine the servo may not answer in time
    for (int i = 0; i < maxTimingTries && timing.writes == 0; ++i)
        timing = measureCommand(command, files, std::uint32_t(random()));
    CampaignTotals tally;
    if (timing.writes == 0) {
        ++tally.missed;
        tally.firstFailure = QStringLiteral("%1 wrote nothing").arg(QLatin1String(command.name));
        return tally;
    }
    const int pauseMs = std::min(timing.ms / timing.writes, idleMs / 2);
    for (int i = 0; tally.broken < rounds && i < 2 * rounds; ++i) {
        files.forget();
        const auto seed = std::uint32_t(random());
        const InterruptionPoint point{std::uniform_int_distribution<>(1, timing.writes)(random),
                                      std::uniform_int_distribution<>(0, pauseMs)(random)};
        CampaignRound round(command, files, noisy, seed);
        ++tally.rounds;
        interruptOnce(how, round, point,
                      how == Interruption::LinkCut && !command.rate && i % 2 == 0, tally);
        judge(round, command, random() % 2 == 0, tally);
        if (!tally.clean() && tally.firstFailure.isEmpty())
            tally.firstFailure = QStringLiteral("%1, seed %2, %3 ms after write %4")
                                     .arg(QLatin1String(command.name))
                                     .arg(seed)
                                     .arg(point.afterMs)
                                     .arg(point.writes);
    }
    if (rounds >= minRounds && tally.openChanges == 0) {
        ++tally.missed;
        tally.firstFailure =
            QStringLiteral("%1: no break met an open change").arg(QLatin1String(command.name));
    }
    return tally;
}
} // namespace

CampaignTotals& CampaignTotals::operator+=(const CampaignTotals& other)
{
    rounds += other.rounds;
    broken += other.broken;
    openChanges += other.openChanges;
    unlocked += other.unlocked;
    lost += other.lost;
    falseClaimCount += other.falseClaimCount;
    unrecovered += other.unrecovered;
    hung += other.hung;
    missed += other.missed;
    if (firstFailure.isEmpty())
        firstFailure = other.firstFailure;
    return *this;
}

CampaignTotals runCampaign(Interruption how, int rounds, std::uint32_t seed, const QString& only,
                           const std::function<void(const QString& text)>& line)
{
    const CampaignFiles files;
    auto all = commands(files);
    if (!only.isEmpty())
        std::erase_if(all, [&](const Command& one) { return only != QLatin1String(one.name); });
    std::mt19937 random(seed);
    CampaignTotals sum;
    for (int i = 0; i < int(all.size()); ++i) {
        const Command& command = all[std::size_t(i)];
        const int share = rounds / int(all.size()) + (i < rounds % int(all.size()) ? 1 : 0);
        if (share == 0)
            continue;
        const CampaignTotals tally = interruptCommand(how, command, files, share, random);
        line(QStringLiteral("%1 rounds %2, broken off %3, changes open %4; unlocked %5, lost %6, "
                            "false words %7, unrecovered %8, hung %9")
                 .arg(QLatin1String(command.name), -18)
                 .arg(tally.rounds, 3)
                 .arg(tally.broken, 3)
                 .arg(tally.openChanges, 3)
                 .arg(tally.unlocked)
                 .arg(tally.lost)
                 .arg(tally.falseClaimCount)
                 .arg(tally.unrecovered)
                 .arg(tally.hung));
        sum += tally;
    }
    return sum;
}
} // namespace support
