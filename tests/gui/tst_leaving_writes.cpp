// SPDX-License-Identifier: GPL-3.0-or-later
// Leaving while a write is unfinished: what the journal still holds is named, and the EPROM lock
// that the write has left open is closed or left on request, never silently.
#include "gui/dialogs.h"
#include "gui/five_rows.h"
#include "gui/window_bench.h"
#include "sim/sim_link.h"

#include <QDialog>
#include <QLabel>
#include <QPushButton>

namespace {
constexpr int longTime = 30'000;

QString text(const char* latin)
{
    return QString::fromLatin1(latin);
}

struct Bench : gui::WindowBench {
    template <typename Deed>
    auto withWire(Deed&& deed)
    {
        return desk().connection()->simulation()->with(std::forward<Deed>(deed));
    }
    void mute(bool mute)
    {
        withWire([mute](sim::VirtualBus& wire) {
            wire.config().faults.muteIds = mute ? std::vector<int>{1} : std::vector<int>{};
        });
    }
    std::int64_t lock()
    {
        std::int64_t value = -1;
        withWire([&value](sim::VirtualBus& wire) { value = wire.servo(1)->raw(text("lock")); });
        return value;
    }
    /// The servo falls silent while its lock is open, and answers again afterwards.
    bool interrupted()
    {
        if (!ready(1, text("sim:sts3215@1")))
            return false;
        withWire([](sim::VirtualBus& wire) {
            wire.config().faults.muteWhen = gui::secondOfFiveRowsIsWritten;
        });
        desk().write(selection().current(), gui::fiveRows());
        const bool ended = settled();
        withWire([](sim::VirtualBus& wire) { wire.config().faults.muteWhen = nullptr; });
        mute(false);
        return ended && lock() == 0 && unfinished() == 1;
    }
    std::size_t unfinished() { return session.journal().open()->size(); }
    QString line() { return find<QLabel>("messageText")->toolTip(); }
    bool closed()
    {
        return QTest::qWaitFor([this] { return !window->isVisible(); }, longTime);
    }
    bool isOff()
    {
        return QTest::qWaitFor([this] { return desk().state() == session::LinkState::Off; },
                               longTime);
    }
};
} // namespace

class TestLeavingWrites : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void disconnectingClosesTheLock();
    void closingClosesTheLock();
    void theLockMayBeLeftOpen();
    void cancelChangesNothing();
    void aLockThatStaysOpenKeepsTheWindowOpen();
    void aLockThatIsClosedLaterIsNoLongerNamed();
    void withoutAQuestionTheLockIsClosedAsWell();
    void whatTheJournalHoldsIsSaidWithoutAPort();
    void nothingUnfinishedIsNotAskedAbout();
};

void TestLeavingWrites::disconnectingClosesTheLock()
{
    Bench bench;
    QVERIFY(bench.interrupted());
    bench.action(ui::Command::Disconnect)->trigger();
    QDialog* dialog = bench.question();
    QVERIFY(dialog != nullptr);
    QVERIFY2(gui::labelsOf(dialog).contains(text("A write is unfinished. Disconnect anyway?")),
             qPrintable(gui::labelsOf(dialog)));
    QVERIFY(gui::labelsOf(dialog).contains(text("The EPROM lock of ID 1 is open")));
    QCOMPARE(bench.lock(), 0);
    bool locked = false;
    QObject::connect(
        &bench.desk(), &session::Desk::happened, dialog->parent(),
        [&](const session::Event& event) { locked = locked || !event.locked.empty(); });
    gui::click(dialog, "questionYes");
    QVERIFY(bench.isOff());
    QVERIFY(locked);
    QVERIFY2(bench.line().contains(text("EPROM lock closed: ID 1")), qPrintable(bench.line()));
    QCOMPARE(bench.unfinished(), std::size_t(1));
    QVERIFY(bench.connectTo(text("sim:sts3215@1")));
}

void TestLeavingWrites::closingClosesTheLock()
{
    Bench bench;
    QVERIFY(bench.interrupted());
    std::vector<session::ServoRef> locked;
    QObject::connect(&bench.desk(), &session::Desk::happened, &bench.desk(),
                     [&](const session::Event& event) {
                         if (event.kind == session::Event::Kind::Disconnected)
                             locked = event.locked;
                     });
    bench.window->close();
    QDialog* dialog = bench.question();
    QVERIFY(dialog != nullptr);
    gui::click(dialog, "questionYes");
    QVERIFY(bench.closed());
    QCOMPARE(locked.size(), std::size_t(1));
}

