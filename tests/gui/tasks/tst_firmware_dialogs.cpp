// SPDX-License-Identifier: GPL-3.0-or-later
// Updating a servo's firmware from the window, and rescuing one that hangs in its bootloader, with
// mouse clicks only: nothing starts while a check has failed, and the result is the servo's state.
#include "gui/dialogs.h"
#include "gui/main_window_fixture.h"
#include "gui/servo_tasks_fixture.h"
#include "support/test_main.h"
#include "ui/tasks/firmware_rescue_dialog.h"
#include "ui/tasks/firmware_update_dialog.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

using ui::Command;

namespace {
const QString image = QStringLiteral("SCServo21-GD32-TTL-250306.bin");

struct Fixture : gui::MainWindowFixture {
    explicit Fixture(const QString& port, const QString& language = QStringLiteral("en"))
        : MainWindowFixture(language)
    {
        page = QStringLiteral("firmware");
        if (!connectTo(port))
            qFatal("no bus");
    }

    QString makeFile(const QString& name)
    {
        QFile file(m_files.filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(QByteArray(1500, 'x')) != 1500)
            qFatal("no file");
        return file.fileName();
    }

    /// By the button of the page.
    template <typename Dialog>
    Dialog* open(const char* button)
    {
        if (!support::waitFor([&] { return find<QPushButton>(button)->isEnabled(); }))
            return nullptr;
        find<QPushButton>(button)->click();
        return window->findChild<Dialog*>();
    }
    void clickRow(int row, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        auto* table = find<QTableWidget>("firmwareTable");
        QTRY_VERIFY(table->rowCount() > row);
        QTest::mouseClick(table->viewport(), Qt::LeftButton, modifiers,
                          table->visualItemRect(table->item(row, 0)).center());
    }
    static void chooseFile(QDialog* dialog, const QString& path)
    {
        gui::click(dialog, "firmwareChoose");
        auto* files = dialog->findChild<QFileDialog*>(QStringLiteral("firmwareFileDialog"));
        QVERIFY(files != nullptr);
        Q_EMIT files->fileSelected(path);
        files->close();
    }
    /// With the image of the model, until all checks are done.
    bool check(QDialog* dialog)
    {
        chooseFile(dialog, makeFile(image));
        gui::click(dialog, "taskAction");
        return support::waitFor([dialog] {
            return gui::button(dialog, "taskAction")->text() == QLatin1String("Update");
        });
    }
    int minorVersion(int id)
    {
        return workbench().link().connection()->simulation()->with([id](sim::VirtualBus& wire) {
            return int(wire.servo(id)->raw(QStringLiteral("firmware_minor")));
        });
    }

private:
    QTemporaryDir m_files;
};

} // namespace

