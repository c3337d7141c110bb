// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/history_input.h"

#include "cli/input/arguments.h"
#include "cli/translate.h"
#include "session/paths.h"

#include <QFile>
#include <QRegularExpression>

namespace cli {
namespace {
constexpr int defaultRows = 200;
constexpr int maxRows = 1'000'000;

std::optional<QDateTime> ago(const QString& word, const QDateTime& now)
{
    static const QRegularExpression expression(QStringLiteral("^(\\d{1,6})([mhdw])$"));
    const auto match = expression.match(word);
    if (!match.hasMatch())
        return std::nullopt;
    constexpr qint64 minute = 60;
    const QChar unit = match.captured(2).front();
    const qint64 seconds = unit == QLatin1Char('m')   ? minute
                           : unit == QLatin1Char('h') ? 60 * minute
                           : unit == QLatin1Char('d') ? 24 * 60 * minute
                                                      : 7 * 24 * 60 * minute;
    return now.addSecs(-match.captured(1).toLongLong() * seconds);
}

/// Sets `into` if the option was given.
template <typename Parse, typename Value>
base::Result<void> takeOption(const Values& values, const char* flag, const Parse& parse,
                              Value& into)
{
    const auto word = values.option(flag);
    if (!word)
        return {};
    const auto parsed = parse(*word);
    if (!parsed)
        return tl::unexpected(parsed.error());
    into = *parsed;
    return {};
}

base::Result<void> takeFilter(const history::History* history, const Values& values,
                              history::HistoryFilter& filter)
{
    const auto time = [now = QDateTime::currentDateTimeUtc()](const QString& word) {
        return parseDateTime(word, now);
    };
    const auto limit = [](const QString& word) { return parseInt(word, 1, maxRows); };
    if (const auto id = takeOption(values, "--id", parseId, filter.id); !id)
        return id;
    if (const auto rows = takeOption(values, "--limit", limit, filter.limit); !rows)
        return rows;
    if (const auto from = takeOption(values, "--since", time, filter.from); !from)
        return from;
    if (const auto until = takeOption(values, "--until", time, filter.until); !until)
        return until;
    if (history == nullptr)
        return {};
    const auto servo = [&](const QString& word) { return parseServo(*history, word); };
    return takeOption(values, "--servo", servo, filter.servo);
}
} // namespace

std::vector<Option> historyOptions()
{
    return {
        {"--servo",
         QT_TRANSLATE_NOOP(
             "cli",
             "only this servo: its label, or its number as listed by \"history --kind servos\""),
         "SERVO"},
        {"--id", QT_TRANSLATE_NOOP("cli", "only servos with this ID"), "ID"},
        {"--model", QT_TRANSLATE_NOOP("cli", "only servos of this model"), "MODEL"},
        {"--label", QT_TRANSLATE_NOOP("cli", "only servos with this label"), "LABEL"},
        {"--since",
         QT_TRANSLATE_NOOP("cli", "only entries since this time: 2026-11-22, 2026-11-22T10:30, "
                                  "10:30, or an age such as 90m, 2h, 3d, 1w"),
         "TIME"},
        {"--until", QT_TRANSLATE_NOOP("cli", "only entries before this time"), "TIME"},
        {"--register", QT_TRANSLATE_NOOP("cli", "only entries for writes to this register"), "KEY"},
        {"--problems",
         QT_TRANSLATE_NOOP("cli", "only writes that failed and alarms that are still active")},
        {"--limit", QT_TRANSLATE_NOOP("cli", "maximum number of rows, newest first (default: 200)"),
         "N"},
    };
}

base::Result<std::unique_ptr<history::History>> openHistory()
{
    const QString path = session::historyFile();
    if (!QFile::exists(path))
        return nullptr;
    return history::History::open(path);
}

base::Result<history::HistoryFilter> historyFilter(const history::History* history,
                                                   const Values& values)
{
    history::HistoryFilter filter;
    filter.model = values.option("--model").value_or(QString());
    filter.label = values.option("--label").value_or(QString());
    filter.key = values.option("--register").value_or(QString());
    filter.onlyProblems = values.has("--problems");
    filter.limit = defaultRows;
    if (const auto taken = takeFilter(history, values, filter); !taken)
        return tl::unexpected(taken.error());
    return filter;
}

base::Result<QDateTime> parseDateTime(const QString& word, const QDateTime& now)
{
    if (const auto at = ago(word, now))
        return *at;
    const QTime time = QTime::fromString(word, QStringLiteral("H:mm"));
    if (time.isValid())
        return QDateTime(now.toLocalTime().date(), time).toUTC();
    const QDate date = QDate::fromString(word, Qt::ISODate);
    if (date.isValid() && word.size() <= 10)
        return date.startOfDay().toUTC();
    const QDateTime at = QDateTime::fromString(
        QString(word).replace(QLatin1Char(' '), QLatin1Char('T')), Qt::ISODateWithMs);
    if (!at.isValid())
        return badArgument(
            translate("cli", "\"%1\" is not a valid time; examples: 2026-11-22, 2026-11-22T10:30, "
                             "10:30, or an age such as 90m, 2h, 3d, 1w")
                .arg(word));
    return at.toUTC();
}

base::Result<std::int64_t> parseServo(const history::History& history, const QString& word)
{
    history::HistoryFilter filter;
    bool isNumber = false;
    const bool hasSign = word.startsWith(QLatin1Char('#')); // "#3", as in the output
    const qint64 number = word.mid(hasSign ? 1 : 0).toLongLong(&isNumber);
    if (isNumber)
        filter.servo = number;
    else
        filter.label = word;
    const auto found = history.log().servos(filter);
    if (!found)
        return tl::unexpected(found.error());
    if (found->size() == 1)
        return found->front().number;
    if (found->empty())
        return badArgument(translate("cli", "no servo \"%1\" in the history; \"history --kind "
                                            "servos\" lists all servos")
                               .arg(word));
    return badArgument(translate("cli", "several servos have the label \"%1\"; specify a number "
                                        "instead, as listed by \"history --kind servos\"")
                           .arg(word));
}

base::Result<void> loadProfiles(const history::History& history, history::HistoryProfiles& profiles)
{
    history::HistoryFilter all;
    all.limit = maxRows;
    const auto servos = history.log().servos(all);
    if (!servos)
        return tl::unexpected(servos.error());
    profiles.add(*servos);
    return {};
}
} // namespace cli
