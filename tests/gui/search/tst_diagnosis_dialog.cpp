// SPDX-License-Identifier: GPL-3.0-or-later
// The diagnosis as a technician sees it: evidence while it runs, the cause, and the button that
// does what the remedy says.
#include "gui/workbench_fixture.h"
#include "support/test_main.h"
#include "text/language.h"
#include "ui/search/diagnosis_dialog.h"
#include "ui/search/remedy_drawing.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTextBrowser>

using ui::Command;

namespace {
struct DiagnosisFixture : gui::WorkbenchFixture {
    explicit DiagnosisFixture(const QString& port, std::optional<int> baud = {})
    {
        session::PortRequest request;
        request.name = port;
        request.baud = baud;
        workbench.link().connectTo(request);
        if (!support::waitFor(
                [this] { return workbench.link().state() == session::LinkState::Open; }))
            qFatal("no port");
        dialog = new ui::DiagnosisDialog(workbench.search(), workbench.link(), commands, nullptr);
        dialog->show();
    }
    ~DiagnosisFixture() { delete dialog; }

    template <typename Widget>
    Widget* find(const char* name) const
    {
        return dialog->findChild<Widget*>(QString::fromLatin1(name));
    }
    bool isDone() const { return !workbench.search().isDiagnosing(); }
    QString text(const char* name) const { return find<QLabel>(name)->text(); }
    QString evidence() const { return find<QTextBrowser>("diagnosisEvidence")->toPlainText(); }
    QPushButton* actionButton() const { return find<QPushButton>("diagnosisAction"); }

    QPointer<ui::DiagnosisDialog> dialog;
};
} // namespace

class TestDiagnosisDialog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        gui::failOnWarnings();
        text::installTranslator(QStringLiteral("en"));
    }
    void cleanup() { text::installTranslator(QStringLiteral("en")); }

    void explainsItselfWhileItRuns();
    void connectsAtTheRateThatWasFound();
    void leadsFromSeveralServosToCommissioning();
    void followsTheLanguage();
    void closingItEndsTheDiagnosis();
    void waitsForARunningSearch();
    void aLostPortIsSaid();
    void drawsWhatToDo();
};

void TestDiagnosisDialog::explainsItselfWhileItRuns()
{
    DiagnosisFixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
    QCOMPARE(fixture.text("diagnosisCause"), QStringLiteral("Looking for the cause…"));
    QVERIFY(!fixture.actionButton()->isVisible());
    QTRY_VERIFY(fixture.evidence().contains(QStringLiteral("can be opened at 1000000 baud")));
    QVERIFY(!fixture.isDone());
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isDone(), 60'000);
    QCOMPARE(fixture.text("diagnosisCause"),
             QStringLiteral("The servos that were found reply reliably."));
    QVERIFY(!fixture.actionButton()->isVisible());
    QVERIFY(!fixture.find<QWidget>("remedyDrawing")->isVisible());
    QCOMPARE(fixture.workbench.registry().order().size(), std::size_t(2)); // as after a search
    fixture.find<QPushButton>("diagnosisCopy")->click();
    const QString report = QGuiApplication::clipboard()->text();
    QVERIFY2(report.contains(QStringLiteral("\n- 2 servos found at 1000000 baud")),
             qPrintable(report));
    QVERIFY2(report.contains(QStringLiteral("\nThe servos that were found reply reliably.\n")),
             qPrintable(report));
}

