// SPDX-License-Identifier: GPL-3.0-or-later
// The commissioning line on simulated time: six factory servos without a click, and everything that
// goes wrong at a bench: two servos at once, foreign rates, alarms, servos pulled in the middle,
// the program killed, IDs used up, a template of another model.
#include "device/reader.h"
#include "device/writer.h"
#include "support/commission_fixture.h"
#include "support/lost_acknowledgments.h"
#include "support/test_main.h"

#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <set>

using namespace std::chrono_literals;
using jobs::CommissionAnswer;
using jobs::CommissionEnd;
using jobs::CommissionObstacle;
using jobs::CommissionStep;
using jobs::CommissionView;
using results::CommissionRow;
using results::CommissionVerdict;
using support::CommissionFixture;
using support::templateOf;

namespace {
QString q(const char* text)
{
    return QString::fromUtf8(text);
}

QStringList words(const CommissionRow& row)
{
    QStringList all;
    for (const results::CommissionIssue& issue : row.issues)
        all.append(issue.word);
    return all;
}

/// Everything there is to be written.
void unplugSpec(CommissionFixture& line)
{
    line.spec.baud = 500'000;
    line.spec.center = true;
    line.spec.settings = templateOf("sts3215", {{"position_p", 24}, {"max_temperature", 65}});
}

/// Asked whether it is the one that was begun.
CommissionAnswer groundTruth(const CommissionView& view, bool same)
{
    if (view.candidateId >= 0)
        return same ? CommissionAnswer::SameServo : CommissionAnswer::Continue;
    return view.isResumed && !same ? CommissionAnswer::Skip : CommissionAnswer::Continue;
}

bool isLockedAndOff(const sim::VirtualServo& servo)
{
    return servo.raw(q("lock")) == 1 && servo.raw(q("torque_switch")) == 0;
}
} // namespace

