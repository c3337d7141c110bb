// SPDX-License-Identifier: GPL-3.0-or-later
// Names of enum values: both ways, and that no value of base is without a name of its own.
#include "base/enum_names.h"
#include "base/error.h"
#include "base/journal.h"
#include "support/test_main.h"

#include <QtTest>

namespace {
enum class Color { Red, Green };
constexpr base::EnumName<Color> colorNames[]{{Color::Red, "red"}, {Color::Green, "green"}};
} // namespace

class TestEnumNames : public QObject {
    Q_OBJECT

private slots:
    void lookUpBothWays()
    {
        QCOMPARE(base::nameOf(colorNames, Color::Green), QLatin1StringView("green"));
        QCOMPARE(base::valueOf(colorNames, u"red"), Color::Red);
        QVERIFY(!base::valueOf(colorNames, u"Red"));
        QVERIFY(!base::valueOf(colorNames, u""));
    }

    void everyErrorHasItsOwnName()
    {
        QStringList names;
        for (int code = 0; code <= int(base::ErrorCode::DiskFull); ++code)
            names << base::errorName(base::ErrorCode(code));
        QVERIFY(!names.contains(QString()));
        QCOMPARE(names.removeDuplicates(), 0);
    }

    void everyKindOfIntentIsReadBack()
    {
        for (int kind = 0; kind <= int(base::IntentKind::Undo); ++kind) {
            const QString name = base::intentKindName(base::IntentKind(kind));
            QCOMPARE(base::intentKindFromName(name), base::IntentKind(kind));
        }
        for (const base::Protocol protocol : base::allProtocols)
            QCOMPARE(base::protocolFromName(base::protocolName(protocol)), protocol);
    }
};

SERVODESK_GUILESS_TEST(TestEnumNames)
#include "tst_enum_names.moc"
