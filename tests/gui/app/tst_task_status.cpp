// SPDX-License-Identifier: GPL-3.0-or-later
// A task of more than a second shows itself in the status bar, on every page: what it is, how much
// is done, how long it takes, and Stop.
#include "gui/main_window_fixture.h"
#include "support/test_main.h"

#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include <thread>

using namespace std::chrono_literals;

namespace {
/// Runs until it is stopped; reports 20 % and soon 40 %, if at all.
session::Task lastingTask(const QString& name, bool reports, QObject* guard)
{
    session::Task task;
    task.name = name;
    task.quiet = true;
    task.work = [reports](session::TaskContext& context) -> base::Result<void> {
        if (reports)
            context.progress({0.2});
        std::this_thread::sleep_for(20ms); // so that there is a time to go by
        if (reports)
            context.progress({0.4});
        while (!context.stop.isRequested())
            std::this_thread::sleep_for(2ms);
        return base::fail(base::ErrorCode::Stopped);
    };
    task.guard = guard;
    return task;
}
} // namespace

class TestTaskStatus : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void aLongTaskIsShownUntilItEnds()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        auto* status = fixture.find<QWidget>("taskStatus");
        QVERIFY(status != nullptr && !status->isVisible());
        auto& tasks = fixture.workbench().tasks();
        tasks.perform(fixture.selection().current(),
                      lastingTask(QStringLiteral("restore"), true, this));
        QTRY_VERIFY(status->isVisible());
        static const QRegularExpression wanted(
            QStringLiteral("^Restore · 40 %, about ([0-9]+ min )?[0-9]+ s left$"));
        QTRY_VERIFY(wanted.match(fixture.find<QLabel>("taskStatusText")->text()).hasMatch());
        auto* bar = fixture.find<QProgressBar>("taskStatusBar");
        QVERIFY(bar->isVisible());
        QCOMPARE(bar->value(), 400);

        fixture.languages.apply(QStringLiteral("zh_CN"));
        QTRY_VERIFY(
            !fixture.find<QLabel>("taskStatusText")->text().contains(QStringLiteral("Restore")));
        QTest::mouseClick(fixture.find<QToolButton>("taskStatusStop"), Qt::LeftButton);
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(!status->isVisible());
    }

    /// What is not known is not shown: no bar that stays empty, no estimate.
    void aTaskWithoutProgressShowsItsName()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(fixture.ready(1));
        auto& tasks = fixture.workbench().tasks();
        tasks.perform(fixture.selection().current(),
                      lastingTask(QStringLiteral("reboot"), false, this));
        auto* status = fixture.find<QWidget>("taskStatus");
        QTRY_VERIFY(status->isVisible());
        QCOMPARE(fixture.find<QLabel>("taskStatusText")->text(), QStringLiteral("Reboot"));
        QVERIFY(!fixture.find<QProgressBar>("taskStatusBar")->isVisible());
        tasks.stop();
        QVERIFY(fixture.waitUntilIdle());
        QVERIFY(!status->isVisible());
    }
};

SERVODESK_TEST(TestTaskStatus)
#include "tst_task_status.moc"
