// SPDX-License-Identifier: GPL-3.0-or-later
// The size that the user gives a dialog is there again the next time, also in the next program;
// one that nobody has resized follows its content.
#include "support/temporary_data_folder.h"
#include "support/test_main.h"
#include "ui/common/dialog_sizes.h"

#include <QDialog>
#include <QScreen>
#include <QtTest>

namespace {
struct Fixture {
    support::TemporaryDataFolder folder;
    QString file = folder.path() + QStringLiteral("/servodesk.ini");

    /// Opens a dialog in a program that has just been started.
    QSize resizedTo(const QSize& wanted, const QString& name = QStringLiteral("runsDialog"),
                    bool remembers = true) const
    {
        session::Settings settings(file);
        ui::DialogSizes sizes(settings);
        QDialog dialog;
        dialog.setObjectName(name);
        dialog.resize(300, 200);
        if (remembers)
            ui::rememberSize(dialog);
        dialog.show();
        const QSize opened = dialog.size();
        if (!wanted.isEmpty())
            dialog.resize(wanted);
        dialog.close();
        return opened;
    }
};
} // namespace

class TestDialogSizes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theUsersSizeIsKept()
    {
        const Fixture fixture;
        QCOMPARE(fixture.resizedTo({}), QSize(300, 200));
        QCOMPARE(fixture.resizedTo({450, 380}), QSize(300, 200)); // opening it has fixed nothing
        QCOMPARE(fixture.resizedTo({}), QSize(450, 380));
        QCOMPARE(fixture.resizedTo({}), QSize(450, 380));
        QCOMPARE(fixture.resizedTo({}, QStringLiteral("applyDialog")), QSize(300, 200));
    }

    void aFormIsNotResized()
    {
        const Fixture fixture;
        fixture.resizedTo({450, 380}, QStringLiteral("portDialog"), false);
        QCOMPARE(fixture.resizedTo({}, QStringLiteral("portDialog"), false), QSize(300, 200));
    }

    /// It was another screen, or somebody has edited the file.
    void itFitsOnTheScreen()
    {
        const Fixture fixture;
        fixture.resizedTo({9000, 8000});
        const QSize screen = QGuiApplication::primaryScreen()->availableSize();
        QCOMPARE(fixture.resizedTo({}), screen);
        session::Settings(fixture.file)
            .setPageValue(QStringLiteral("dialogs/runsDialog_width"), -5);
        QCOMPARE(fixture.resizedTo({}), QSize(300, 200));
    }
};

SERVODESK_TEST(TestDialogSizes)
#include "tst_dialog_sizes.moc"
