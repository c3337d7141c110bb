// SPDX-License-Identifier: GPL-3.0-or-later
// The history with a million writes: opening it and reading the first page, by servo, time span,
// register and trouble, and pages far down; counting; what one write costs the journal, beside a
// bare append that is synced as often. Wanted: opening and filtering in 200 ms.
//     bench_history [writes [folder]]
#include "history/history.h"
#include "history/history_file.h"
#include "history/history_journal.h"

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace {
using history::HistoryFilter;

constexpr double wanted = 200; ///< ms
constexpr int servoCount = 40;
constexpr int perIntent = 3;
const QStringList keys{QStringLiteral("position_p"), QStringLiteral("position_d"),
                       QStringLiteral("min_angle"),  QStringLiteral("max_angle"),
                       QStringLiteral("id"),         QStringLiteral("position_offset")};
const QDateTime start = QDateTime::fromString(QStringLiteral("2025-01-01T00:00:00Z"), Qt::ISODate);
constexpr qint64 between = 30'000; ///< ms from one intent to the next

/// Rare: one intent in a thousand, of one servo in the middle of the list.
bool isRareServo(qint64 intent)
{
    return intent % 1000 == 500;
}

bool insertOne(const history::HistoryFile& file, qint64 intent)
{
    const int servo = isRareServo(intent) ? servoCount : 1 + int(intent % (servoCount - 1));
    const qint64 at = start.toMSecsSinceEpoch() + intent * between;
    const bool failed = intent % 500 == 7;
    const auto added = file.run(
        QStringLiteral("INSERT INTO intents (uuid, servo, at, kind, temporary, lock_opened, port, "
                       "baud, program, outcome, ended) VALUES (?, ?, ?, 'write', 0, 1, "
                       "'/dev/ttyUSB0', 1000000, 'bench', ?, ?)"),
        {QStringLiteral("%1").arg(intent, 36), servo, at,
         failed ? QStringLiteral("failed") : QStringLiteral("done"), at + 20});
    if (!added)
        return false;
    for (int place = 0; place < perIntent; ++place) {
        const QString key = isRareServo(intent) ? QStringLiteral("rare_register")
                                                : keys[(intent + place) % keys.size()];
        const auto one = file.run(
            QStringLiteral("INSERT INTO writes (intent, place, servo, at, \"key\", address, old, "
                           "new, read_back, outcome, trouble) "
                           "VALUES (?, ?, ?, ?, ?, 21, ?, ?, ?, ?, ?)"),
            {qint64(added->insertedId), place, servo, at, key, intent % 100, intent % 90,
             intent % 90, failed ? QStringLiteral("mismatch") : QStringLiteral("kept"),
             failed ? 1 : 0});
        if (!one)
            return false;
    }
    return true;
}

bool fill(const QString& path, qint64 writes)
{
    const auto history = history::History::open(path);
    if (!history)
        return false;
    for (int id = 1; id <= servoCount; ++id) {
        base::ServoIdentity identity{id, 9, 3, 3, 10, QStringLiteral("sts-sms"), {}, 1000000};
        identity.model = id % 2 == 0 ? QStringLiteral("STS3215") : QStringLiteral("STS3250");
        if (!(*history)->log().findOrAdd(identity))
            return false;
    }
    const auto& file = (*history)->file();
    constexpr qint64 batchSize = 20'000;
    for (qint64 from = 0; from < writes / perIntent; from += batchSize) {
        const auto done = file.transaction([&]() -> base::Result<void> {
            for (qint64 i = from; i < std::min(from + batchSize, writes / perIntent); ++i) {
                if (!insertOne(file, i))
                    return base::fail(base::ErrorCode::FileUnwritable, QStringLiteral("bench"));
            }
            return {};
        });
        if (!done)
            return false;
    }
    return true;
}

/// Milliseconds to open the history anew and ask it; the worst of some.
template <typename Question>
void ask(const char* name, const Question& question)
{
    constexpr int times = 5;
    double worst = 0;
    std::int64_t rows = 0;
    for (int i = 0; i < times; ++i) {
        QElapsedTimer timer;
        timer.start();
        rows = question();
        worst = std::max(worst, double(timer.nsecsElapsed()) / 1e6);
    }
    std::printf("%-44s %8lld rows %8.1f ms  %s\n", name, static_cast<long long>(rows), worst,
                worst <= wanted ? "ok" : "TOO SLOW");
}

void queryPages(const QString& path, qint64 writes)
{
    const auto page = [&](const HistoryFilter& filter) -> std::int64_t {
        const auto history = history::History::open(path);
        return std::int64_t((*history)->log().writes(filter)->size());
    };
    const auto count = [&](const HistoryFilter& filter) {
        const auto history = history::History::open(path);
        return (*history)->log().countWrites(filter).value();
    };
    const qint64 span = writes / perIntent * between;
    const auto when = [&](double part) { return start.addMSecs(qint64(double(span) * part)); };
    HistoryFilter all;
    HistoryFilter servo;
    servo.servo = 7;
    HistoryFilter rareServo;
    rareServo.servo = servoCount;
    HistoryFilter model;
    model.model = QStringLiteral("sts3250");
    HistoryFilter key;
    key.key = QStringLiteral("min_angle");
    HistoryFilter rareKey;
    rareKey.key = QStringLiteral("rare_register");
    HistoryFilter noKey;
    noKey.key = QStringLiteral("nothing");
    HistoryFilter span10 = servo;
    span10.from = when(0.4);
    span10.until = when(0.5);
    span10.key = QStringLiteral("position_p");
    HistoryFilter old;
    old.until = when(0.001);
    HistoryFilter deep;
    deep.after = history::PageCursor{when(0.5), writes / 2};
    HistoryFilter trouble = model;
    trouble.onlyProblems = true;
    ask("open, first page", [&] { return page(all); });
    ask("open, one servo", [&] { return page(servo); });
    ask("open, one servo that is rare", [&] { return page(rareServo); });
    ask("open, a model (20 servos)", [&] { return page(model); });
    ask("open, a register", [&] { return page(key); });
    ask("open, a rare register", [&] { return page(rareKey); });
    ask("open, a register never written", [&] { return page(noKey); });
    ask("open, servo + register + time span", [&] { return page(span10); });
    ask("open, the oldest days", [&] { return page(old); });
    ask("open, a page in the middle", [&] { return page(deep); });
    ask("open, what went wrong with a model", [&] { return page(trouble); });
    ask("open, count all", [&] { return count(all); });
    ask("open, count one servo", [&] { return count(servo); });
    ask("open, count a register", [&] { return count(key); });
    ask("open, the servos", [&] {
        const auto history = history::History::open(path);
        return std::int64_t((*history)->log().servos()->size());
    });
    ask("open, the keys of all", [&] {
        const auto history = history::History::open(path);
        return std::int64_t((*history)->log().writtenKeys()->size());
    });
    const history::HistoryJournal journal(path, QStringLiteral("bench"));
    ask("journal: what is open", [&] { return std::int64_t(journal.open()->size()); });
    ask("journal: 1000 entries of a servo", [&] {
        const base::ServoIdentity identity{7, 9, 3, 3, 10, QStringLiteral("sts-sms"), {}, 1000000};
        return std::int64_t(journal.entriesFor(identity, 1000)->size());
    });
}

double secondsPerSync(const QString& path)
{
    constexpr int times = 100;
    const int file =
        ::open(QFile::encodeName(path).constData(), O_CREAT | O_WRONLY | O_APPEND, 0600);
    const QByteArray line(400, 'x');
    QElapsedTimer timer;
    timer.start();
    for (int i = 0; i < times; ++i) {
        if (::write(file, line.constData(), std::size_t(line.size())) < 0 || ::fsync(file) != 0)
            break;
    }
    const double each = double(timer.nsecsElapsed()) / 1e6 / times;
    ::close(file);
    return each;
}

/// What a write waits for: before its first byte and after its last.
void writeCost(const QString& path, const QString& baseline)
{
    constexpr int times = 200;
    base::Intent intent;
    intent.servo = {7, 9, 3, 3, 10, QStringLiteral("sts-sms"), {}, 1000000};
    intent.items = {{QStringLiteral("position_p"), 21, 32, 40}};
    QElapsedTimer timer;
    {
        history::HistoryJournal journal(path, QStringLiteral("bench"));
        (void)journal.end(journal.begin(intent).value(), {QStringLiteral("done"), {}});
        timer.start();
        for (int i = 0; i < times; ++i)
            (void)journal.end(journal.begin(intent).value(),
                              {QStringLiteral("done"),
                               {},
                               {{QStringLiteral("position_p"), 40, QStringLiteral("kept")}}});
    }
    const double each = double(timer.nsecsElapsed()) / 1e6 / times / 2;
    timer.start();
    constexpr int anew = 20;
    for (int i = 0; i < anew; ++i) {
        history::HistoryJournal journal(path, QStringLiteral("bench"));
        (void)journal.begin(intent).value();
    }
    const double opening = double(timer.nsecsElapsed()) / 1e6 / anew;
    std::printf("journal: begin or end %.2f ms, with a connection of its own %.2f ms; "
                "a bare line with fsync %.2f ms\n",
                each, opening, secondsPerSync(baseline));
}
} // namespace

int main(int argc, char* argv[])
{
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    const qint64 writes = arguments.size() > 1 ? arguments[1].toLongLong() : 1'000'000;
    const QTemporaryDir temporary;
    const QString folder = arguments.size() > 2 ? arguments[2] : temporary.path();
    const QString path = folder + QStringLiteral("/history.sqlite");
    QElapsedTimer timer;
    timer.start();
    if (!QFile::exists(path) && !fill(path, writes)) {
        std::printf("the history cannot be written to %s\n", qPrintable(path));
        return 1;
    }
    std::printf("%lld writes: %.0f MB, filled in %.1f s; wanted: each line <= %.0f ms\n",
                static_cast<long long>(writes), double(QFile(path).size()) / 1e6,
                double(timer.elapsed()) / 1000, wanted);
    queryPages(path, writes);
    writeCost(path, folder + QStringLiteral("/bare"));
    return 0;
}
