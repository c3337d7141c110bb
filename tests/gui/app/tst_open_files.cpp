// SPDX-License-Identifier: GPL-3.0-or-later
// Files given at the start, as by a double click: snapshots and recordings open on their pages
// without a servo, and what is no such file is named there.
#include "gui/main_window_fixture.h"
#include "jobs/restore/take_snapshot.h"
#include "support/test_main.h"
#include "ui/trends/trend_panel.h"

#include <QLabel>
#include <QTreeWidget>

namespace {
QString write(const QTemporaryDir& folder, const char* name, const QByteArray& content)
{
    QFile file(folder.filePath(QString::fromLatin1(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(content) < 0)
        qFatal("no file");
    return file.fileName();
}

/// Of the banners that are visible.
bool says(gui::MainWindowFixture& fixture, const char* text)
{
    const auto labels = fixture.window->findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [text](const QLabel* label) {
        return label->isVisible() && label->text().contains(QString::fromUtf8(text));
    });
}
} // namespace

class TestOpenFiles : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void aSnapshotIsShown()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("knee.servo.json"));
        {
            gui::MainWindowFixture fixture;
            QVERIFY(fixture.ready(1));
            const auto table = jobs::snapshotOf(fixture.entry().servo, QStringLiteral("test"));
            QVERIFY(snapshot::saveSnapshot(table, path));
        }
        gui::MainWindowFixture fixture;
        fixture.window->start({.files = {path}});
        QTRY_VERIFY(fixture.isShown("snapshotsPage"));
        const auto* tree = fixture.find<QTreeWidget>("shelfTree");
        QTRY_VERIFY(!tree->findItems(QStringLiteral("knee"), Qt::MatchContains | Qt::MatchRecursive)
                         .isEmpty());
    }

    void aRecordingIsShown()
    {
        const QTemporaryDir folder;
        const QString path =
            write(folder, "run.recording.csv",
                  "# ServoDesk recording 1\n# started 2026-11-29T08:00:00.000Z\n# program test\n"
                  "# port sim\n# baud 1000000\n# simulated yes\n"
                  "# servo ID1 1 1 feetech STS3215\n"
                  "time_us,servo,ID1.position[deg],marks\n"
                  "0,ID1,10,\n1000000,ID1,20,\n2000000,ID1,30,\n");
        gui::MainWindowFixture fixture;
        fixture.window->start({.files = {path}});
        QTRY_VERIFY(fixture.isShown("trendPanel"));
        QTRY_VERIFY(fixture.find<ui::TrendPanel>("trendPanel")->isReplaying());
    }

    void whatIsNoSuchFileIsNamed()
    {
        const QTemporaryDir folder;
        gui::MainWindowFixture fixture;
        fixture.window->start({.files = {write(folder, "broken.servo.json", "{")}});
        QTRY_VERIFY(says(fixture, "broken.servo.json"));
        fixture.window->start({.files = {write(folder, "prices.csv", "a,b\n1,2\n")}});
        QTRY_VERIFY(says(fixture, "prices.csv"));
    }
};

SERVODESK_TEST(TestOpenFiles)
#include "tst_open_files.moc"
