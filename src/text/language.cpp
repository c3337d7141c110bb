// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/language.h"

#include "catalog/profile.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>
#include <QTranslator>

#include <memory>
#include <optional>

// Without this the linker drops the resource of a static library. Not allowed in a namespace.
static void initTranslations()
{
    Q_INIT_RESOURCE(translations);
}

namespace text {
namespace {
const QString english = QStringLiteral("en");
const QString chinese = QStringLiteral("zh_CN");

QString fileOf(const QString& language)
{
    return QStringLiteral(":/i18n/servodesk_%1.qm").arg(language);
}

std::optional<QString> supported(const QString& language)
{
    const QString name = language.left(2).toLower();
    if (name == QLatin1String("zh"))
        return chinese;
    if (name == QLatin1String("en"))
        return english;
    return std::nullopt;
}

/// Removed before the next one is installed.
std::unique_ptr<QTranslator>& installed()
{
    static std::unique_ptr<QTranslator> translator;
    return translator;
}
} // namespace

QString systemLanguage()
{
    for (const QString& language : QLocale::system().uiLanguages()) {
        if (const auto known = supported(language))
            return *known;
    }
    return english;
}

QString installTranslator(const QString& language)
{
    initTranslations();
    const QString chosen =
        language.isEmpty() ? systemLanguage() : supported(language).value_or(english);
    installed().reset();
    auto translator = std::make_unique<QTranslator>(); // for English: only plurals
    if (translator->load(fileOf(chosen)))
        QCoreApplication::installTranslator(translator.get());
    installed() = std::move(translator);
    return chosen;
}

bool isUiChinese()
{
    return installed() != nullptr && installed()->language() == chinese;
}

QString inChinese(const char* context, const char* source, const char* comment)
{
    static const std::unique_ptr<const QTranslator> translator = [] {
        initTranslations();
        auto loaded = std::make_unique<QTranslator>();
        (void)loaded->load(fileOf(chinese));
        return loaded;
    }();
    return translator->translate(context, source, comment);
}

QString localized(const catalog::Text& text)
{
    return text.in(isUiChinese());
}

QString capitalized(QString sentence)
{
    if (!sentence.isEmpty())
        sentence[0] = sentence[0].toUpper();
    return sentence;
}

QString joinSentences(QStringList sentences)
{
    sentences.removeAll(QString());
    return sentences.join(isUiChinese() ? QString() : QStringLiteral(" "));
}

QString joinItems(const QStringList& items)
{
    return items.join(isUiChinese() ? QStringLiteral("、") : QStringLiteral(", "));
}

QString joinClauses(const QStringList& clauses)
{
    return clauses.join(isUiChinese() ? QStringLiteral("；") : QStringLiteral("; "));
}

QString registerName(const catalog::Profile* profile, const QString& key)
{
    const catalog::Register* reg = profile != nullptr ? profile->find(key) : nullptr;
    return reg != nullptr ? localized(reg->name) : key;
}
} // namespace text