void TestLeavingWrites::theLockMayBeLeftOpen()
{
    Bench bench;
    QVERIFY(bench.interrupted());
    std::optional<session::Event> end;
    QObject::connect(&bench.desk(), &session::Desk::happened, &bench.desk(),
                     [&](const session::Event& event) {
                         if (event.kind == session::Event::Kind::Disconnected)
                             end = event;
                     });
    bench.window->close();
    QDialog* dialog = bench.question();
    QVERIFY(dialog != nullptr);
    gui::click(dialog, "questionOther");
    QVERIFY(bench.closed());
    QVERIFY(end && end->locked.empty() && end->unlocked.empty());
}

void TestLeavingWrites::cancelChangesNothing()
{
    Bench bench;
    QVERIFY(bench.interrupted());
    bench.window->close();
    QDialog* dialog = bench.question();
    QVERIFY(dialog != nullptr);
    gui::click(dialog, "questionNo");
    QTRY_VERIFY(bench.window->findChild<QDialog*>(text("question")) == nullptr);
    QVERIFY(bench.window->isVisible());
    QCOMPARE(bench.desk().state(), session::LinkState::Open);
    QCOMPARE(bench.lock(), 0);
}

void TestLeavingWrites::aLockThatStaysOpenKeepsTheWindowOpen()
{
    Bench bench;
    QVERIFY(bench.interrupted());
    bench.mute(true);
    bench.window->close();
    QDialog* dialog = bench.question();
    QVERIFY(dialog != nullptr);
    gui::click(dialog, "questionYes");
    QTRY_VERIFY_WITH_TIMEOUT(bench.line().contains(text("the EPROM lock of ID 1 is still open")),
                             longTime);
    QVERIFY(bench.window->isVisible());
    QCOMPARE(bench.desk().state(), session::LinkState::Open);
    bench.window->close();
    dialog = bench.question();
    QVERIFY(dialog != nullptr);
    gui::click(dialog, "questionOther");
    QVERIFY(bench.closed());
}

void TestLeavingWrites::aLockThatIsClosedLaterIsNoLongerNamed()
{
    Bench bench;
    QVERIFY(bench.interrupted());
    bench.mute(true);
    bench.window->close();
    QDialog* dialog = bench.question();
    QVERIFY(dialog != nullptr);
    gui::click(dialog, "questionYes");
    auto* banner = bench.find<QWidget>("banner");
    QVERIFY(banner != nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(banner->isVisible(), longTime);
    bench.mute(false);
    QVERIFY(bench.settled());
    bench.desk().settleIntent(bench.session.journal().open()->front().uuid,
                              jobs::RecoverAction::Undo);
    QTRY_COMPARE_WITH_TIMEOUT(bench.unfinished(), std::size_t(0), longTime);
    QTRY_VERIFY_WITH_TIMEOUT(!banner->isVisible(), longTime);
    bench.window->close();
    QVERIFY(bench.closed());
}

void TestLeavingWrites::withoutAQuestionTheLockIsClosedAsWell()
{
    Bench bench;
    QVERIFY(bench.interrupted());
    QTRY_VERIFY(bench.entry().lockOpenedByUs);
    bench.desk().disconnectFrom();
    QVERIFY(bench.isOff());
    QVERIFY2(bench.line().contains(text("EPROM lock closed: ID 1")), qPrintable(bench.line()));
}

void TestLeavingWrites::whatTheJournalHoldsIsSaidWithoutAPort()
{
    Bench bench;
    QVERIFY(bench.interrupted());
    bench.desk().disconnectFrom();
    QVERIFY(bench.isOff());
    bench.window->close();
    QDialog* dialog = bench.question();
    QVERIFY(dialog != nullptr);
    QVERIFY(gui::labelsOf(dialog).contains(text("ID 1: the journal still holds")));
    gui::click(dialog, "questionYes");
    QVERIFY(bench.closed());
}

void TestLeavingWrites::nothingUnfinishedIsNotAskedAbout()
{
    Bench bench;
    QVERIFY(bench.ready(1, text("sim:sts3215@1")));
    bench.window->close();
    QVERIFY(bench.closed());
}

QTEST_MAIN(TestLeavingWrites)
#include "tst_leaving_writes.moc"
