// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/fonts.h"

#include <QFile>
#include <QFontDatabase>

// Q_INIT_RESOURCE must stand outside every namespace; without it the linker drops the resources of
// a static library.
static void initFontsResource()
{
    Q_INIT_RESOURCE(fonts);
}

namespace report {
namespace {
/// The order matters: without a language, fontconfig proposes the Japanese shapes first.
QStringList chineseFamilies()
{
    return {QStringLiteral("Noto Sans CJK SC"),   QStringLiteral("Noto Sans SC"),
            QStringLiteral("Source Han Sans SC"), QStringLiteral("Microsoft YaHei"),
            QStringLiteral("PingFang SC"),        QStringLiteral("WenQuanYi Micro Hei"),
            QStringLiteral("WenQuanYi Zen Hei"),  QStringLiteral("Droid Sans Fallback"),
            QStringLiteral("AR PL UMing CN"),     QStringLiteral("AR PL UKai CN")};
}

void registerFonts()
{
    initFontsResource();
    for (const char* file : {"NotoSans-Regular.ttf", "NotoSans-Bold.ttf",
                             "NotoSansMono-Regular.ttf", "ServoDeskSymbols-Regular.ttf"})
        QFontDatabase::addApplicationFont(QStringLiteral(":/fonts/") + QLatin1String(file));
}

QStringList presentFamilies(const QString& first)
{
    static const bool registered = (registerFonts(), true);
    Q_UNUSED(registered)
    const QStringList present = QFontDatabase::families();
    QStringList families;
    for (const QString& family :
         QStringList{first, QStringLiteral("ServoDesk Symbols")} + chineseFamilies()) {
        if (present.contains(family))
            families << family;
    }
    return families;
}

QString fontFace(const char* family, int weight, const char* file)
{
    initFontsResource();
    QFile font(QStringLiteral(":/fonts/") + QLatin1String(file));
    if (!font.open(QIODevice::ReadOnly))
        return {};
    return QStringLiteral("@font-face { font-family: \"%1\"; font-weight: %2; "
                          "src: url(data:font/woff2;base64,%3) format(\"woff2\"); }\n")
        .arg(QLatin1String(family))
        .arg(weight)
        .arg(QLatin1String(font.readAll().toBase64()));
}
} // namespace

QStringList textFamilies()
{
    static const QStringList families = presentFamilies(QStringLiteral("Noto Sans"));
    return families;
}

QStringList codeFamilies()
{
    static const QStringList families = presentFamilies(QStringLiteral("Noto Sans Mono"));
    return families;
}

QString embeddedFonts()
{
    return fontFace("ServoDesk Text", 400, "report-regular.woff2") +
           fontFace("ServoDesk Text", 700, "report-bold.woff2") +
           fontFace("ServoDesk Signs", 400, "report-symbols.woff2");
}
} // namespace report
