// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of errors, notices and alarms: complete, specific, and Chinese in the Chinese
// interface.
#include "support/test_main.h"
#include "text/error_text.h"
#include "text/front_end.h"
#include "text/language.h"
#include "text/notice_text.h"
#include "text/progress_text.h"

#include <QRegularExpression>
#include <QScopeGuard>
#include <QSet>
#include <QTest>

using base::ErrorCode;
using base::NoticeCode;

namespace {
constexpr auto lastError = ErrorCode::DiskFull;
constexpr auto lastNotice = NoticeCode::IdChanged;

bool containsChinese(const QString& text)
{
    static const QRegularExpression han(QStringLiteral("\\p{Han}"));
    return text.contains(han);
}

bool hasPlaceholder(const QString& text)
{
    static const QRegularExpression open(QStringLiteral("%[0-9nL]"));
    return text.contains(open);
}

base::Error errorOf(ErrorCode code)
{
    base::Error error;
    error.code = code;
    error.id = 7;
    return error;
}
} // namespace

class TestText : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        QTest::failOnWarning(QRegularExpression(QStringLiteral(".*")));
        text::installTranslator(QStringLiteral("en"));
    }
    void everyErrorHasText_data();
    void everyErrorHasText();
    void everyNoticeHasText_data();
    void everyNoticeHasText();
    void errorsNameTheSubject_data();
    void errorsNameTheSubject();
    void remediesAreSpecific_data();
    void remediesAreSpecific();
    void noticesIncludeTheirNumbers();
    void progressIsRounded();
    void unrecordedClaimsNoChange();
    void listsHaveTheCommaOfTheLanguage();
    void outcomesAndLocksInBothLanguages_data();
    void outcomesAndLocksInBothLanguages();
    void alarmBitNamesDependOnTheFamily();
    void unnamedAlarmBitsKeepTheirNumber();
    void recoveryUsesTheProgramsTerm();
};

void TestText::everyErrorHasText_data()
{
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("language");
    QSet<QString> names;
    for (int code = 0; code <= int(lastError); ++code) {
        const QString name = base::errorName(ErrorCode(code));
        QVERIFY(!names.contains(name));
        names.insert(name);
        for (const char* language : {"en", "zh_CN"}) {
            QTest::addRow("%s %s", qPrintable(name), language)
                << code << QString::fromLatin1(language);
        }
    }
}

void TestText::everyErrorHasText()
{
    QFETCH(int, code);
    QFETCH(QString, language);
    text::installTranslator(language);
    const text::Description words = text::describe(errorOf(ErrorCode(code)));
    for (const QString& sentence : {words.message, words.cause, words.remedy}) {
        QVERIFY(!sentence.isEmpty());
        QVERIFY2(!hasPlaceholder(sentence), qPrintable(sentence));
        QCOMPARE(containsChinese(sentence), language == QLatin1String("zh_CN"));
    }
    QVERIFY2(words.message.contains(QLatin1Char('7')), qPrintable(words.message));
}

void TestText::everyNoticeHasText_data()
{
    QTest::addColumn<int>("code");
    QTest::addColumn<QString>("language");
    QSet<QString> names;
    for (int code = 0; code <= int(lastNotice); ++code) {
        const QString name = text::noticeName(NoticeCode(code));
        QVERIFY(!name.isEmpty() && !names.contains(name));
        names.insert(name);
        for (const char* language : {"en", "zh_CN"}) {
            QTest::addRow("%s %s", qPrintable(name), language)
                << code << QString::fromLatin1(language);
        }
    }
}

void TestText::everyNoticeHasText()
{
    QFETCH(int, code);
    QFETCH(QString, language);
    text::installTranslator(language);
    base::Notice notice;
    notice.code = NoticeCode(code);
    notice.key = QStringLiteral("goal_speed");
    const QString sentence = text::describe(notice);
    QVERIFY(!sentence.isEmpty());
    QVERIFY2(!hasPlaceholder(sentence), qPrintable(sentence));
    QCOMPARE(containsChinese(sentence), language == QLatin1String("zh_CN"));
}

