// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/language.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <QTranslator>

#include <memory>
#include <optional>

// The compiler would drop the resource of a static library otherwise. Not allowed in a namespace.
static void initTranslations()
{
    Q_INIT_RESOURCE(translations);
}

namespace text {
namespace {
const QString english = QStringLiteral("en");
const QString chinese = QStringLiteral("zh_CN");

std::optional<QString> spoken(const QString& language)
{
    const QString name = language.left(2).toLower();
    if (name == QLatin1String("zh"))
        return chinese;
    if (name == QLatin1String("en"))
        return english;
    return std::nullopt;
}

// Owned here, because it must go before the next one is installed.
std::unique_ptr<QTranslator>& installed()
{
    static std::unique_ptr<QTranslator> translator;
    return translator;
}
} // namespace

QString systemLanguage()
{
    for (const QString& language : QLocale::system().uiLanguages()) {
        if (const auto known = spoken(language))
            return *known;
    }
    return english;
}

QString installTranslator(const QString& language)
{
    initTranslations();
    const QString chosen =
        language.isEmpty() ? systemLanguage() : spoken(language).value_or(english);
    installed().reset();
    if (chosen == chinese) {
        auto translator = std::make_unique<QTranslator>();
        if (translator->load(QStringLiteral(":/i18n/servodesk_zh_CN.qm")))
            QCoreApplication::installTranslator(translator.get());
        installed() = std::move(translator);
    }
    return chosen;
}

bool isUiChinese()
{
    return installed() != nullptr;
}
} // namespace text