void TestDiagnosisDialog::connectsAtTheRateThatWasFound()
{
    DiagnosisFixture fixture(QStringLiteral("sim:sts3215@1:500000"), 1'000'000);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isDone(), 60'000);
    QCOMPARE(fixture.text("diagnosisCause"),
             QStringLiteral("Some servos use a different baud rate."));
    QVERIFY(!fixture.text("diagnosisRemedy").isEmpty());
    QCOMPARE(fixture.workbench.link().baud(), 1'000'000);
    QVERIFY2(fixture.actionButton()->isVisible() && fixture.actionButton()->text().contains(u"500"),
             qPrintable(fixture.actionButton()->text()));
    fixture.actionButton()->click();
    QTRY_COMPARE(fixture.workbench.link().baud(), 500'000);
    QTRY_VERIFY(fixture.dialog == nullptr);
}

void TestDiagnosisDialog::leadsFromSeveralServosToCommissioning()
{
    DiagnosisFixture fixture(QStringLiteral("sim:new-arm"));
    QSignalSpy page(fixture.action(Command::PageCommission), &QAction::triggered);
    QTRY_VERIFY_WITH_TIMEOUT(fixture.isDone(), 60'000);
    QCOMPARE(fixture.text("diagnosisCause"), QStringLiteral("Several servos have the same ID."));
    QVERIFY(fixture.find<QWidget>("remedyDrawing")->isVisible());
    fixture.actionButton()->click();
    QCOMPARE(page.count(), 1);
}

void TestDiagnosisDialog::followsTheLanguage()
{
    DiagnosisFixture fixture(QStringLiteral("sim:sts3215@1"));
    QTRY_VERIFY(!fixture.evidence().isEmpty());
    text::installTranslator(QStringLiteral("zh_CN"));
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(fixture.dialog, &change);
    static const QRegularExpression han(QStringLiteral("\\p{Han}"));
    for (const QString& words :
         {fixture.dialog->windowTitle(), fixture.text("diagnosisCause"), fixture.evidence(),
          fixture.find<QPushButton>("diagnosisAgain")->text()})
        QVERIFY2(words.contains(han), qPrintable(words));
}

void TestDiagnosisDialog::closingItEndsTheDiagnosis()
{
    DiagnosisFixture fixture(QStringLiteral("sim:sts3215@1"));
    QTRY_VERIFY(!fixture.workbench.search().diagnosis().evidence.empty());
    fixture.find<QPushButton>("diagnosisClose")->click();
    QTRY_VERIFY(fixture.isDone());
    QVERIFY(fixture.workbench.search().diagnosis().stopped);
}

void TestDiagnosisDialog::waitsForARunningSearch()
{
    DiagnosisFixture fixture(QStringLiteral("sim:sts3215@1"));
    jobs::ScanSpec spec;
    spec.bauds = {1'000'000};
    fixture.find<QPushButton>("diagnosisAgain")->click(); // stops it
    QTRY_VERIFY(fixture.isDone());
    fixture.workbench.search().start(spec);
    fixture.find<QPushButton>("diagnosisAgain")->click();
    QVERIFY(!fixture.isDone());
    QCOMPARE(fixture.text("diagnosisCause"), QStringLiteral("Looking for the cause…"));
    fixture.find<QPushButton>("diagnosisClose")->click();
    QVERIFY(fixture.isDone());
    QTRY_VERIFY(!fixture.workbench.search().isSearching());
    QVERIFY(fixture.workbench.search().diagnosis().evidence.empty()); // it never began
}

void TestDiagnosisDialog::aLostPortIsSaid()
{
    DiagnosisFixture fixture(QStringLiteral("sim:sts3215@1"));
    QTRY_VERIFY(!fixture.workbench.search().diagnosis().evidence.empty());
    fixture.workbench.closing().disconnectFrom();
    QTRY_VERIFY(fixture.isDone());
    QTRY_COMPARE(fixture.workbench.link().state(), session::LinkState::Off);
    QCOMPARE(fixture.text("diagnosisCause"), QStringLiteral("The diagnosis was stopped."));
    QVERIFY(!fixture.find<QPushButton>("diagnosisAgain")->isEnabled());
}

/// In the colors of the theme.
void TestDiagnosisDialog::drawsWhatToDo()
{
    QWidget parent;
    ui::RemedyDrawing drawing(&parent);
    parent.show();
    drawing.resize(drawing.sizeHint());
    const auto pixels = [&](const QColor& color) {
        const QImage image = drawing.grab().toImage();
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x)
                count += image.pixelColor(x, y) == color ? 1 : 0;
        }
        return count;
    };
    for (const base::Cause cause :
         {base::Cause::NoServoOrNoPower, base::Cause::EchoOnly, base::Cause::Noise,
          base::Cause::TwoServosOneId, base::Cause::Bootloader}) {
        drawing.setCause(cause);
        QVERIFY(drawing.isVisible());
        for (const QColor& ink : {QColor(0x20, 0x20, 0x20), QColor(0xe8, 0xe8, 0xe8)}) {
            QPalette colors = drawing.palette();
            colors.setColor(QPalette::Text, ink);
            drawing.setPalette(colors);
            QVERIFY2(pixels(ink) > 100, qPrintable(base::causeName(cause)));
        }
    }
    drawing.setCause(base::Cause::OtherProtocol);
    QVERIFY(!drawing.isVisible());
}

SERVODESK_TEST(TestDiagnosisDialog)
#include "tst_diagnosis_dialog.moc"
