// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/search_advice.h"

#include "session/session.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

// Q_INIT_RESOURCE must stand outside every namespace.
static void initHelp()
{
    Q_INIT_RESOURCE(help);
}

namespace ui {
namespace {
using catalog::Text;

constexpr int firstId = 0;
constexpr int lastId = 253;

enum Row { NothingOne = 1, NothingSeveral, OnlySome, Garbled, GoneAfterChange };

Text textIn(const QJsonObject& item, const char* member)
{
    const QJsonObject both = item.value(QLatin1String(member)).toObject();
    return {both.value(QLatin1String("en")).toString(), both.value(QLatin1String("zh")).toString()};
}

Text filled(const QJsonObject& item, const char* member, const QString& value = {})
{
    Text text = textIn(item, member);
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
    const auto& known = session::knownRates();
    const auto& searched = facts.report.rates;
    return !facts.report.stopped && facts.hasBaud &&
           std::all_of(known.begin(), known.end(), [&](int rate) {
               return std::find(searched.begin(), searched.end(), rate) != searched.end();
           });
}

std::vector<base::Protocol> protocolsTried(const SearchFacts& facts)
{
    if (!facts.spec.protocols.empty())
        return facts.spec.protocols;
    if (facts.port.protocol)
        return {*facts.port.protocol};
    return facts.possible;
}

bool allProtocols(const SearchFacts& facts)
{
    return !facts.report.stopped && protocolsTried(facts).size() == base::allProtocols.size();
}

QString ratesText(const std::vector<int>& rates)
{
    QStringList words;
    for (const int rate : rates)
        words << QString::number(rate);
    return words.join(QStringLiteral(", "));
}

QString protocolsText(const SearchFacts& facts)
{
    QStringList words;
    for (const base::Protocol protocol : protocolsTried(facts))
        words << (protocol == base::Protocol::Feetech  ? QStringLiteral("Feetech")
                  : protocol == base::Protocol::Modbus ? QStringLiteral("Modbus")
                                                       : QStringLiteral("LX"));
    return words.join(QStringLiteral(", "));
}

QString twinsText(const SearchFacts& facts)
{
    QStringList ids;
    for (const jobs::Found& found : facts.report.found) {
        if (found.twinsSuspected)
            ids << QString::number(found.servo.id);
    }
    return ids.join(QStringLiteral(", "));
}

/// What the search says of one cause: ruled out, pointed at, or nothing.
struct Verdict {
    bool ruledOut = false;
    std::optional<QString> finding; ///< fills the sentence
};

Verdict ruledOutIf(bool so, const QString& value = {}, const std::optional<QString>& hint = {})
{
    return so ? Verdict{true, value} : Verdict{false, hint};
}

Verdict sameId(const SearchFacts& facts, int row)
{
    const QString twins = twinsText(facts);
    if (row == NothingSeveral)
        return {false, facts.report.garbledHeard ? std::optional(QString()) : std::nullopt};
    return {false, twins.isEmpty() ? std::nullopt : std::optional(twins)};
}

Verdict ofTheSearch(const SearchFacts& facts, const QString& key, int row)
{
    const auto& report = facts.report;
    const QString rateCount = QString::number(session::knownRates().size());
    if (key == QLatin1String("ids"))
        return ruledOutIf(allIds(facts), {},
                          QStringLiteral("%1–%2").arg(facts.spec.firstId).arg(facts.spec.lastId));
    if (key == QLatin1String("rate"))
        return ruledOutIf(allRates(facts), rateCount,
                          report.rates.empty() || !facts.hasBaud
                              ? std::nullopt
                              : std::optional(ratesText(report.rates)));
    if (key == QLatin1String("protocol"))
        return ruledOutIf(allProtocols(facts), {}, protocolsText(facts));
    if (key == QLatin1String("late"))
        return ruledOutIf(report.lateReplies == 0, {}, QString::number(report.lateReplies));
    if (key == QLatin1String("rate_off") && !report.ratesRefused.empty())
        return {false, ratesText(report.ratesRefused)};
    if (key == QLatin1String("old"))
        return ruledOutIf(allIds(facts) && allRates(facts), rateCount);
    if (key == QLatin1String("same_id"))
        return sameId(facts, row);
    return {};
}

Verdict verdictOn(const SearchFacts& facts, const QString& key, int row)
{
    static const QStringList alwaysRuledOut{QStringLiteral("level"), QStringLiteral("echo"),
                                            QStringLiteral("driver")};
    static const QStringList byHand{
        QStringLiteral("port"),    QStringLiteral("adapter_supply"), QStringLiteral("supply"),
        QStringLiteral("lead"),    QStringLiteral("damaged"),        QStringLiteral("drop"),
        QStringLiteral("blocked"), QStringLiteral("noise"),          QStringLiteral("line")};
    if (alwaysRuledOut.contains(key)) // a search needs an open port
        return {true, QString()};
    if (byHand.contains(key))
        return ruledOutIf(isSimulated(facts));
    if (key == QLatin1String("holder"))
        return ruledOutIf(isSimulated(facts), {},
                          facts.otherPrograms.isEmpty() ? std::nullopt
                                                        : std::optional(facts.otherPrograms));
    if (key == QLatin1String("locked"))
        return ruledOutIf(facts.history.idOrRateChanged);
    return ofTheSearch(facts, key, row);
}

bool fits(const SearchFacts& facts, int row)
{
    const bool nobody = facts.report.found.empty();
    switch (row) {
    case NothingOne:
    case NothingSeveral:
        return nobody;
    case OnlySome:
        return !nobody;
    case Garbled:
        return facts.report.garbledHeard || !twinsText(facts).isEmpty();
    case GoneAfterChange:
        return facts.history.idOrRateChanged || facts.history.vanished > 0;
    default:
        return false;
    }
}

/// What was really seen comes before what may be.
int urgency(const AdviceRow& row)
{
    if (!row.fits)
        return 2;
    return row.number == Garbled || row.number == GoneAfterChange ? 0 : 1;
}
} // namespace

SearchFacts searchFacts(const session::Desk& desk, const SearchHistory& history)
{
    SearchFacts facts;
    facts.spec = desk.lastSearchSpec();
    facts.report = desk.lastSearch().value_or(jobs::ScanReport{});
    facts.port = desk.lastRequest();
    facts.hasBaud = desk.hasBaud() || desk.state() != session::LinkState::Open;
    facts.history = history;
    facts.otherPrograms = desk.otherPrograms();
    for (const base::Protocol protocol : base::allProtocols) {
        const auto canBeMet = [&](int rate) {
            const auto met = desk.catalog().protocolsAt(rate);
            return std::find(met.begin(), met.end(), protocol) != met.end();
        };
        const auto& rates = facts.report.rates;
        if (!facts.hasBaud || std::any_of(rates.begin(), rates.end(), canBeMet))
            facts.possible.push_back(protocol);
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
        row.symptom = textIn(object, "symptom");
        row.fits = fits(facts, row.number);
        for (const QJsonValue& each : object.value(QLatin1String("items")).toArray()) {
            const QJsonObject item = each.toObject();
            const QString key = item.value(QLatin1String("key")).toString();
            const Verdict verdict = verdictOn(facts, key, row.number);
            Text finding;
            if (verdict.finding)
                finding = filled(item, verdict.ruledOut ? "ruled_out" : "hint", *verdict.finding);
            row.items.push_back(
                {key, textIn(item, "cause"), textIn(item, "check"), finding, verdict.ruledOut});
        }
        rows.push_back(std::move(row));
    }
    std::stable_sort(rows.begin(), rows.end(), [](const AdviceRow& a, const AdviceRow& b) {
        return urgency(a) < urgency(b);
    });
    return rows;
}

bool canSearchWider(const SearchFacts& facts)
{
    return !allIds(facts) || !allProtocols(facts) || (facts.hasBaud && !allRates(facts));
}
} // namespace ui
