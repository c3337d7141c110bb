// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/history_input.h"

#include "cli/input/arguments.h"
#include "cli/translate.h"
#include "history/journal_import.h"
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

base::Result<void> takeTimes(record::HistoryFilter& filter, const Values& values)
{
    const QDateTime now = QDateTime::currentDateTimeUtc();
    if (const auto word = values.option("--since")) {
        const auto at = parseDateTime(*word, now);
        if (!at)
            return tl::unexpected(at.error());
        filter.from = *at;
    }
    if (const auto word = values.option("--until")) {
        const auto at = parseDateTime(*word, now);
        if (!at)
            return tl::unexpected(at.error());
        filter.until = *at;
    }
    return {};
}
} // namespace

std::vector<Option> historyOptions()
{
    return {
        {"--servo",
         QT_TRANSLATE_NOOP("cli", "only this one: its number in \"history --kind servos\", or its "
                                  "label"),
         "SERVO"},
        {"--id", QT_TRANSLATE_NOOP("cli", "only with this ID"), "ID"},
        {"--model", QT_TRANSLATE_NOOP("cli", "only servos of this model"), "MODEL"},
        {"--label", QT_TRANSLATE_NOOP("cli", "only with this label"), "LABEL"},
        {"--since",
         QT_TRANSLATE_NOOP("cli", "only from then on: 2026-11-22, 2026-11-22T10:30, 10:30, or 90m, "
                                  "2h, 3d, 1w ago"),
         "TIME"},
        {"--until", QT_TRANSLATE_NOOP("cli", "only before then"), "TIME"},
        {"--register", QT_TRANSLATE_NOOP("cli", "only writes to this register"), "KEY"},
        {"--trouble",
         QT_TRANSLATE_NOOP("cli", "only writes that did not end well, alarms that have not gone")},
        {"--most", QT_TRANSLATE_NOOP("cli", "so many rows, the newest (usual: 200)"), "N"},
    };
}

base::Result<std::unique_ptr<record::History>> openHistory()
{
    const QString path = session::historyFile();
    if (!QFile::exists(path) && !QFile::exists(record::legacyJournalPath(path)))
        return nullptr;
    return record::History::open(path);
}

base::Result<record::HistoryFilter> historyFilter(const record::History* history,
                                                  const Values& values)
{
    record::HistoryFilter filter;
    filter.model = values.option("--model").value_or(QString());
    filter.label = values.option("--label").value_or(QString());
    filter.key = values.option("--register").value_or(QString());
    filter.onlyProblems = values.has("--trouble");
    filter.limit = defaultRows;
    if (const auto word = values.option("--id")) {
        const auto id = parseId(*word);
        if (!id)
            return tl::unexpected(id.error());
        filter.id = *id;
    }
    if (const auto word = values.option("--most")) {
        const auto limit = parseInt(*word, 1, maxRows);
        if (!limit)
            return tl::unexpected(limit.error());
        filter.limit = *limit;
    }
    if (const auto times = takeTimes(filter, values); !times)
        return tl::unexpected(times.error());
    if (const auto word = values.option("--servo"); word && history != nullptr) {
        const auto servo = parseServo(*history, *word);
        if (!servo)
            return tl::unexpected(servo.error());
        filter.servo = *servo;
    }
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
        return badArgument(translate("cli", "\"%1\" is no time: 2026-11-22, 2026-11-22T10:30, "
                                            "10:30, or 90m, 2h, 3d, 1w ago")
                               .arg(word));
    return at.toUTC();
}

base::Result<std::int64_t> parseServo(const record::History& history, const QString& word)
{
    record::HistoryFilter filter;
    bool isNumber = false;
    const qint64 number = word.toLongLong(&isNumber);
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
        return badArgument(translate("cli", "the history knows no servo \"%1\"; \"history --kind "
                                            "servos\" lists them")
                               .arg(word));
    return badArgument(translate("cli", "several servos have the label \"%1\"; give the number of "
                                        "one: \"history --kind servos\" lists them")
                           .arg(word));
}

base::Result<void> loadProfiles(const record::History& history, record::HistoryProfiles& profiles)
{
    record::HistoryFilter all;
    all.limit = maxRows;
    const auto servos = history.log().servos(all);
    if (!servos)
        return tl::unexpected(servos.error());
    profiles.add(*servos);
    return {};
}
} // namespace cli
