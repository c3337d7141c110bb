// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/campaign.h"

#include "integration/raw_client.h"
#include "support/cli_program.h"
#include "support/cut_cable.h"

#include <QElapsedTimer>
#include <QJsonArray>
#include <QTemporaryDir>

#include <map>
#include <random>

namespace support {
namespace {
constexpr int lockAddress = 55;
constexpr int maxTries = 40;

struct Command {
    const char* name;
    const char* servos;
    QString words;
    const char* first = nullptr; ///< a command before it, not broken
    bool rate = false;           ///< changes the rate, which a TCP bridge cannot follow
    int lastsMs = 0;             ///< 0: measured; it would wait for the next servo
};

/// Rows of an STS servo that the claims are held against.
struct Place {
    int address;
    int size;
};
const std::map<QString, Place>& places()
{
    static const std::map<QString, Place> known{
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
class Witness {
public:
    explicit Witness(const QString& port)
        : m_client(port)
    {}

    void listenAt(int baud) { m_client.setRate(baud == 500'000 ? B500000 : B1000000); }

    /// -1: no valid reply.
    int read(int id, Place place, int tries = maxTries)
    {
        const QByteArray request =
            frame(id, 2, QByteArray(1, char(place.address)).append(char(place.size)));
        for (int i = 0; i < tries; ++i) {
            m_client.say(request);
            const QByteArray heard = m_client.hear(6 + place.size + 4, 30);
            for (qsizetype at = 0; at + 6 + place.size <= heard.size(); ++at) {
                const QByteArray reply = heard.mid(at, 6 + place.size);
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

struct Found {
    int id;
    int baud;
};

/// One campaign's files, made once: a snapshot and a template with other values than the servos'.
class Files {
public:
    Files()
    {
        const raw::Simulator sim(words("--servos sts3215@1"));
        CliProgram cli;
        cli.setPort(sim.port());
        const auto must = [&](const QString& line) {
            Ran ran;
            for (int i = 0; i < maxTries && ran.exit != 0; ++i)
                ran = cli.run(line.split(u' '));
            if (ran.exit != 0)
                qFatal("%s: %s%s", qPrintable(line), qPrintable(ran.out), qPrintable(ran.err));
        };
        must(QStringLiteral("write 1 max_temperature=64 min_voltage=45 position_p=40 position_d=33 "
                            "protection_current=444 overload_torque=70 --dangerous"));
        must(QStringLiteral("snapshot save 1 %1").arg(snapshot()));
        must(QStringLiteral("template make 1 %1 max_temperature position_p position_d "
                            "protection_current")
                 .arg(model()));
    }
    QString snapshot() const { return m_folder.filePath(QStringLiteral("wanted.servo.json")); }
    QString model() const { return m_folder.filePath(QStringLiteral("template.servo.json")); }
    QString state() const { return m_folder.filePath(QStringLiteral("eproms")); }
    QString batch() const { return m_folder.filePath(QStringLiteral("batch.csv")); }
    void forget() const
    {
        QFile::remove(state());
        QFile::remove(batch());
    }

private:
    QTemporaryDir m_folder;
};

std::vector<Command> commands(const Files& files)
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
             text(" --batch ") + files.batch(),
         nullptr, false, 3300},
        {"sweep", "sts3215@1",
         text("sweep 1 --from 1900 --to 2200 --cycles 1 --delay 400 --switch-mode"),
         "mode 1 speed"},
        {"step-response", "sts3215@1",
         text("step-response 1 --size 150 --repeats 1 --try position_p=40,position_d=20")},
    };
}

/// One round: its simulator, its program, its history.
class Round {
public:
    Round(const Command& command, const Files& files, bool noisy, std::uint32_t seed)
        : m_command(command)
        , m_arguments(simulator(command, files, noisy, seed))
        , m_sim(std::make_unique<raw::Simulator>(m_arguments))
    {
        if (command.servos == nullptr) {
            m_sim->tell("next");
            (void)m_sim->nextLine();
        }
        m_cli.setPort(m_sim->port());
        // Some of them are lost in the noise: a round begins when it has worked.
        for (int i = 0; command.first != nullptr && i < maxTries; ++i) {
            if (m_cli.run(command.first).exit == 0)
                break;
        }
    }

    static QStringList simulator(const Command& command, const Files& files, bool noisy,
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
    bool recover(bool undo, Tally& tally)
    {
        m_cli.setPort(m_sim->port());
        const QString how = undo ? QStringLiteral("--undo") : QStringLiteral("--finish");
        for (int i = 0; i < maxTries; ++i) {
            const Ran look = m_cli.json("recover --any-port");
            const QJsonArray open = look.json()[QLatin1String("intents")].toArray();
            if (look.exit == 0 && open.isEmpty() && look.json().contains(QLatin1String("intents")))
                return true;
            tally.changesOpen += i == 0 ? 1 : 0;
            const Ran done = m_cli.run({QStringLiteral("recover"), QStringLiteral("--any-port"),
                                        how, QStringLiteral("--json")});
            m_claims = done.json()[QLatin1String("intents")].toArray();
        }
        return false;
    }

    /// Where each servo is now. A busy machine may answer late, so those that are missing are
    /// looked for again.
    std::vector<Found> servos()
    {
        constexpr int looks = 5;
        std::vector<Found> found;
        for (int i = 0; i < looks && found.size() < expected(); ++i)
            found = look(4 << i);
        return found;
    }
    std::size_t expected() const
    {
        return m_command.servos == nullptr
                   ? 1
                   : std::size_t(QString::fromLatin1(m_command.servos).count(u'@'));
    }

    int read(const Found& servo, Place place)
    {
        Witness witness(m_sim->port());
        witness.listenAt(servo.baud);
        return witness.read(servo.id, place);
    }

    /// What `recover` says it has done, against what is there now and after a power cycle.
    int falseClaims(bool powerCycled)
    {
        int wrong = 0;
        for (const QJsonValue& claim : std::as_const(m_claims)) {
            const QString kind = claim[QLatin1String("kind")].toString();
            if (!claim[QLatin1String("done")].toBool() ||
                (kind != QLatin1String("write") && kind != QLatin1String("snapshot-restore")))
                continue;
            const bool undone = claim[QLatin1String("action")] == QLatin1String("undo");
            const Found servo{claim[QLatin1String("found_id")].toInt(),
                              claim[QLatin1String("found_baud")].toInt()};
            for (const QJsonValue& item : claim[QLatin1String("items")].toArray()) {
                const auto place = places().find(item[QLatin1String("key")].toString());
                const int said = item[QLatin1String(undone ? "old" : "new")].toInt(-1);
                if (place != places().end() && read(servo, place->second) != said)
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
    std::vector<Found> look(int tries)
    {
        std::vector<Found> found;
        Witness witness(m_sim->port());
        for (const int baud : {1'000'000, 500'000}) {
            witness.listenAt(baud);
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
int falseSuccess(Round& round, const Ran& ran)
{
    const QJsonObject json = ran.json();
    const QJsonArray writes = json[QLatin1String("writes")].toArray();
    int wrong = 0;
    const auto servos = round.servos();
    for (const QJsonValue& write : writes) {
        const auto place = places().find(write[QLatin1String("key")].toString());
        const QString outcome = write[QLatin1String("outcome")].toString();
        if (place == places().end() || outcome != QLatin1String("kept") || servos.empty())
            continue;
        const int now = round.read(servos.front(), place->second);
        wrong += now != write[QLatin1String("read_back")].toInt(-1) ? 1 : 0;
    }
    if (json[QLatin1String("lock")] == QLatin1String("closed")) {
        for (const Found& servo : servos)
            wrong += round.read(servo, {lockAddress, 1}) != 1 ? 1 : 0;
    }
    return wrong;
}

void judge(Round& round, const Command& command, bool undo, Tally& tally)
{
    if (!round.recover(undo, tally))
        ++tally.unrecovered;
    const auto servos = round.servos();
    tally.lost += servos.size() < round.expected() ? 1 : 0;
    for (const Found& servo : servos)
        tally.unlocked += round.read(servo, {lockAddress, 1}) != 1 ? 1 : 0;
    tally.falseWords += round.falseClaims(false);
    if (command.servos == nullptr)
        return; // the bag is packed anew
    round.powerCycle();
    tally.falseWords += round.falseClaims(true);
}

/// How long the command takes when nothing happens to it.
int usualMs(const Command& command, const Files& files, bool noisy, std::uint32_t seed)
{
    if (command.lastsMs > 0)
        return command.lastsMs;
    files.forget();
    Round round(command, files, noisy, seed);
    QElapsedTimer timer;
    timer.start();
    (void)round.cli().run(round.line());
    return int(timer.elapsed());
}

void breakOnce(Break how, Round& round, int afterMs, Tally& tally)
{
    std::unique_ptr<CutCable> cable;
    if (how != Break::Kill) {
        cable = std::make_unique<CutCable>(round.port(), how == Break::CutTcp);
        round.cli().setPort(cable->port());
    }
    round.cli().start(round.line());
    QProcess& process = round.cli().process();
    const bool ended = process.state() == QProcess::NotRunning || process.waitForFinished(afterMs);
    tally.broken += ended ? 0 : 1;
    if (how == Break::Kill && !ended)
        round.cli().signal(SIGKILL);
    if (cable)
        cable->cut();
    const Ran ran = round.cli().finish();
    if (process.state() != QProcess::NotRunning) {
        ++tally.hung;
        process.kill();
        process.waitForFinished();
    }
    cable.reset();
    if (how != Break::Kill)
        tally.falseWords += falseSuccess(round, ran);
}
} // namespace

Tally& Tally::operator+=(const Tally& other)
{
    rounds += other.rounds;
    broken += other.broken;
    changesOpen += other.changesOpen;
    unlocked += other.unlocked;
    lost += other.lost;
    falseWords += other.falseWords;
    unrecovered += other.unrecovered;
    hung += other.hung;
    if (firstTrouble.isEmpty())
        firstTrouble = other.firstTrouble;
    return *this;
}

Tally runCampaign(Break how, int rounds, bool noisy, std::uint32_t seed,
                  void (*line)(const QString& text))
{
    const Files files;
    std::mt19937 random(seed);
    Tally all;
    for (const Command& command : commands(files)) {
        if (how == Break::CutTcp && command.rate)
            continue;
        const int usual = usualMs(command, files, noisy, seed);
        Tally tally;
        for (int i = 0; i < rounds; ++i) {
            files.forget();
            const auto roundSeed = std::uint32_t(random());
            // The first third is starting up and looking, which breaks nothing.
            const int afterMs = std::uniform_int_distribution<>(usual / 3, usual)(random);
            Round round(command, files, noisy, roundSeed);
            ++tally.rounds;
            breakOnce(how, round, afterMs, tally);
            judge(round, command, i % 2 == 0, tally);
            if (!tally.clean() && tally.firstTrouble.isEmpty())
                tally.firstTrouble = QStringLiteral("%1, seed %2, after %3 ms")
                                         .arg(QLatin1String(command.name))
                                         .arg(roundSeed)
                                         .arg(afterMs);
        }
        line(QStringLiteral("%1 rounds %2, broken %3, changes open %4; unlocked %5, lost %6, false "
                            "words %7, unrecovered %8, hung %9")
                 .arg(QLatin1String(command.name), -18)
                 .arg(tally.rounds, 3)
                 .arg(tally.broken, 3)
                 .arg(tally.changesOpen, 3)
                 .arg(tally.unlocked)
                 .arg(tally.lost)
                 .arg(tally.falseWords)
                 .arg(tally.unrecovered)
                 .arg(tally.hung));
        all += tally;
    }
    return all;
}
} // namespace support