class TestCommission : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QTest::failOnWarning(QRegularExpression(QStringLiteral(".*"))); }

    void sixFactoryServosAutomatically()
    {
        CommissionFixture line;
        line.spec.baud = 500'000;
        const auto end = line.run();
        QVERIFY2(end, qPrintable(end ? QString() : end.error().detail));
        QCOMPARE(*end, CommissionEnd::Stopped); // the bag was empty
        QCOMPARE(line.batch.rows.size(), std::size_t{6});
        for (std::size_t i = 0; i < 6; ++i) {
            const CommissionRow& row = line.batch.rows[i];
            QVERIFY2(row.verdict == CommissionVerdict::Good, qPrintable(words(row).join(q(" "))));
            QCOMPARE(row.servo.id, 1);
            QCOMPARE(row.oldBaud, 1'000'000);
            QCOMPARE(row.newId, 11 + int(i));
            QCOMPARE(row.newBaud, 500'000);
            QCOMPARE(row.label, row.servo.model + q(" · ID %1 · 500 k").arg(11 + int(i)));
            QVERIFY(row.volts && row.celsius);
            const auto& servo = line.servoAt(i);
            QCOMPARE(servo.id(), 11 + int(i));
            QCOMPARE(servo.baud(), 500'000);
            QVERIFY(isLockedAndOff(servo));
            QVERIFY2(line.spans[i] <= 10s, qPrintable(QString::number(line.spans[i] / 1ms)));
        }
        QVERIFY(line.savedInTime);
        QCOMPARE(line.saved.size(), std::size_t{6});
        QVERIFY(line.batch.pending.empty());
        QVERIFY(!line.hasSeen(CommissionStep::Confirm));
        QCOMPARE(line.fixture.journal().open()->size(), std::size_t{0});
        QFile csv(line.csv());
        QVERIFY(csv.open(QIODevice::ReadOnly));
        const QByteArrayList lines = csv.readAll().trimmed().split('\n');
        QCOMPARE(lines.size(), 7);
        QVERIFY(lines[1].contains(",good,,STS3215,3.10,1,1000000,11,500000,"));
    }

    void labelsAreSavedWithTheId()
    {
        CommissionFixture line;
        line.spec.count = 2;
        line.spec.baud = 500'000;
        QStringList kept;
        line.name = [&](const device::Servo& servo, const QString& label, bool another) {
            kept.append(q("%1 at %2: %3").arg(servo.id).arg(servo.baud).arg(label));
            return another ? base::Result<void>() : base::fail(base::ErrorCode::BadArgument);
        };
        QVERIFY(line.run());
        QCOMPARE(kept, (QStringList{q("11 at 1000000: STS3215 · ID 11 · 500 k"),
                                    q("12 at 1000000: STS3215 · ID 12 · 500 k")}));
        QCOMPARE(line.batch.count(CommissionVerdict::Good), 2);
    }

    void anUnsavedLabelIsARemark()
    {
        CommissionFixture line;
        line.spec.count = 1;
        line.name = [](const device::Servo&, const QString&, bool) -> base::Result<void> {
            return base::fail(base::ErrorCode::DiskFull);
        };
        QVERIFY(line.run());
        QCOMPARE(line.batch.rows.front().verdict, CommissionVerdict::Remark);
        QCOMPARE(words(line.batch.rows.front()), QStringList{q("label-not-kept")});
        QCOMPARE(line.servoAt(0).id(), 11);
    }

    void oneClickPerServo()
    {
        CommissionFixture line;
        line.spec.automatic = false;
        int clicks = 0;
        line.answer = [&] {
            ++clicks;
            return CommissionAnswer::Continue;
        };
        QVERIFY(line.run());
        QCOMPARE(line.batch.count(CommissionVerdict::Good), 6);
        QCOMPARE(clicks, 6);
    }

    void nothingIsWrittenWithoutAClick()
    {
        CommissionFixture line;
        line.spec.automatic = false;
        int asked = 0;
        line.answer = [&] {
            if (++asked == 40)
                line.fixture.stop().request();
            return CommissionAnswer::None;
        };
        QVERIFY(line.run());
        QCOMPARE(asked, 40);
        QVERIFY(line.fixture.onlyReadsSent());
        QVERIFY(line.batch.rows.empty());
        QVERIFY(line.saved.empty());
    }

    void servoUnpluggedBeforeTheClickIsForgotten()
    {
        CommissionFixture line;
        line.spec.automatic = false;
        line.spec.count = 1;
        int confirms = 0;
        line.onView = [&](const CommissionView& view) {
            if (view.step == CommissionStep::Confirm && ++confirms == 1) {
                line.unplugAll();
                return true;
            }
            return false;
        };
        line.answer = [&] {
            return confirms > 1 ? CommissionAnswer::Continue : CommissionAnswer::None;
        };
        const auto end = line.run();
        QCOMPARE(*end, CommissionEnd::CountReached);
        QCOMPARE(line.batch.rows.size(), std::size_t{1});
        QCOMPARE(line.servoAt(0).id(), 1);
        QCOMPARE(line.servoAt(1).id(), 11);
    }

    void templateAndCenterAreSet()
    {
        CommissionFixture line;
        line.spec.settings = templateOf(
            "sts3215", {{"position_p", 24}, {"max_temperature", 65}, {"protection_torque", 30}});
        line.spec.templateName = q("joint.servo.json");
        line.spec.center = true;
        line.spec.count = 2;
        const auto end = line.run();
        QVERIFY2(end, qPrintable(end ? QString() : end.error().detail));
        QCOMPARE(line.batch.rows.size(), std::size_t{2});
        for (std::size_t i = 0; i < 2; ++i) {
            const CommissionRow& row = line.batch.rows[i];
            QVERIFY2(row.verdict == CommissionVerdict::Good, qPrintable(words(row).join(q(" "))));
            QVERIFY(row.centered);
            QCOMPARE(row.written, 3);
            QCOMPARE(row.templateName, q("joint.servo.json"));
            auto& servo = line.servoAt(i);
            line.plug(i);
            QCOMPARE(servo.raw(q("position_p")), 24);
            QCOMPARE(servo.raw(q("max_temperature")), 65);
            QVERIFY(std::abs(servo.raw(q("present_position")) - 2048) <= 12);
            QVERIFY(isLockedAndOff(servo));
            QVERIFY(line.spans[i] <= 10s);
        }
    }

    void twoServosAreNeverWritten_data()
    {
        QTest::addColumn<QString>("servos");
        QTest::addColumn<CommissionObstacle>("obstacle");
        const auto row = [](const char* servos, CommissionObstacle obstacle) {
            QTest::newRow(servos) << q(servos) << obstacle;
        };
        row("sts3215@1:1000000,sts3215@1:1000000", CommissionObstacle::DuplicateIds);
        row("sts3215@1:1000000,sts3215@7:1000000", CommissionObstacle::DuplicateId);
        row("sts3215@1:1000000,sts3215@1:115200", CommissionObstacle::DuplicateId);
        row("sts3215@1:1000000,lx16a@1", CommissionObstacle::DuplicateId);
        row("sts3215@1:1000000,sts3215@9:500000", CommissionObstacle::DuplicateId);
        row("lx16a@1,lx16a@2", CommissionObstacle::DuplicateId);
        row("lx16a@1,lx16a@1", CommissionObstacle::DuplicateIds);
    }
    void twoServosAreNeverWritten()
    {
        QFETCH(QString, servos);
        QFETCH(CommissionObstacle, obstacle);
        CommissionFixture line(servos);
        line.spec.baud = servos.contains(q("500000")) ? 500'000 : 0;
        line.spec.count = 1;
        line.servoAt(0).setTemperature(31); // no two read the same
        bool parted = false;
        line.onView = [&](const CommissionView& view) {
            if (view.step == CommissionStep::Waiting && !line.isAnyPlugged()) {
                line.plug(0);
                line.plug(1);
            } else if (view.step == CommissionStep::Blocked) {
                if (!line.fixture.onlyReadsSent())
                    return true;
                if (!parted) {
                    parted = true;
                    line.fixture.withBus([](sim::VirtualBus& wire) { wire.unplug(1); });
                }
                return true;
            }
            return view.step != CommissionStep::Unplug;
        };
        const auto end = line.run();
        QVERIFY2(end, qPrintable(end ? QString() : end.error().detail));
        QVERIFY(parted);
        QVERIFY(line.hasSeen(obstacle));
        QCOMPARE(*end, CommissionEnd::CountReached);
        QCOMPARE(line.servoAt(0).id(), 11);
        QVERIFY(line.servoAt(1).id() != 11);
    }

    void secondServoWhileTheFirstWaitsForItsClick()
    {
        CommissionFixture line;
        line.spec.automatic = false;
        bool second = false;
        line.answer = [&] {
            if (!second) {
                second = true;
                line.plug(1);
            }
            return CommissionAnswer::Continue;
        };
        line.onView = [&](const CommissionView& view) {
            if (view.step == CommissionStep::Blocked)
                line.fixture.stop().request();
            return false;
        };
        QVERIFY(line.run());
        QVERIFY(second);
        QVERIFY(line.hasSeen(CommissionStep::Blocked));
        QVERIFY(line.fixture.onlyReadsSent());
    }

    void otherRatesAndProtocolsAreFound_data()
    {
        QTest::addColumn<QString>("servo");
        for (const char* servo : {"sts3215@1:115200", "sts3215@1:38400", "sts3215@1:250000",
                                  "sm40blhv@1", "scs15@1:500000", "scs15@1:57600"})
            QTest::newRow(servo) << q(servo);
    }
    void otherRatesAndProtocolsAreFound()
    {
        QFETCH(QString, servo);
        CommissionFixture line(servo);
        line.spec.baud = 1'000'000;
        const int before = line.servoAt(0).baud();
        line.spec.count = 1;
        const auto end = line.run();
        QCOMPARE(*end, CommissionEnd::CountReached);
        const CommissionRow& row = line.batch.rows.front();
        QVERIFY2(row.verdict == CommissionVerdict::Good, qPrintable(words(row).join(q(" "))));
        QCOMPARE(row.oldBaud, before);
        QCOMPARE(line.servoAt(0).id(), 11);
        QCOMPARE(line.servoAt(0).baud(), 1'000'000);
        QVERIFY2(line.spans[0] <= 10s, qPrintable(QString::number(line.spans[0] / 1ms)));
    }

    void lxServosKeepTheirRate()
    {
        CommissionFixture line(q("lx16a@1,smsmb@1"));
        line.spec.count = 2;
        const auto end = line.run();
        QCOMPARE(*end, CommissionEnd::CountReached);
        for (std::size_t i = 0; i < 2; ++i) {
            QVERIFY2(line.batch.rows[i].verdict == CommissionVerdict::Good,
                     qPrintable(words(line.batch.rows[i]).join(q(" "))));
            QCOMPARE(line.servoAt(i).id(), 11 + int(i));
            QVERIFY2(line.spans[i] <= 10s, qPrintable(QString::number(line.spans[i] / 1ms)));
        }
    }

    void anUnsupportedRateRejectsTheServo()
    {
        CommissionFixture line(q("lx16a@1,sts3215@1"));
        line.spec.baud = 1'000'000;
        QVERIFY(line.run());
        QCOMPARE(line.batch.rows[0].verdict, CommissionVerdict::Skipped);
        QCOMPARE(words(line.batch.rows[0]), QStringList{q("no-such-rate")});
        QCOMPARE(line.servoAt(0).id(), 1);
        QCOMPARE(line.batch.rows[1].verdict, CommissionVerdict::Good);
        QCOMPARE(line.servoAt(1).id(), 11); // no ID was spent on the first
    }

    void problemServosAreRejectedWithoutAnId()
    {
        CommissionFixture line(q("line-trouble"));
        line.spec.baud = 500'000;
        QVERIFY(line.run());
        QCOMPARE(line.batch.rows.size(), std::size_t{6});
        const std::vector<std::pair<CommissionVerdict, QStringList>> expected{
            {CommissionVerdict::Good, {}},
            {CommissionVerdict::Skipped, {q("alarm")}},
            {CommissionVerdict::Skipped, {q("other-id")}},
            {CommissionVerdict::Good, {}},
            {CommissionVerdict::Skipped, {q("no-such-rate")}},
            {CommissionVerdict::Good, {}},
        };
        for (std::size_t i = 0; i < 6; ++i) {
            QCOMPARE(words(line.batch.rows[i]), expected[i].second);
            QCOMPARE(line.batch.rows[i].verdict, expected[i].first);
        }
        QCOMPARE(line.servoAt(1).id(), 1);
        QCOMPARE(line.servoAt(2).id(), 7);
        QCOMPARE(line.servoAt(5).id(), 13);
        QCOMPARE(line.saved.size(), std::size_t{3});
    }

    void servosWithAlarmsCanBeAccepted()
    {
        CommissionFixture line(q("line-trouble"));
        line.spec.automatic = false;
        line.answer = [] { return CommissionAnswer::Continue; };
        QVERIFY(line.run());
        QCOMPARE(line.batch.rows.size(), std::size_t{6});
        QCOMPARE(line.batch.rows[1].verdict, CommissionVerdict::Failed); // told, not hidden
        QVERIFY(words(line.batch.rows[1]).contains(q("alarm")));
        QCOMPARE(line.servoAt(1).id(), 12);
        QCOMPARE(line.batch.rows[2].verdict, CommissionVerdict::Remark);
        QCOMPARE(line.servoAt(2).id(), 13);
    }

    void modelsUnlikeTheTemplateAreRejected()
    {
        CommissionFixture line(q("scs15@1,sts3215@1"));
        line.spec.settings = templateOf("sts3215", {{"position_p", 24}});
        QVERIFY(line.run());
        QCOMPARE(line.batch.rows[0].verdict, CommissionVerdict::Skipped);
        QVERIFY(words(line.batch.rows[0]).contains(q("other-model")));
        QCOMPARE(line.batch.rows[1].verdict, CommissionVerdict::Good);
        QCOMPARE(line.servoAt(1).id(), 11);
    }

    void idsRunOut()
    {
        CommissionFixture line;
        line.spec.ids = {20, 21};
        const auto end = line.run();
        QCOMPARE(*end, CommissionEnd::IdsExhausted);
        QCOMPARE(line.batch.rows.size(), std::size_t{2});
        line.restart();
        QCOMPARE(*line.run(), CommissionEnd::IdsExhausted);
        QCOMPARE(line.batch.rows.size(), std::size_t{2});
        line.restart();
        line.spec.ids = {20, 21, 22};
        QCOMPARE(*line.run(), CommissionEnd::IdsExhausted);
        QCOMPARE(line.batch.rows.back().newId, 22);
    }

    void aServoLeftConnectedIsNotCommissionedAgain()
    {
        CommissionFixture line;
        line.onView = [&](const CommissionView& view) {
            if (view.step == CommissionStep::Unplug) {
                line.fixture.stop().request(); // the user goes home
                return true;
            }
            return false;
        };
        QVERIFY(line.run());
        QVERIFY(line.batch.attachedServo);
        line.restart();
        line.onView = nullptr;
        QVERIFY(line.run());
        QCOMPARE(line.views.front().step, CommissionStep::Unplug);
        QCOMPARE(line.views.front().newId, 11);
        QCOMPARE(line.batch.rows.size(), std::size_t{6});
    }

    void aFinishedServoIsRecognized()
    {
        CommissionFixture line;
        bool again = false;
        line.onView = [&](const CommissionView& view) {
            if (view.step == CommissionStep::Waiting && line.batch.rows.size() == 2 && !again) {
                again = true;
                line.unplugAll();
                line.plug(0); // the first one once more
                return true;
            }
            return false;
        };
        QVERIFY(line.run());
        QVERIFY(again);
        QCOMPARE(line.batch.rows.size(), std::size_t{6});
        QCOMPARE(line.servoAt(0).id(), 11);
        const bool reported =
            std::any_of(line.views.begin(), line.views.end(), [](const auto& view) {
                return view.step == CommissionStep::Unplug && view.newId == 11 &&
                       !view.issues.empty() && view.issues.front().word == q("already-done");
            });
        QVERIFY(reported);
    }

    void unpluggedMidway_data()
    {
        QTest::addColumn<int>("frame");
        QTest::addColumn<bool>("heard");
        QTest::addColumn<bool>("killed");
        int changes = 0;
        CommissionFixture line(q("sts3215@1"));
        unplugSpec(line);
        line.fixture.tap().onWrite = [&changes](const base::Bytes& bytes) {
            changes += support::isWriteFrame(bytes) ? 1 : 0;
        };
        QVERIFY(line.run());
        QVERIFY(changes > 6);
        for (int frame = 0; frame < changes; ++frame) {
            for (const bool heard : {false, true}) {
                for (const bool killed : {false, true})
                    QTest::addRow("change %d %s %s", frame, heard ? "heard" : "lost",
                                  killed ? "killed" : "goes on")
                        << frame << heard << killed;
            }
        }
    }
    /// At every frame that changes something: before the servo hears it, or after; and the program
    /// goes on, or is killed at that very moment.
    void unpluggedMidway()
    {
        QFETCH(int, frame);
        QFETCH(bool, heard);
        QFETCH(bool, killed);
        CommissionFixture line(q("sts3215@1,sts3215@1"));
        unplugSpec(line);
        int changes = 0;
        bool pulled = false;
        const auto pull = [&] {
            pulled = true;
            line.fixture.tap().onWrite = nullptr;
            line.unplugAll();
            if (killed) {
                line.fixture.cutLink();
                line.fixture.journal().setError(base::ErrorCode::DiskFull);
            }
        };
        bool next = false;
        line.fixture.tap().onWrite = [&](const base::Bytes& bytes) {
            if (next)
                return pull();
            if (support::isWriteFrame(bytes) && changes++ == frame) {
                if (heard)
                    next = true;
                else
                    pull();
            }
        };
        line.onView = [&](const CommissionView& view) {
            if (view.step != CommissionStep::Waiting || !pulled || line.isAnyPlugged() ||
                !line.batch.rows.empty())
                return false;
            line.plug(0); // the same one again
            return true;
        };
        line.answer = [&] { return groundTruth(line.views.back(), true); };
        auto end = line.run();
        if (pulled && killed) {
            QVERIFY(!end);
            line.fixture.journal().setError(std::nullopt);
            line.fixture.restoreLink();
            line.restart();
            end = line.run();
        }
        QVERIFY2(end, qPrintable(end ? QString() : base::errorName(end.error().code)));
        QVERIFY(pulled);
        std::set<int> ids;
        for (std::size_t place : {0U, 1U}) {
            const auto& servo = line.servoAt(place);
            line.plug(place);
            ids.insert(servo.id());
            QVERIFY2(servo.id() >= 11, "each has an ID of its own");
            QCOMPARE(servo.baud(), 500'000);
            QCOMPARE(servo.raw(q("position_p")), 24);
            QCOMPARE(servo.raw(q("max_temperature")), 65);
            QVERIFY(isLockedAndOff(servo));
        }
        QCOMPARE(ids.size(), std::size_t{2});
        QCOMPARE(line.batch.done(), 2);
        for (const CommissionRow& row : line.batch.rows)
            QVERIFY2(ids.count(row.newId) == 1, "the batch says what is so");
    }

    void swappedQuickly_data() { unpluggedMidway_data(); }

    /// Pulled and plugged in again before anybody could notice, the same servo or another of its
    /// kind: whatever the journal still holds open is counted as unfinished, and who is said to be
    /// good has all of it.
    void swappedQuickly()
    {
        QFETCH(int, frame);
        QFETCH(bool, heard);
        QFETCH(bool, killed); // here: another one
        CommissionFixture line(q("sts3215@1,sts3215@1"));
        unplugSpec(line);
        int changes = 0;
        const auto swap = [&] {
            line.fixture.tap().onWrite = nullptr;
            line.unplugAll();
            line.plug(killed ? 1U : 0U);
        };
        bool next = false;
        line.fixture.tap().onWrite = [&](const base::Bytes& bytes) {
            if (next)
                return swap();
            if (support::isWriteFrame(bytes) && changes++ == frame) {
                if (heard)
                    next = true;
                else
                    swap();
            }
        };
        line.answer = [&] { return groundTruth(line.views.back(), !killed); };
        const auto end = line.run();
        QVERIFY2(end, qPrintable(end ? QString() : base::errorName(end.error().code)));
        if (!line.fixture.journal().open()->empty())
            QVERIFY2(!line.batch.pending.empty(), "an open change is unfinished");
        std::set<int> ids;
        for (std::size_t place : {0U, 1U}) {
            line.plug(place);
            ids.insert(line.servoAt(place).id());
        }
        for (const CommissionRow& row : line.batch.rows) {
            if (row.verdict == CommissionVerdict::Failed || row.newId < 0)
                continue;
            QVERIFY2(ids.count(row.newId) == 1, "the batch says what is so");
            for (std::size_t place : {0U, 1U}) {
                const auto& servo = line.servoAt(place);
                if (servo.id() != row.newId)
                    continue;
                QCOMPARE(servo.raw(q("position_p")), 24);
                QCOMPARE(servo.raw(q("max_temperature")), 65);
                QVERIFY(isLockedAndOff(servo));
            }
        }
    }

    void replacedAfterTheIdIsWritten_data()
    {
        QTest::addColumn<int>("gone");
        QTest::addColumn<int>("comes");
        for (const int gone : {1, 2, 3, 4, 5, 6, 8})
            for (const int comes : {0, 1, 4, 12, 40})
                QTest::addRow("gone after %d, another after %d", gone, comes) << gone << comes;
    }

    /// Another servo with the factory's ID takes the place of the one that has its new ID and an
    /// open lock: nothing of the first one is written to it, and the first one stays unfinished.
    void replacedAfterTheIdIsWritten()
    {
        QFETCH(const int, gone);
        QFETCH(const int, comes);
        CommissionFixture line(q("sts3215@1,sts3215@1"));
        line.savesSnapshotFiles = true;
        line.spec.count = 1;
        int frames = -1;
        line.fixture.tap().onWrite = [&](const base::Bytes& bytes) {
            const bool idWrite =
                bytes.size() > 6 && bytes[4] == support::Write && bytes[5] == 5 && bytes[6] == 11;
            if (idWrite && frames < 0)
                frames = 0;
            else if (frames >= 0)
                ++frames;
            if (frames == gone)
                line.unplugAll();
            if (frames == gone + comes)
                line.plug(1);
        };
        bool asked = false;
        line.onView = [&](const CommissionView& view) {
            asked = asked || view.step == CommissionStep::Confirm;
            const bool over = view.step == CommissionStep::Confirm ||
                              (view.step == CommissionStep::Unplug && line.isAnyPlugged());
            if (over)
                line.fixture.stop().request();
            return over || frames >= 0;
        };
        QVERIFY(line.run());
        QVERIFY(frames >= gone + comes);
        const auto& first = line.servoAt(0);
        const auto& other = line.servoAt(1);
        QCOMPARE(first.id(), 11);
        const bool finished = !line.batch.rows.empty() && line.batch.rows.front().newId == 11;
        QVERIFY2(other.id() != 11, "no two servos with one ID");
        QVERIFY2(!finished || first.raw(q("lock")) == 1, "what is said to be good is locked");
        if (finished)
            return;
        QVERIFY(!line.batch.pending.empty());
        const results::PendingCommission& left = line.batch.pending.front();
        QCOMPARE(left.newId, 11);
        QVERIFY(left.isIdSent);
        QVERIFY2(asked || left.isIdConfirmed, "the user is asked");
        QCOMPARE(left.lockOpen, !line.fixture.journal().open()->empty());
        QVERIFY2(left.lockOpen || first.raw(q("lock")) == 1, "an open lock is told");
    }

    /// It never left: its row says what was written and that the lock is open.
    void aLockThatDoesNotClose()
    {
        CommissionFixture line(q("sts3215@1"));
        unplugSpec(line);
        line.savesSnapshotFiles = true;
        bool opened = false;
        line.fixture.tap().onWrite = [&](const base::Bytes& bytes) {
            if (bytes.size() < 7) // a ping, or another protocol's
                return;
            opened = opened || (bytes[4] == support::Write && bytes[5] == 55 && bytes[6] == 0);
            if (opened && bytes[4] == support::Read)
                line.servoAt(0).poke(q("lock"), 0);
        };
        line.onView = [&](const CommissionView& view) {
            if (view.step == CommissionStep::Waiting && opened)
                line.fixture.stop().request();
            return view.step == CommissionStep::Waiting && opened;
        };
        (void)line.run();
        QCOMPARE(line.batch.rows.size(), std::size_t{1});
        const CommissionRow& row = line.batch.rows.front();
        QCOMPARE(row.verdict, CommissionVerdict::Failed);
        QCOMPARE(row.issues.back().word, q("lock-open"));
        QVERIFY(row.written > 0);
        QVERIFY(!line.batch.pending.empty());
        QVERIFY(!line.fixture.journal().open()->empty());
    }

    /// The click was about the one that stood there when it was asked for.
    void swappedBeforeTheClick()
    {
        CommissionFixture line(q("sts3215@1,sts3215@1"));
        line.spec.automatic = false;
        line.spec.count = 1;
        line.spec.settings = templateOf("sts3215", {{"position_p", 24}, {"max_temperature", 65}});
        line.plug(1);
        device::Servo other = line.fixture.servo(1);
        QVERIFY(device::write(line.fixture.context(), other, {{q("max_temperature"), 60}}, {}));
        line.unplugAll();
        int asked = 0;
        line.answer = [&] {
            if (++asked == 1) {
                line.unplugAll();
                line.plug(1);
            }
            return CommissionAnswer::Continue;
        };
        QVERIFY(line.run());
        QCOMPARE(line.servoAt(0).id(), 1);
        QCOMPARE(line.servoAt(1).id(), 11);
        QCOMPARE(asked, 2); // the other one was looked at, and asked about, by itself
        QCOMPARE(line.servoAt(1).raw(q("position_p")), 24);
    }

    /// A servo comes back at its old ID while a write of its template has not ended: the user is
    /// asked whether it is the one.
    void possiblyReplacedServoNeedsConfirmation()
    {
        bool everOpen = false;
        for (int frame = 1; frame <= 6; ++frame) {
            CommissionFixture line(q("sts3215@1,sts3215@1"));
            line.spec.automatic = false;
            line.spec.count = 1;
            line.spec.settings =
                templateOf("sts3215", {{"position_p", 24}, {"max_temperature", 65}});
            bool pulled = false;
            bool open = false;
            int changes = 0;
            line.fixture.tap().onWrite = [&](const base::Bytes& bytes) {
                if (!pulled && support::isWriteFrame(bytes) && ++changes == frame) {
                    pulled = true;
                    line.unplugAll();
                }
            };
            line.onView = [&](const CommissionView& view) {
                if (view.step != CommissionStep::Waiting || !pulled || line.isAnyPlugged())
                    return false;
                open = !line.fixture.journal().open()->empty();
                line.plug(0);
                return true;
            };
            bool questionAsked = false;
            line.answer = [&] {
                const bool doubts = line.views.back().candidateId == 11;
                questionAsked = questionAsked || doubts;
                return doubts ? CommissionAnswer::SameServo : CommissionAnswer::Continue;
            };
            QVERIFY(line.run());
            QVERIFY(pulled);
            QVERIFY2(questionAsked || !open, qPrintable(QString::number(frame)));
            everOpen = everOpen || open;
            QCOMPARE(line.batch.done(), 1);
            QCOMPARE(line.servoAt(0).id(), 11);
            QVERIFY(line.fixture.journal().open()->empty());
        }
        QVERIFY(everOpen);
    }
};

SERVODESK_GUILESS_TEST(TestCommission)
#include "tst_commission.moc"
