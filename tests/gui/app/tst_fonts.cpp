// SPDX-License-Identifier: GPL-3.0-or-later
// The fonts of the program on a machine that has only DejaVu: it uses its own, digits have one
// width, and they contain every character of the texts of the program.
#include "gui/main_window_fixture.h"
#include "report/fonts.h"
#include "support/font_config.h"
#include "support/test_main.h"
#include "support/test_paths.h"
#include "ui/app/help_window.h"

#include <QAbstractButton>
#include <QDirIterator>
#include <QFontDatabase>
#include <QRawFont>
#include <QTextBlock>
#include <QTextBrowser>

namespace {
/// The characters of all shown texts: string literals, help, register maps, translations.
QString shownText()
{
    QString all;
    for (const char* folder : {"src", "ui", "resources", "translations"}) {
        QDirIterator files(QStringLiteral(SOURCE_DIR "/") + QLatin1String(folder),
                           {QStringLiteral("*.cpp"), QStringLiteral("*.h"), QStringLiteral("*.md"),
                            QStringLiteral("*.json"), QStringLiteral("*.ts")},
                           QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext()) {
            QFile file(files.next());
            if (file.open(QIODevice::ReadOnly))
                all += QString::fromUtf8(file.readAll());
        }
    }
    return all;
}

/// Those come from the system.
bool isChinese(QChar one)
{
    return one.unicode() >= 0x2e80;
}
} // namespace

class TestFonts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { gui::failOnWarnings(); }

    void systemHasNoneOfTheFonts()
    {
        QVERIFY(QFontDatabase::hasFamily(QStringLiteral("DejaVu Sans")));
        QVERIFY(!QFontDatabase::hasFamily(QStringLiteral("Noto Sans")));
    }

    void windowUsesBundledFont()
    {
        const double size = QApplication::font().pointSizeF();
        gui::MainWindowFixture fixture;
        for (const QWidget* widget : fixture.window->findChildren<QWidget*>())
            QCOMPARE(QFontInfo(widget->font()).family(), QStringLiteral("Noto Sans"));
        QFont bold = fixture.window->font();
        bold.setBold(true);
        QCOMPARE(QFontInfo(bold).family(), QStringLiteral("Noto Sans"));
        QCOMPARE(QFontInfo(bold).weight(), int(QFont::Bold));
        QCOMPARE(QApplication::font().pointSizeF(), size); // as the desktop has it
    }

    /// No empty boxes in an English window; if Chinese is selected the tooltip names the missing
    /// font.
    void chineseIsHiddenWithoutAFont()
    {
        gui::MainWindowFixture fixture;
        const auto* button = fixture.find<QAbstractButton>("languageButton");
        QCOMPARE(button->text(), QStringLiteral("EN / ZH"));
        QVERIFY(button->toolTip().contains(QStringLiteral("fonts-noto-cjk")));
        for (const QAction* action : fixture.context.commands.findChildren<QAction*>()) {
            const QString text = action->text();
            QVERIFY2(std::none_of(text.begin(), text.end(), isChinese), qPrintable(text));
        }
    }

    void digitsHaveEqualWidth()
    {
        for (const QString& family :
             {report::textFamilies().front(), report::codeFamilies().front()}) {
            const QFontMetricsF metrics{QFont(family)};
            for (const char16_t digit : u"123456789") {
                if (digit != 0)
                    QCOMPARE(metrics.horizontalAdvance(QChar(digit)),
                             metrics.horizontalAdvance(u'0'));
            }
        }
        const QFontMetricsF code{QFont(report::codeFamilies().front())};
        QCOMPARE(code.horizontalAdvance(u'W'), code.horizontalAdvance(u'i'));
    }

    void fontsHaveEverySymbol()
    {
        const QRawFont letters = QRawFont::fromFont(QFont(report::textFamilies().value(0)));
        const QRawFont signs = QRawFont::fromFont(QFont(report::textFamilies().value(1)));
        QString missing;
        const QString text = shownText();
        QVERIFY(text.contains(u'⚠') && text.contains(u'−'));
        for (const QChar one : text) {
            if (one.unicode() > 0x7e && !isChinese(one) && !missing.contains(one) &&
                !letters.supportsCharacter(one) && !signs.supportsCharacter(one))
                missing += one;
        }
        QCOMPARE(missing, QString());
    }

    /// A sign from another font makes no line higher.
    void symbolsKeepTheLineHeight()
    {
        const QFontMetricsF letters{QFont(report::textFamilies().value(0), 20)};
        const QFontMetricsF signs{QFont(report::textFamilies().value(1), 20)};
        QCOMPARE(signs.ascent(), letters.ascent());
        QCOMPARE(signs.descent(), letters.descent());
    }

    void codeInHelpIsMonospaced()
    {
        const gui::MainWindowFixture fixture;
        const ui::HelpWindow help(nullptr);
        int pieces = 0;
        const auto* text = help.findChild<QTextBrowser*>(QStringLiteral("helpText"));
        for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next()) {
            for (auto it = block.begin(); !it.atEnd(); ++it) {
                const QTextCharFormat format = it.fragment().charFormat();
                if (!format.fontFixedPitch())
                    continue;
                ++pieces;
                QCOMPARE(QFontInfo(format.font()).family(), QStringLiteral("Noto Sans Mono"));
            }
        }
        QVERIFY(pieces > 5);
    }
};

static int runTestFonts(int argc, char** argv)
{
    return support::runWithFonts<QApplication, TestFonts>(argc, argv, DEJAVU_FONTS);
}
SERVODESK_TEST_RUN(runTestFonts)
#include "tst_fonts.moc"