void TestText::errorsNameTheSubject_data()
{
    QTest::addColumn<base::Error>("error");
    QTest::addColumn<QString>("what");
    const auto row = [](const char* name, base::Error error, const char* what) {
        QTest::newRow(name) << error << QString::fromUtf8(what);
    };
    row("silent servo", {ErrorCode::NoReply, {}, {}, 9, {}, 3}, "Servo 9: no reply, 3 attempts.");
    row("nobody in particular", {ErrorCode::NoReply}, "No reply.");
    row("range",
        {ErrorCode::OutOfRange, {}, QStringLiteral("0 … 4095"), 1, QStringLiteral("goal_position")},
        "Servo 1, goal_position: the value is outside the allowed range (0 … 4095).");
    row("busy", {ErrorCode::PortBusy, {}, QStringLiteral("minicom (411)")},
        "The port is in use by minicom (411).");
    row("taken", {ErrorCode::PortMissing, {}, QStringLiteral("/dev/ttyUSB0, brltty")},
        "The braille service (brltty) has taken over the adapter (/dev/ttyUSB0).");
    row("no key twice",
        {ErrorCode::UnknownRegister, {}, QStringLiteral("speeed"), 2, QStringLiteral("speeed")},
        "Servo 2, speeed: this servo has no register with that name.");
    row("travel time",
        {ErrorCode::NotSupported, QStringLiteral("move"), QStringLiteral("position"), 4,
         QStringLiteral("time")},
        "Servo 4, time: this servo does not support a travel time in its present mode.");
    row("late arrival", {ErrorCode::Refused, QStringLiteral("arrive"), QStringLiteral("time"), 4},
        "Servo 4: the servo did not stop in time.");
}

void TestText::errorsNameTheSubject()
{
    QFETCH(base::Error, error);
    QFETCH(QString, what);
    QCOMPARE(text::describe(error).message, what);
}

void TestText::remediesAreSpecific_data()
{
    QTest::addColumn<base::Error>("error");
    QTest::addColumn<QString>("contained");
    QTest::newRow("group of the port")
        << base::Error{ErrorCode::PortPermission, {}, QStringLiteral("uucp")}
        << QStringLiteral("sudo usermod -aG uucp $USER");
    QTest::newRow("usual group when none is known")
        << base::Error{ErrorCode::PortPermission} << QStringLiteral("-aG dialout");
    QTest::newRow("vanishing CH340")
        << base::Error{ErrorCode::PortMissing, {}, QStringLiteral("/dev/ttyUSB0")}
        << QStringLiteral("brltty");
    QTest::newRow("CH340 taken") << base::Error{ErrorCode::PortMissing,
                                                {},
                                                QStringLiteral("/dev/ttyUSB0, brltty")}
                                 << QStringLiteral("sudo apt remove brltty");
    QTest::newRow("id by its own command")
        << base::Error{ErrorCode::NotSupported, QStringLiteral("write"), QStringLiteral("set-id"),
                       1, QStringLiteral("id")}
        << QStringLiteral("set-id");
}

void TestText::remediesAreSpecific()
{
    QFETCH(base::Error, error);
    QFETCH(QString, contained);
    const QString remedy = text::describe(error).remedy;
    QVERIFY2(remedy.contains(contained), qPrintable(remedy));
    text::installTranslator(QStringLiteral("zh_CN"));
    QVERIFY(text::describe(error).remedy.contains(contained));
}

/// The notice is also used for a write that was refused or never sent.
void TestText::unrecordedClaimsNoChange()
{
    const QString said = text::describe({NoticeCode::NotRecorded, 1, QStringLiteral("full")});
    QVERIFY2(!said.contains(QStringLiteral("was made")), qPrintable(said));
    QVERIFY2(said.contains(QStringLiteral("full")), qPrintable(said));
}

void TestText::noticesIncludeTheirNumbers()
{
    const base::Notice notice{NoticeCode::LimitsSaved, 1, {}, 100, 3000};
    const QString sentence = text::describe(notice);
    QVERIFY2(sentence.contains(QLatin1String("100")), qPrintable(sentence));
    QVERIFY2(sentence.contains(QLatin1String("3000")), qPrintable(sentence));
}

void TestText::listsHaveTheCommaOfTheLanguage()
{
    const QStringList joints{QStringLiteral("elbow"), QStringLiteral("wrist")};
    QCOMPARE(text::joinItems(joints), QStringLiteral("elbow, wrist"));
    text::installTranslator(QStringLiteral("zh_CN"));
    QCOMPARE(text::joinItems(joints), QStringLiteral("elbow、wrist"));
}

void TestText::outcomesAndLocksInBothLanguages_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("lock");
    for (const char* name :
         {"kept", "temporary", "mismatch", "refused", "not-sent", "no-answer", "unknown"})
        QTest::addRow("outcome %s", name) << QString::fromLatin1(name) << false;
    for (const char* name : {"closed", "open", "unknown", "none"})
        QTest::addRow("lock %s", name) << QString::fromLatin1(name) << true;
}

