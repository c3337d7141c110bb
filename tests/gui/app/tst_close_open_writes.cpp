// SPDX-License-Identifier: GPL-3.0-or-later
// Leaving while a write is unfinished: the writes in the journal are named, and an EPROM that the
// write has left unlocked is locked or left on request, never silently.
#include "gui/dialogs.h"
#include "gui/five_register_write.h"
#include "gui/main_window_fixture.h"
#include "sim/host/sim_link.h"
#include "support/test_main.h"
#include "support/text.h"

#include <QDialog>
#include <QLabel>
#include <QPushButton>

using support::utf8;

namespace {
struct OpenWritesFixture : gui::MainWindowFixture {
    template <typename Action>
    auto withBus(Action&& action)
    {
        return workbench().link().connection()->simulation()->with(std::forward<Action>(action));
    }
    void mute(bool mute)
    {
        withBus([mute](sim::VirtualBus& wire) {
            wire.config().faults.muteIds = mute ? std::vector<int>{1} : std::vector<int>{};
        });
    }
    std::int64_t lock()
    {
        std::int64_t value = -1;
        withBus([&value](sim::VirtualBus& wire) { value = wire.servo(1)->raw(utf8("lock")); });
        return value;
    }
    /// The servo falls silent while its lock is open, and answers again afterwards.
    bool interrupted()
    {
        if (!ready(1, utf8("sim:sts3215@1")))
            return false;
        withBus([](sim::VirtualBus& wire) {
            wire.config().faults.muteWhen = gui::isSecondRegisterWritten;
        });
        workbench().writes().write(selection().current(), gui::fiveRegisterWrite());
        const bool ended = waitUntilIdle();
        withBus([](sim::VirtualBus& wire) { wire.config().faults.muteWhen = nullptr; });
        mute(false);
        return ended && lock() == 0 && unfinished() == 1;
    }
    std::size_t unfinished() { return session.journal().open()->size(); }
    QString line() { return find<QLabel>("messageText")->toolTip(); }
    bool closed()
    {
        return support::waitFor([this] { return !window->isVisible(); });
    }
    bool isOff()
    {
        return support::waitFor(
            [this] { return workbench().link().state() == session::LinkState::Off; });
    }
};
} // namespace

class TestCloseOpenWrites : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void disconnectingClosesTheLock();
    void closingClosesTheLock();
    void theLockCanBeLeftOpen();
    void cancelChangesNothing();
    void aLockThatStaysOpenKeepsTheWindowOpen();
    void aLockClosedLaterIsNoLongerReported();
    void theLockIsClosedWithoutAQuestionToo();
    void openIntentsAreReportedWithoutAPort();
    void noQuestionWithoutOpenWrites();
};

void TestCloseOpenWrites::disconnectingClosesTheLock()
{
    OpenWritesFixture fixture;
    QVERIFY(fixture.interrupted());
    fixture.action(ui::Command::Disconnect)->trigger();
    QDialog* dialog = fixture.question();
    QVERIFY(dialog != nullptr);
    QVERIFY2(gui::labelsOf(dialog).contains(utf8("A write is unfinished. Disconnect anyway?")),
             qPrintable(gui::labelsOf(dialog)));
    QVERIFY(gui::labelsOf(dialog).contains(utf8("The EPROM of ID 1 is unlocked")));
    QCOMPARE(fixture.lock(), 0);
    bool locked = false;
    QObject::connect(
        &fixture.workbench(), &session::Workbench::eventOccurred, dialog->parent(),
        [&](const session::Event& event) { locked = locked || !event.locked.empty(); });
    gui::click(dialog, "questionYes");
    QVERIFY(fixture.isOff());
    QVERIFY(locked);
    QVERIFY2(fixture.line().contains(utf8("EPROM locked: ID 1")), qPrintable(fixture.line()));
    QCOMPARE(fixture.unfinished(), std::size_t(1));
    QVERIFY(fixture.connectTo(utf8("sim:sts3215@1")));
}

void TestCloseOpenWrites::closingClosesTheLock()
{
    OpenWritesFixture fixture;
    QVERIFY(fixture.interrupted());
    std::vector<session::ServoRef> locked;
    QObject::connect(&fixture.workbench(), &session::Workbench::eventOccurred, &fixture.workbench(),
                     [&](const session::Event& event) {
                         if (event.kind == session::Event::Kind::Disconnected)
                             locked = event.locked;
                     });
    fixture.window->close();
    QDialog* dialog = fixture.question();
    QVERIFY(dialog != nullptr);
    gui::click(dialog, "questionYes");
    QVERIFY(fixture.closed());
    QCOMPARE(locked.size(), std::size_t(1));
}

