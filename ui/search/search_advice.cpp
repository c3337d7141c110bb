// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/search/search_advice.h"

#include "session/session.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

// Q_INIT_RESOURCE must be outside every namespace.
static void initHelp()
{
    Q_INIT_RESOURCE(help);
}

namespace ui {
namespace {
using catalog::Text;

constexpr int firstId = 0;
constexpr int lastId = 253;

enum Row { NoneFoundSingle = 1, NoneFoundMultiple, SomeMissing, Garbled, LostAfterChange };

Text textFrom(const QJsonObject& item, const char* member)
{
    const QJsonObject both = item.value(QLatin1String(member)).toObject();
    return {both.value(QLatin1String("en")).toString(), both.value(QLatin1String("zh")).toString()};
}

Text withValue(const QJsonObject& item, const char* member, const QString& value = {})
{
    Text text = textFrom(item, member);
    for (QString* one : {&text.en, &text.zh})
        one->replace(QLatin1String("%1"), value);
    return text;
}

QJsonArray table()
{
    initHelp();
    QFile file(QStringLiteral(":/help/search_checklist.json"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return QJsonDocument::fromJson(file.readAll()).object().value(QLatin1String("rows")).toArray();
}

bool isSimulated(const SearchFacts& facts)
{
    return facts.port.name.startsWith(QLatin1String("sim:"));
}

bool allIds(const SearchFacts& facts)
{
    return !facts.report.stopped && facts.spec.firstId <= firstId && facts.spec.lastId >= lastId;
}

bool allRates(const SearchFacts& facts)
{
    const auto& known = session::standardBaudRates();
    const auto& searched = facts.report.rates;
    return !facts.report.stopped && facts.canSetBaud &&
           std::all_of(known.begin(), known.end(), [&](int rate) {
               return std::find(searched.begin(), searched.end(), rate) != searched.end();
           });
}

std::vector<base::Protocol> triedProtocols(const SearchFacts& facts)
{
    if (!facts.spec.protocols.empty())
        return facts.spec.protocols;
    if (facts.port.protocol)
        return {*facts.port.protocol};
    return facts.candidates;
}

bool allProtocols(const SearchFacts& facts)
{
    return !facts.report.stopped && triedProtocols(facts).size() == base::allProtocols.size();
}

QString ratesText(const std::vector<int>& rates)
{
    QStringList parts;
    for (const int rate : rates)
        parts << QString::number(rate);
    return parts.join(QStringLiteral(", "));
}

QString protocolsText(const SearchFacts& facts)
{
    QStringList parts;
    for (const base::Protocol protocol : triedProtocols(facts))
        parts << (protocol == base::Protocol::Feetech  ? QStringLiteral("Feetech")
                  : protocol == base::Protocol::Modbus ? QStringLiteral("Modbus")
                                                       : QStringLiteral("LX"));
    return parts.join(QStringLiteral(", "));
}

QString duplicateIdsText(const SearchFacts& facts)
{
    QStringList ids;
    for (const jobs::FoundServo& found : facts.report.found) {
        if (found.duplicateSuspected)
            ids << QString::number(found.servo.id);
    }
    return ids.join(QStringLiteral(", "));
}

/// The finding of the search about one cause: ruled out, indicated, or nothing.
struct Verdict {
    bool ruledOut = false;
    std::optional<QString> finding; ///< fills the sentence
};

Verdict verdictIf(bool so, const QString& value = {}, const std::optional<QString>& hint = {})
{
    return so ? Verdict{true, value} : Verdict{false, hint};
}

Verdict sameId(const SearchFacts& facts, int row)
{
    const QString twins = duplicateIdsText(facts);
    if (row == NoneFoundMultiple)
        return {false, facts.report.hasGarbledReplies ? std::optional(QString()) : std::nullopt};
    return {false, twins.isEmpty() ? std::nullopt : std::optional(twins)};
}

Verdict findingFromSearch(const SearchFacts& facts, const QString& key, int row)
{
    const auto& report = facts.report;
    const QString rateCount = QString::number(session::standardBaudRates().size());
    if (key == QLatin1String("ids"))
        return verdictIf(allIds(facts), {},
                         QStringLiteral("%1–%2").arg(facts.spec.firstId).arg(facts.spec.lastId));
    if (key == QLatin1String("rate"))
        return verdictIf(allRates(facts), rateCount,
                         report.rates.empty() || !facts.canSetBaud
                             ? std::nullopt
                             : std::optional(ratesText(report.rates)));
    if (key == QLatin1String("protocol"))
        return verdictIf(allProtocols(facts), {}, protocolsText(facts));
    if (key == QLatin1String("late"))
        return verdictIf(report.lateReplies == 0, {}, QString::number(report.lateReplies));
    if (key == QLatin1String("rate_off") && !report.unsupportedRates.empty())
        return {false, ratesText(report.unsupportedRates)};
    if (key == QLatin1String("old"))
        return verdictIf(allIds(facts) && allRates(facts), rateCount);
    if (key == QLatin1String("same_id"))
        return sameId(facts, row);
    return {};
}

Verdict verdictFor(const SearchFacts& facts, const QString& key, int row)
{
    static const QStringList ruledOutKeys{QStringLiteral("level"), QStringLiteral("echo"),
                                          QStringLiteral("driver")};
    static const QStringList manualChecks{
        QStringLiteral("port"),    QStringLiteral("adapter_supply"), QStringLiteral("supply"),
        QStringLiteral("lead"),    QStringLiteral("damaged"),        QStringLiteral("drop"),
        QStringLiteral("blocked"), QStringLiteral("noise"),          QStringLiteral("line")};
    if (ruledOutKeys.contains(key)) // a search needs an open port
        return {true, QString()};
    if (manualChecks.contains(key))
        return verdictIf(isSimulated(facts));
    if (key == QLatin1String("holder"))
        return verdictIf(isSimulated(facts), {},
                         facts.otherPrograms.isEmpty() ? std::nullopt
                                                       : std::optional(facts.otherPrograms));
    if (key == QLatin1String("locked"))
        return verdictIf(facts.history.idOrBaudChanged);
    return findingFromSearch(facts, key, row);
}

bool matches(const SearchFacts& facts, int row)
{
    const bool nobody = facts.report.found.empty();
    switch (row) {
    case NoneFoundSingle:
    case NoneFoundMultiple:
        return nobody;
    case SomeMissing:
        return !nobody;
    case Garbled:
        return facts.report.hasGarbledReplies || !duplicateIdsText(facts).isEmpty();
    case LostAfterChange:
        return facts.history.idOrBaudChanged || facts.history.lostServos > 0;
    default:
        return false;
    }
}

/// Observed facts come before possible causes.
int sortPriority(const AdviceRow& row)
{
    if (!row.matches)
        return 2;
    return row.number == Garbled || row.number == LostAfterChange ? 0 : 1;
}
} // namespace

SearchFacts searchFacts(const session::Workbench& workbench, const SearchHistory& history)
{
    SearchFacts facts;
    facts.spec = workbench.search().lastSpec();
    facts.report = workbench.search().lastReport().value_or(jobs::ScanReport{});
    facts.port = workbench.link().lastRequest();
    facts.canSetBaud =
        workbench.link().canSetBaud() || workbench.link().state() != session::LinkState::Open;
    facts.history = history;
    facts.otherPrograms = workbench.search().otherPrograms();
    for (const base::Protocol protocol : base::allProtocols) {
        const auto isPossibleAt = [&](int rate) {
            const auto met = workbench.catalog().protocolsAt(rate);
            return std::find(met.begin(), met.end(), protocol) != met.end();
        };
        const auto& rates = facts.report.rates;
        if (!facts.canSetBaud || std::any_of(rates.begin(), rates.end(), isPossibleAt))
            facts.candidates.push_back(protocol);
    }
    return facts;
}

std::vector<AdviceRow> searchAdvice(const SearchFacts& facts)
{
    std::vector<AdviceRow> rows;
    for (const QJsonValue& value : table()) {
        const QJsonObject object = value.toObject();
        AdviceRow row;
        row.number = object.value(QLatin1String("number")).toInt();
        row.symptom = textFrom(object, "symptom");
        row.matches = matches(facts, row.number);
        for (const QJsonValue& each : object.value(QLatin1String("items")).toArray()) {
            const QJsonObject item = each.toObject();
            const QString key = item.value(QLatin1String("key")).toString();
            const Verdict verdict = verdictFor(facts, key, row.number);
            Text finding;
            if (verdict.finding)
                finding =
                    withValue(item, verdict.ruledOut ? "ruled_out" : "hint", *verdict.finding);
            row.items.push_back(
                {key, textFrom(item, "cause"), textFrom(item, "check"), finding, verdict.ruledOut});
        }
        rows.push_back(std::move(row));
    }
    std::stable_sort(rows.begin(), rows.end(), [](const AdviceRow& a, const AdviceRow& b) {
        return sortPriority(a) < sortPriority(b);
    });
    return rows;
}

bool canSearchWider(const SearchFacts& facts)
{
    return !allIds(facts) || !allProtocols(facts) || (facts.canSetBaud && !allRates(facts));
}
} // namespace ui