void TestText::outcomesAndLocksInBothLanguages()
{
    QFETCH(QString, name);
    QFETCH(bool, lock);
    const auto word = [&] { return lock ? text::lockLabel(name) : text::outcomeLabel(name); };
    QVERIFY(!word().isEmpty() && !containsChinese(word()));
    text::installTranslator(QStringLiteral("zh_CN"));
    QVERIFY2(containsChinese(word()), qPrintable(word()));
}

void TestText::alarmBitNamesDependOnTheFamily()
{
    catalog::Profile profile;
    catalog::Register status;
    status.role = catalog::Role::Status;
    status.values = {
        {0, QStringLiteral("voltage"), {QStringLiteral("voltage"), QStringLiteral("电压")}},
        {5, QStringLiteral("overload"), {QStringLiteral("overload"), QStringLiteral("过载")}}};
    profile.registers = {status};
    QCOMPARE(text::statusKeys(0x21, &profile),
             (QStringList{QStringLiteral("voltage"), QStringLiteral("overload")}));
    QCOMPARE(text::statusText(0x21, &profile), QStringLiteral("voltage + overload"));
    QCOMPARE(text::statusText(0, &profile), QStringLiteral("none"));
    text::installTranslator(QStringLiteral("zh_CN"));
    QCOMPARE(text::statusText(0x21, &profile), QStringLiteral("过压欠压 + 过载"));
}

void TestText::unnamedAlarmBitsKeepTheirNumber()
{
    QCOMPARE(text::statusKeys(0x90, nullptr),
             (QStringList{QStringLiteral("bit4"), QStringLiteral("bit7")}));
}

/// The window has no "recover" command, and the command line has no menu.
void TestText::recoveryUsesTheProgramsTerm()
{
    const QString menu = QStringLiteral("Port → Interrupted writes");
    const auto words = [] {
        QStringList all;
        for (const base::NoticeCode code :
             {base::NoticeCode::LockLeftOpen, base::NoticeCode::LedNotRestored,
              base::NoticeCode::NotRecorded, base::NoticeCode::SettingNotRestored})
            all << text::describe(base::Notice{code, 1, QStringLiteral("lock")});
        base::Error restarted{base::ErrorCode::Uncertain};
        restarted.detail = QStringLiteral("restarted");
        all << text::describe(restarted).remedy
            << text::describe(base::Error{base::ErrorCode::LinkLost}).remedy
            << text::describe(base::Error{base::ErrorCode::LockOpen}).remedy;
        return all;
    };
    for (const QString& sentence : words()) {
        QVERIFY2(sentence.contains(QStringLiteral("recover")), qPrintable(sentence));
        QVERIFY2(!sentence.contains(QLatin1Char('%')) && !sentence.contains(menu),
                 qPrintable(sentence));
    }
    text::setFrontEnd(text::FrontEnd::Window);
    const auto commandLine = qScopeGuard([] { text::setFrontEnd(text::FrontEnd::CommandLine); });
    for (const QString& sentence : words()) {
        QVERIFY2(sentence.contains(menu), qPrintable(sentence));
        QVERIFY2(!sentence.contains(QStringLiteral("recover")), qPrintable(sentence));
    }
    text::installTranslator(QStringLiteral("zh_CN"));
    for (const QString& sentence : words())
        QVERIFY2(sentence.contains(QStringLiteral("“端口 → 未写完的更改”")), qPrintable(sentence));
}

void TestText::progressIsRounded()
{
    using namespace std::chrono_literals;
    using text::durationText;
    QCOMPARE(durationText(59'400ms), QStringLiteral("59 s"));
    QCOMPARE(durationText(59'600ms), QStringLiteral("1 min 0 s"));
    QCOMPARE(durationText(3599s), QStringLiteral("59 min 59 s"));
    QCOMPARE(durationText(7500s), QStringLiteral("2 h 5 min"));
    QCOMPARE(text::progressText(0.429, 12s), QStringLiteral("42 %, about 12 s left"));
    QCOMPARE(text::progressText(0.999, 0s), QStringLiteral("99 %, about 1 s left"));
    QCOMPARE(text::progressText(0.1, std::nullopt), QStringLiteral("10 %"));
}

SERVODESK_GUILESS_TEST(TestText)
#include "tst_text.moc"
