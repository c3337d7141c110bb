// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/options.h"

#include "text/translate.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>

namespace ui {
namespace {
// clang-format off
struct OptionRow {
    const char* name;
    const char* help;
    const char* value;
};
constexpr OptionRow rows[] = {
    {"port", QT_TRANSLATE_NOOP("Options", "port to open and search: device path, tcp://HOST:PORT or sim:demo"), "PORT"},
    {"baud", QT_TRANSLATE_NOOP("Options", "baud rate of the port, or auto"), "RATE"},
    {"protocol", QT_TRANSLATE_NOOP("Options", "protocol: auto, feetech, modbus or lx"), "NAME"},
    {"lang", QT_TRANSLATE_NOOP("Options", "language of the interface: en or zh_CN"), "LANGUAGE"},
    {"theme", QT_TRANSLATE_NOOP("Options", "color theme: system, light or dark"), "THEME"},
    {"page", QT_TRANSLATE_NOOP("Options", "page to show: operate, memory, sweep, step, snapshots, commission, arm, firmware, history"), "PAGE"},
    {"select", QT_TRANSLATE_NOOP("Options", "ID of the servo to select"), "ID"},
    {"screenshot", QT_TRANSLATE_NOOP("Options", "save a screenshot of the window to this PNG file and quit"), "FILE"},
    {"size", QT_TRANSLATE_NOOP("Options", "window size, for example 1280x800"), "SIZE"},
    {"after", QT_TRANSLATE_NOOP("Options", "delay before the screenshot, in milliseconds"), "MS"},
    {"self-test", QT_TRANSLATE_NOOP("Options", "try the program on a simulated bus, with data of its own, and quit"), nullptr},
};
// clang-format on

/// A whole number of at least `min`; reports an error otherwise.
std::optional<int> number(const QCommandLineParser& parser, const char* option, int min,
                          QString& error)
{
    const QString given = parser.value(QString::fromLatin1(option));
    if (given.isEmpty())
        return std::nullopt;
    bool sound = false;
    const int value = given.toInt(&sound);
    if (sound && value >= min)
        return value;
    error = text::translate("Options", "--%1: \"%2\" is not a valid number")
                .arg(QLatin1String(option), given);
    return std::nullopt;
}

void takePort(const QCommandLineParser& parser, ParsedOptions& parsed)
{
    session::PortRequest request;
    request.name = parser.value(QStringLiteral("port"));
    if (parser.value(QStringLiteral("baud")) != QLatin1String("auto"))
        request.baud = number(parser, "baud", 1, parsed.error);
    const QString protocol = parser.value(QStringLiteral("protocol"));
    if (!protocol.isEmpty() && protocol != QLatin1String("auto")) {
        request.protocol = base::protocolFromName(protocol);
        if (!request.protocol)
            parsed.error =
                text::translate("Options", "--protocol: unknown value \"%1\"").arg(protocol);
    }
    if (!request.name.isEmpty())
        parsed.options.port = request;
}

void takeSize(const QString& size, ParsedOptions& parsed)
{
    static const QRegularExpression shape(QStringLiteral("^(\\d{3,4})x(\\d{3,4})$"));
    const auto match = shape.match(size);
    if (match.hasMatch())
        parsed.options.size = {match.captured(1).toInt(), match.captured(2).toInt()};
    else if (!size.isEmpty())
        parsed.error =
            text::translate("Options",
                            "--size: \"%1\" is not a valid window size (for example, 1280x800)")
                .arg(size);
}

void takeTheme(const QString& theme, ParsedOptions& parsed)
{
    if (theme == QLatin1String("system"))
        parsed.options.theme = session::Theme::System;
    else if (theme == QLatin1String("light"))
        parsed.options.theme = session::Theme::Light;
    else if (theme == QLatin1String("dark"))
        parsed.options.theme = session::Theme::Dark;
    else if (!theme.isEmpty())
        parsed.error = text::translate("Options", "--theme: unknown value \"%1\"").arg(theme);
}
} // namespace

ParsedOptions parseOptions(const QStringList& arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        text::translate("Options", "Setup and test program for serial bus servos"));
    for (const OptionRow& row : rows)
        parser.addOption({QString::fromLatin1(row.name), text::translate("Options", row.help),
                          QString::fromLatin1(row.value)});
    parser.addPositionalArgument(
        QStringLiteral("FILE"),
        text::translate("Options", "snapshots, bundles and recordings to open"),
        QStringLiteral("[FILE...]"));
    const QCommandLineOption help = parser.addHelpOption();
    const QCommandLineOption version = parser.addVersionOption();
    ParsedOptions parsed;
    if (!parser.parse(arguments)) {
        parsed.error = parser.errorText();
        return parsed;
    }
    if (parser.isSet(help) || parser.isSet(QStringLiteral("help-all")))
        parsed.print = parser.helpText();
    else if (parser.isSet(version))
        parsed.print = QStringLiteral("servodesk %1\n").arg(QCoreApplication::applicationVersion());
    Options& options = parsed.options;
    options.files = parser.positionalArguments();
    for (const QString& file : options.files) {
        if (!QFileInfo::exists(file))
            parsed.error = text::translate("Options", "%1: no such file").arg(file);
    }
    options.isSelfTest = parser.isSet(QStringLiteral("self-test"));
    takeSize(parser.value(QStringLiteral("size")), parsed);
    takePort(parser, parsed);
    takeTheme(parser.value(QStringLiteral("theme")), parsed);
    options.language = parser.value(QStringLiteral("lang"));
    options.page = parser.value(QStringLiteral("page"));
    const QStringList pages{QStringLiteral("operate"),   QStringLiteral("memory"),
                            QStringLiteral("sweep"),     QStringLiteral("step"),
                            QStringLiteral("snapshots"), QStringLiteral("commission"),
                            QStringLiteral("arm"),       QStringLiteral("firmware"),
                            QStringLiteral("history"),   QString()};
    if (!pages.contains(options.page))
        parsed.error = text::translate("Options", "--page: unknown value \"%1\"").arg(options.page);
    options.select = number(parser, "select", 0, parsed.error);
    options.screenshot = parser.value(QStringLiteral("screenshot"));
    options.afterMs = number(parser, "after", 0, parsed.error).value_or(options.afterMs);
    return parsed;
}
} // namespace ui
