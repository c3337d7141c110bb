// SPDX-License-Identifier: GPL-3.0-or-later
// The filters of the history: a bench of the server stays chosen while the choices are loaded
// again.
#include "gui/main_window_fixture.h"
#include "session/history/history_server_choice.h"
#include "support/history_example.h"
#include "support/test_main.h"
#include "ui/history/history_filter_bar.h"

#include <QComboBox>

class TestHistoryFilterBar : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aChosenBenchStaysChosen()
    {
        gui::MainWindowFixture fixture;
        QVERIFY(session::setHistoryServerChoice(
            fixture.settings,
            {QStringLiteral("postgresql://u@127.0.0.1:1/db"), QStringLiteral("Here"), false}));
        history_example::Bench bench;
        session::HistoryService service(bench.path);
        ui::HistoryFilterBar bar(fixture.settings, nullptr);
        auto* source = bar.findChild<QComboBox*>(QStringLiteral("historySource"));
        auto* servo = bar.findChild<QComboBox*>(QStringLiteral("historyServo"));
        bar.setBenches({{5, {}, QStringLiteral("Left")}, {7, {}, QStringLiteral("Right")}});
        source->setCurrentIndex(source->findText(QStringLiteral("Server: Right")));
        QCOMPARE(bar.source().bench, std::optional<std::int64_t>(7));

        history_example::write(bench.journal, 4, 7);
        bar.loadChoices(service, false);
        QTRY_COMPARE(servo->count(), 2);
        QVERIFY(bar.source().isServer);
        QCOMPARE(bar.source().bench, std::optional<std::int64_t>(7));

        // A bench that is not on another server is left for this computer.
        bar.setBenches({});
        QVERIFY(!bar.source().isServer);
    }
};

SERVODESK_TEST(TestHistoryFilterBar)
#include "tst_history_filter_bar.moc"