class TestFirmwareDialogs : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void aServoIsUpdated()
    {
        Fixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.choose(1));
        const session::ServoRef servo = fixture.selection().current();
        const QPointer dialog = fixture.open<ui::FirmwareUpdateDialog>("firmwareUpdate");
        QVERIFY(dialog);
        QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
        QVERIFY(fixture.check(dialog));
        QVERIFY(dialog->findChildren<QCheckBox*>().isEmpty()); // nothing to accept
        gui::click(dialog, "taskAction");
        QVERIFY(gui::ended(dialog));
        const QString result = gui::resultOf(dialog);
        QVERIFY2(result.startsWith(QStringLiteral("✓ The servo runs the new firmware.")),
                 qPrintable(result));
        QVERIFY2(result.contains(QStringLiteral("firmware 3.11")), qPrintable(result));
        QVERIFY2(result.contains(QStringLiteral("2 settings changed")), qPrintable(result));
        QCOMPARE(fixture.minorVersion(1), 11);
        QTRY_COMPARE(fixture.find<QTableWidget>("firmwareTable")->item(0, 3)->text(),
                     QStringLiteral("3.11"));
        QCOMPARE(fixture.selection().current(), servo); // it is the same one
        QVERIFY(dialog->isVisible());
        QCOMPARE(gui::button(dialog, "taskAction")->text(), QStringLiteral("Check"));
        dialog->close();
    }

    /// One of six: the others are a risk that has to be accepted.
    void aRiskIsAccepted()
    {
        Fixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3,sts3215@4,sts3215@5,"
                                       "sts3215@6"));
        QTRY_COMPARE(fixture.find<QTableWidget>("firmwareTable")->rowCount(), 6);
        fixture.clickRow(2);
        QCOMPARE(fixture.entry().servo.id, 3);
        const QPointer dialog = fixture.open<ui::FirmwareUpdateDialog>("firmwareUpdate");
        QVERIFY(dialog);
        Fixture::chooseFile(dialog, fixture.makeFile(QStringLiteral("renamed.bin")));
        gui::click(dialog, "taskAction");
        QTRY_COMPARE_WITH_TIMEOUT(dialog->findChildren<QCheckBox*>().size(), 2, 60'000);
        QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
        const QString others =
            dialog->findChild<QLabel*>(QStringLiteral("firmwareCheck-other-servos"))->text();
        QVERIFY2(others.contains(QStringLiteral("ID 1–2, 4–6")), qPrintable(others));
        dialog->findChild<QCheckBox*>(QStringLiteral("firmwareAccept-other-servos"))->click();
        QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
        dialog->findChild<QCheckBox*>(QStringLiteral("firmwareAccept-file-name"))->click();
        QVERIFY(gui::button(dialog, "taskAction")->isEnabled());
        fixture.setLanguage(QStringLiteral("zh_CN"));
        QVERIFY(gui::button(dialog, "taskAction")->isEnabled()); // what was accepted stays
        fixture.setLanguage(QStringLiteral("en"));
        gui::click(dialog, "taskAction");
        QVERIFY(gui::ended(dialog));
        QCOMPARE(fixture.minorVersion(3), 11);
        QCOMPARE(fixture.minorVersion(2), 10);
        dialog->close();
    }

    /// The rows of the page that are selected, one after the other; what was accepted counts for
    /// all of them.
    void aListOfServosIsUpdated()
    {
        Fixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3,sts3215@4"));
        fixture.clickRow(3);
        fixture.clickRow(1, Qt::ControlModifier);
        fixture.clickRow(0, Qt::ControlModifier);
        QCOMPARE(fixture.selection().selected().size(), std::size_t(3));
        const QPointer dialog = fixture.open<ui::FirmwareUpdateDialog>("firmwareUpdate");
        QVERIFY(dialog);
        QCOMPARE(dialog->findChild<QLabel*>(QStringLiteral("who"))->text(),
                 QStringLiteral("3 servos, one after the other: ID 1–2, 4"));
        QVERIFY(fixture.check(dialog));
        dialog->findChild<QCheckBox*>(QStringLiteral("firmwareAccept-other-servos"))->click();
        gui::click(dialog, "taskAction");
        QTRY_VERIFY_WITH_TIMEOUT(
            gui::resultOf(dialog).startsWith(QStringLiteral("✓ 3 servos run the new firmware.")),
            60'000);
        for (const char* line : {"ID 1, firmware 3.11", "ID 2, firmware", "ID 4, firmware"})
            QVERIFY2(gui::resultOf(dialog).contains(QLatin1String(line)),
                     qPrintable(gui::resultOf(dialog)));
        QCOMPARE(fixture.minorVersion(1), 11);
        QCOMPARE(fixture.minorVersion(2), 11);
        QCOMPARE(fixture.minorVersion(3), 10);
        QCOMPARE(fixture.minorVersion(4), 11);
        dialog->close();
    }

    /// The servo after it is not touched, and the next start begins with the one that failed.
    void aListEndsWithTheFirstFailure()
    {
        Fixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2,sts3215@3"));
        for (const int row : {0, 1, 2})
            fixture.clickRow(row, row == 0 ? Qt::NoModifier : Qt::ControlModifier);
        const QPointer dialog = fixture.open<ui::FirmwareUpdateDialog>("firmwareUpdate");
        QVERIFY(dialog);
        QVERIFY(fixture.check(dialog));
        dialog->findChild<QCheckBox*>(QStringLiteral("firmwareAccept-other-servos"))->click();
        const auto shared = fixture.workbench().link().connection()->simulation();
        shared->with([](sim::VirtualBus& wire) { wire.servo(2)->powerOff(); });
        gui::click(dialog, "taskAction");
        QTRY_VERIFY_WITH_TIMEOUT(gui::resultOf(dialog).startsWith(QStringLiteral("✗ Servo 2: ")),
                                 60'000);
        QVERIFY2(gui::resultOf(dialog).contains(QStringLiteral("Not updated yet: ID 3")),
                 qPrintable(gui::resultOf(dialog)));
        QVERIFY(gui::resultOf(dialog).contains(QStringLiteral("ID 1, firmware 3.11")));
        QCOMPARE(fixture.minorVersion(3), 10);

        shared->with([](sim::VirtualBus& wire) { wire.powerCycle(); });
        QTRY_VERIFY(gui::button(dialog, "taskAction")->isEnabled());
        gui::click(dialog, "taskAction");
        QTRY_COMPARE_WITH_TIMEOUT(gui::button(dialog, "taskAction")->text(),
                                  QStringLiteral("Update"), 60'000);
        dialog->findChild<QCheckBox*>(QStringLiteral("firmwareAccept-other-servos"))->click();
        gui::click(dialog, "taskAction");
        QTRY_VERIFY_WITH_TIMEOUT(
            gui::resultOf(dialog).startsWith(QStringLiteral("✓ 3 servos run the new firmware.")),
            60'000);
        QCOMPARE(fixture.minorVersion(1), 11); // once
        QCOMPARE(fixture.minorVersion(3), 11);
        dialog->close();
    }

    /// Stop is obeyed between two servos, and what is left is named.
    void stopEndsAList()
    {
        Fixture fixture(QStringLiteral("sim:sts3215@1,sts3215@2"));
        for (const int row : {0, 1})
            fixture.clickRow(row, row == 0 ? Qt::NoModifier : Qt::ControlModifier);
        const QPointer dialog = fixture.open<ui::FirmwareUpdateDialog>("firmwareUpdate");
        QVERIFY(dialog);
        QVERIFY(fixture.check(dialog));
        dialog->findChild<QCheckBox*>(QStringLiteral("firmwareAccept-other-servos"))->click();
        gui::click(dialog, "taskAction");
        const auto shared = fixture.workbench().link().connection()->simulation();
        QTRY_VERIFY_WITH_TIMEOUT(
            shared->with([](sim::VirtualBus& wire) { return wire.servo(1)->isInBootloader(); }),
            60'000);
        gui::click(dialog, "taskStop");
        QVERIFY(gui::ended(dialog));
        QVERIFY2(gui::resultOf(dialog).contains(QStringLiteral("Not updated yet: ID")),
                 qPrintable(gui::resultOf(dialog)));
        QCOMPARE(fixture.minorVersion(2), 10);
        dialog->close();
    }

    /// One that needs another file: its check asks, and nothing has been sent to it.
    void aRiskOfALaterServoIsAskedAbout()
    {
        Fixture fixture(QStringLiteral("sim:sts3215@1,scs15@2"));
        for (const int row : {0, 1})
            fixture.clickRow(row, row == 0 ? Qt::NoModifier : Qt::ControlModifier);
        const QPointer dialog = fixture.open<ui::FirmwareUpdateDialog>("firmwareUpdate");
        QVERIFY(dialog);
        QVERIFY(fixture.check(dialog));
        dialog->findChild<QCheckBox*>(QStringLiteral("firmwareAccept-other-servos"))->click();
        const int before = fixture.minorVersion(2);
        gui::click(dialog, "taskAction");
        const QString accept = QStringLiteral("firmwareAccept-file-name");
        QTRY_VERIFY_WITH_TIMEOUT(dialog->findChild<QCheckBox*>(accept) != nullptr, 60'000);
        QTRY_VERIFY(gui::resultOf(dialog).contains(QStringLiteral("Not updated yet: ID 2")));
        QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
        QCOMPARE(fixture.minorVersion(1), 11);
        QCOMPARE(fixture.minorVersion(2), before);
        dialog->close();
    }

    void anotherFileIsCheckedAgain()
    {
        Fixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.choose(1));
        const QPointer dialog = fixture.open<ui::FirmwareUpdateDialog>("firmwareUpdate");
        QVERIFY(dialog);
        QVERIFY(fixture.check(dialog));
        Fixture::chooseFile(dialog, fixture.makeFile(QStringLiteral("SMServo3.40-485.mbin")));
        QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
        QVERIFY2(gui::resultOf(dialog).contains(QStringLiteral("not a firmware file")),
                 qPrintable(gui::resultOf(dialog)));
        Fixture::chooseFile(dialog, fixture.makeFile(image));
        QCOMPARE(gui::button(dialog, "taskAction")->text(), QStringLiteral("Check"));
        dialog->close();
    }

    void lxServosAreRefused()
    {
        Fixture fixture(QStringLiteral("sim:lx16a@1"));
        QVERIFY(fixture.choose(1));
        const QPointer dialog = fixture.open<ui::FirmwareUpdateDialog>("firmwareUpdate");
        QVERIFY(dialog);
        QVERIFY(gui::resultOf(dialog).contains(QStringLiteral("cannot be updated here")));
        Fixture::chooseFile(dialog, fixture.makeFile(image));
        QVERIFY(!gui::button(dialog, "taskAction")->isEnabled());
        dialog->close();
    }

    /// Its firmware is gone: the window says that the update failed, and the rescue brings it back.
    void aServoWithoutFirmwareIsRescued()
    {
        Fixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.choose(1));
        const QPointer dialog = fixture.open<ui::FirmwareUpdateDialog>("firmwareUpdate");
        QVERIFY(dialog);
        QVERIFY(fixture.check(dialog));
        const auto shared = fixture.workbench().link().connection()->simulation();
        shared->with([](sim::VirtualBus& wire) { wire.servo(1)->defects().firmwareLost = true; });
        gui::click(dialog, "taskAction");
        QTRY_VERIFY_WITH_TIMEOUT(gui::resultOf(dialog).startsWith(QStringLiteral("✗")), 60'000);
        dialog->close();

        auto* rescue = fixture.open<ui::FirmwareRescueDialog>("firmwareRescue");
        QVERIFY(rescue != nullptr);
        QVERIFY(!gui::button(rescue, "taskAction")->isEnabled());
        Fixture::chooseFile(rescue, fixture.makeFile(image));
        gui::click(rescue, "taskAction");
        QTRY_VERIFY_WITH_TIMEOUT(gui::resultOf(rescue).startsWith(QStringLiteral("✓")), 60'000);
        QVERIFY(gui::resultOf(rescue).contains(QStringLiteral("ID 1, firmware")));
        QVERIFY(fixture.waitUntilIdle());
        QCOMPARE(fixture.workbench().link().baud(), 1'000'000);
        rescue->close();
    }

    void aRescueIsStopped()
    {
        Fixture fixture(QStringLiteral("sim:sts3215@1"));
        QVERIFY(fixture.choose(1)); // or the read after the search would fail
        const auto shared = fixture.workbench().link().connection()->simulation();
        shared->with([](sim::VirtualBus& wire) { wire.servo(1)->powerOff(); });
        auto* rescue = fixture.open<ui::FirmwareRescueDialog>("firmwareRescue");
        QVERIFY(rescue != nullptr);
        Fixture::chooseFile(rescue, fixture.makeFile(image));
        gui::click(rescue, "taskAction");
        QTRY_VERIFY(gui::button(rescue, "taskStop")->isVisible());
        gui::click(rescue, "taskStop");
        QVERIFY(gui::ended(rescue));
        shared->with([](sim::VirtualBus& wire) { wire.powerCycle(); });
        QCOMPARE(fixture.minorVersion(1), 10);
        QCOMPARE(fixture.workbench().link().baud(), 1'000'000); // the port is as it was
        const base::Duration powered = fixture.workbench().registry().now();
        QTRY_VERIFY(fixture.entry().lastSeen > powered);
        rescue->close();
    }
};

SERVODESK_TEST(TestFirmwareDialogs)
#include "tst_firmware_dialogs.moc"