void TestCloseOpenWrites::theLockCanBeLeftOpen()
{
    OpenWritesFixture fixture;
    QVERIFY(fixture.interrupted());
    std::optional<session::Event> end;
    QObject::connect(&fixture.workbench(), &session::Workbench::eventOccurred, &fixture.workbench(),
                     [&](const session::Event& event) {
                         if (event.kind == session::Event::Kind::Disconnected)
                             end = event;
                     });
    fixture.window->close();
    QDialog* dialog = fixture.question();
    QVERIFY(dialog != nullptr);
    gui::click(dialog, "questionOther");
    QVERIFY(fixture.closed());
    QVERIFY(end && end->locked.empty() && end->unlocked.empty());
}

void TestCloseOpenWrites::cancelChangesNothing()
{
    OpenWritesFixture fixture;
    QVERIFY(fixture.interrupted());
    fixture.window->close();
    QDialog* dialog = fixture.question();
    QVERIFY(dialog != nullptr);
    gui::click(dialog, "questionNo");
    QTRY_VERIFY(fixture.window->findChild<QDialog*>(utf8("question")) == nullptr);
    QVERIFY(fixture.window->isVisible());
    QCOMPARE(fixture.workbench().link().state(), session::LinkState::Open);
    QCOMPARE(fixture.lock(), 0);
}

void TestCloseOpenWrites::aLockThatStaysOpenKeepsTheWindowOpen()
{
    OpenWritesFixture fixture;
    QVERIFY(fixture.interrupted());
    fixture.mute(true);
    fixture.window->close();
    QDialog* dialog = fixture.question();
    QVERIFY(dialog != nullptr);
    gui::click(dialog, "questionYes");
    QTRY_VERIFY(fixture.line().contains(utf8("the EPROM of ID 1 is still unlocked")));
    QVERIFY(fixture.window->isVisible());
    QCOMPARE(fixture.workbench().link().state(), session::LinkState::Open);
    fixture.window->close();
    dialog = fixture.question();
    QVERIFY(dialog != nullptr);
    gui::click(dialog, "questionOther");
    QVERIFY(fixture.closed());
}

void TestCloseOpenWrites::aLockClosedLaterIsNoLongerReported()
{
    OpenWritesFixture fixture;
    QVERIFY(fixture.interrupted());
    fixture.mute(true);
    fixture.window->close();
    QDialog* dialog = fixture.question();
    QVERIFY(dialog != nullptr);
    gui::click(dialog, "questionYes");
    auto* banner = fixture.find<QWidget>("banner");
    QVERIFY(banner != nullptr);
    QTRY_VERIFY(banner->isVisible());
    fixture.mute(false);
    QVERIFY(fixture.waitUntilIdle());
    fixture.workbench().recovery().recoverIntent(fixture.session.journal().open()->front().uuid,
                                                 jobs::RecoveryAction::Undo);
    QTRY_COMPARE(fixture.unfinished(), std::size_t(0));
    QTRY_VERIFY(!banner->isVisible());
    fixture.window->close();
    QVERIFY(fixture.closed());
}

void TestCloseOpenWrites::theLockIsClosedWithoutAQuestionToo()
{
    OpenWritesFixture fixture;
    QVERIFY(fixture.interrupted());
    QTRY_VERIFY(fixture.entry().lockOpenedByUs);
    fixture.workbench().closing().disconnectFrom();
    QVERIFY(fixture.isOff());
    QVERIFY2(fixture.line().contains(utf8("EPROM locked: ID 1")), qPrintable(fixture.line()));
}

void TestCloseOpenWrites::openIntentsAreReportedWithoutAPort()
{
    OpenWritesFixture fixture;
    QVERIFY(fixture.interrupted());
    fixture.workbench().closing().disconnectFrom();
    QVERIFY(fixture.isOff());
    fixture.window->close();
    QDialog* dialog = fixture.question();
    QVERIFY(dialog != nullptr);
    QVERIFY(gui::labelsOf(dialog).contains(utf8("ID 1: the unfinished write is recorded")));
    gui::click(dialog, "questionYes");
    QVERIFY(fixture.closed());
}

void TestCloseOpenWrites::noQuestionWithoutOpenWrites()
{
    OpenWritesFixture fixture;
    QVERIFY(fixture.ready(1, utf8("sim:sts3215@1")));
    fixture.window->close();
    QVERIFY(fixture.closed());
}

SERVODESK_TEST(TestCloseOpenWrites)
#include "tst_close_open_writes.moc"
