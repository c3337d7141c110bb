// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/program.h"

#include "report/fonts.h"
#include "text/front_end.h"
#include "ui/app/main_window.h"
#include "ui/app/plain_text_filter.h"
#include "ui/app/self_test.h"
#include "ui/common/language_switch.h"
#include "ui/common/theme.h"

#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QIcon>
#include <QPixmap>
#include <QTemporaryDir>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <optional>

static void initResources()
{
    Q_INIT_RESOURCE(icons);
    Q_INIT_RESOURCE(help);
}

namespace ui {
namespace {
constexpr int badOptions = 2;

void print(FILE* stream, const QString& text)
{
    std::fputs(text.toLocal8Bit().constData(), stream);
}

void screenshotLater(MainWindow& window, const Options& options)
{
    if (options.screenshot.isEmpty())
        return;
    QTimer::singleShot(options.afterMs, &window, [&window, file = options.screenshot] {
        const char* format = QFileInfo(file).suffix().isEmpty() ? "PNG" : nullptr;
        const bool saved = window.grab().save(file, format);
        if (!saved)
            print(stderr, QStringLiteral("%1: the screenshot could not be written\n").arg(file));
        QCoreApplication::exit(saved ? 0 : 1);
    });
}

/// Help and version must work without a display, so without a QApplication.
bool printedHelp(int argc, char* argv[])
{
    const bool asked = std::any_of(argv + 1, argv + argc, [](const char* word) {
        const QLatin1String option(word);
        return option == QLatin1String("--help") || option == QLatin1String("-h") ||
               option == QLatin1String("--help-all") || option == QLatin1String("--version") ||
               option == QLatin1String("-v");
    });
    if (!asked)
        return false;
    const QCoreApplication app(argc, argv);
    LanguageSwitch language;
    language.apply({});
    const ParsedOptions parsed = parseOptions(QCoreApplication::arguments());
    print(stdout, parsed.print);
    return !parsed.print.isEmpty();
}

/// The program's own font in the size of the desktop's font.
void useOwnFont()
{
    QFont font = QApplication::font();
    if (const QStringList families = report::textFamilies(); !families.isEmpty())
        font.setFamilies(families);
    QApplication::setFont(font);
}
} // namespace

void initProgram()
{
    initResources();
    text::setFrontEnd(text::FrontEnd::Window);
    QIcon::setThemeSearchPaths(QIcon::themeSearchPaths() << QStringLiteral(":/icons"));
    QIcon::setFallbackThemeName(QStringLiteral("breeze"));
    PlainTextFilter::install();
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/servodesk.svg")));
    useOwnFont();
}

int runProgram(int argc, char* argv[])
{
    QCoreApplication::setApplicationName(QStringLiteral("servodesk"));
    QCoreApplication::setApplicationVersion(QStringLiteral(SERVODESK_VERSION));
    if (printedHelp(argc, argv))
        return 0;
    QApplication app(argc, argv);
    initProgram();

    LanguageSwitch language;
    language.apply({});
    const ParsedOptions parsed = parseOptions(QApplication::arguments());
    if (!parsed.error.isEmpty()) {
        print(stderr, QStringLiteral("servodesk: %1\n").arg(parsed.error));
        return badOptions;
    }
    if (!parsed.print.isEmpty()) { // beside options of Qt's own, which only QApplication takes out
        print(stdout, parsed.print);
        return 0;
    }
    const Options& options = parsed.options;
    std::optional<QTemporaryDir> ownData; // of the self test
    if (options.isSelfTest) {
        ownData.emplace();
        if (!ownData->isValid()) {
            print(stderr, QStringLiteral("servodesk: %1: %2\n")
                              .arg(QDir::tempPath(), ownData->errorString()));
            return 1;
        }
        for (const char* folder : {"SERVODESK_DATA_DIR", "XDG_CONFIG_HOME"})
            qputenv(folder, QFile::encodeName(ownData->path()));
        QApplication::setQuitOnLastWindowClosed(false); // it would look like success
    }
    session::Settings settings;
    language.apply(options.language.isEmpty() ? settings.language() : options.language);
    ThemeSwitch theme;
    theme.apply(options.theme.value_or(settings.theme()));
    session::Session session;
    AppContext appContext(session);
    MainWindow window(appContext, settings, theme, language);
    window.show();
    std::optional<SelfTest> selfTest;
    if (options.isSelfTest) {
        selfTest.emplace(appContext, window, ownData->path());
        selfTest->start();
    } else {
        window.start(options);
        screenshotLater(window, options);
    }
    return QApplication::exec();
}
} // namespace ui
