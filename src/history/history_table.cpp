// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/history_table.h"

#include "catalog/value.h"
#include "history/history_query.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace history {
namespace {
const QLatin1String idKey("id");

/// One register of one write that may have changed it after the snapshot.
struct WriteStep {
    QString key;
    std::int64_t oldRaw = 0;
    std::int64_t newRaw = 0;
    std::optional<std::int64_t> readBack;
    QString outcome; ///< of the register, else of the whole; empty: not known at the moment
    base::IntentKind kind = base::IntentKind::Write;
    bool temporary = false;
    bool valuesKnown = true; ///< beforehand: some row of its intent was to change
    std::int64_t began = 0;  ///< ms
    std::int64_t number = 0; ///< of the write, among those of one moment
    std::int64_t ended = 0;  ///< ms; where no end is known, its begin

    bool isBefore(const WriteStep& other) const
    {
        return std::tie(began, number) < std::tie(other.began, other.number);
    }
    bool isPersistent() const
    {
        return !temporary && (outcome == QLatin1String("kept") || outcome == QLatin1String("done"));
    }
    bool isNewId() const { return key == idKey && isPersistent() && newRaw != oldRaw; }
};

WriteStep stepFrom(const QVariantList& row, std::int64_t until)
{
    WriteStep step;
    step.key = row.value(0).toString();
    step.oldRaw = row.value(1).toLongLong();
    step.newRaw = row.value(2).toLongLong();
    step.kind = base::intentKindFromName(row.value(6).toString()).value_or(base::IntentKind::Write);
    step.temporary = row.value(7).toBool();
    step.valuesKnown = row.value(8).toBool();
    step.began = row.value(10).toLongLong();
    step.number = row.value(11).toLongLong();
    step.ended = row.value(9).isNull() ? step.began : row.value(9).toLongLong();
    // A later recovery had not ended it yet, and the servo may have had either value.
    if (step.ended > until)
        return step;
    const QString own = row.value(4).toString();
    step.outcome = own.isEmpty() ? row.value(5).toString() : own;
    if (!row.value(3).isNull())
        step.readBack = row.value(3).toLongLong();
    return step;
}

/// In the order in which they began: a recovery leaves alone what a later write has replaced. One
/// that began before the snapshot counts where its end after it may have written; being given up
/// writes nothing.
base::Result<std::vector<WriteStep>> stepsBetween(const HistoryFile& file, std::int64_t servo,
                                                  const QDateTime& from, const QDateTime& until)
{
    const qint64 first = from.toMSecsSinceEpoch();
    const qint64 last = until.toMSecsSinceEpoch();
    const auto rows = file.run(
        QStringLiteral("SELECT w.\"key\", w.old, w.new, w.read_back, w.outcome, "
                       "i.outcome, i.kind, i.temporary, EXISTS (SELECT 1 FROM writes o "
                       "WHERE o.intent = w.intent AND o.old <> o.new), i.ended, w.at, w.number "
                       "FROM writes w JOIN intents i ON i.number = w.intent "
                       "WHERE w.servo = ? AND w.at <= ? AND (w.at >= ? OR "
                       "(i.ended > ? AND i.ended <= ? AND i.outcome <> 'abandoned' AND "
                       "NOT EXISTS (SELECT 1 FROM writes o WHERE o.servo = w.servo AND "
                       "o.\"key\" = w.\"key\" AND o.at > w.at AND o.at < ?))) "
                       "ORDER BY w.at, w.number"),
        {qint64(servo), last, first, first, last, first});
    if (!rows)
        return tl::unexpected(rows.error());
    std::vector<WriteStep> steps;
    for (const QVariantList& row : rows->rows)
        steps.push_back(stepFrom(row, last));
    return steps;
}

/// The next change of the ID that a servo of this kind was given by `from`, in whose history that
/// stands. A label follows a servo to its new ID, but may have been given later.
struct NextId {
    std::int64_t servo = 0; ///< has that ID
    WriteStep change;
};
base::Result<std::optional<NextId>> nextId(const HistoryFile& file, std::int64_t servo,
                                           const WriteStep& from, const QDateTime& until)
{
    const auto rows = file.run(
        QStringLiteral(
            "SELECT w.servo, w.at, w.number, w.new FROM writes w "
            "JOIN intents i ON i.number = w.intent JOIN servos t ON t.number = w.servo "
            "JOIN servos s ON s.number = ? WHERE w.\"key\" = 'id' AND w.old <> w.new AND "
            "t.id = ? AND t.simulated = s.simulated AND t.protocol = s.protocol AND "
            "t.model_major = s.model_major AND t.model_minor = s.model_minor AND "
            "t.firmware_major = s.firmware_major AND t.firmware_minor = s.firmware_minor AND "
            "t.map = s.map AND (t.label = s.label OR t.label = '') AND i.temporary = 0 AND "
            "COALESCE(NULLIF(w.outcome, ''), i.outcome) IN ('kept', 'done') AND i.ended <= ? AND "
            "(w.at > ? OR (w.at = ? AND w.number > ?)) ORDER BY w.at, w.number LIMIT 1"),
        {qint64(servo), qint64(from.newRaw), until.toMSecsSinceEpoch(), qint64(from.began),
         qint64(from.began), qint64(from.number)});
    if (!rows)
        return tl::unexpected(rows.error());
    if (rows->rows.empty())
        return std::nullopt;
    const QVariantList& row = rows->rows.front();
    NextId next{row.value(0).toLongLong(), {}};
    next.change.began = row.value(1).toLongLong();
    next.change.number = row.value(2).toLongLong();
    next.change.newRaw = row.value(3).toLongLong();
    return next;
}

/// What was written to a servo under other IDs since `away`, until it came back to `ownId`. If it
/// has not come back, only which IDs it had: the rest is in the history of those.
base::Result<std::vector<WriteStep>> stepsUnderOtherIds(const HistoryFile& file, std::int64_t servo,
                                                        int ownId, const WriteStep& away,
                                                        const QDateTime& until)
{
    std::vector<WriteStep> steps;
    WriteStep from = away;
    while (from.newRaw != ownId) {
        const auto next = nextId(file, servo, from, until);
        if (!next)
            return tl::unexpected(next.error());
        if (!*next) {
            std::erase_if(steps, [](const WriteStep& step) { return !step.isNewId(); });
            return steps;
        }
        const WriteStep& last = (*next)->change;
        const auto stepsThere = stepsBetween(
            file, (*next)->servo, QDateTime::fromMSecsSinceEpoch(from.began, Qt::UTC), until);
        if (!stepsThere)
            return tl::unexpected(stepsThere.error());
        std::copy_if(
            stepsThere->begin(), stepsThere->end(), std::back_inserter(steps),
            [&](const WriteStep& step) { return from.isBefore(step) && !last.isBefore(step); });
        from = last;
    }
    return steps;
}

/// With those under other IDs, in the order in which they began.
base::Result<std::vector<WriteStep>> allSteps(const HistoryFile& file, const HistoryServo& servo,
                                              const QDateTime& from, const QDateTime& until)
{
    auto steps = stepsBetween(file, servo.number, from, until);
    if (!steps)
        return steps;
    for (const WriteStep& step : std::vector(*steps)) {
        if (!step.isNewId() || step.newRaw == servo.identity.id)
            continue;
        const auto more = stepsUnderOtherIds(file, servo.number, servo.identity.id, step, until);
        if (!more)
            return more;
        steps->insert(steps->end(), more->begin(), more->end());
    }
    std::stable_sort(steps->begin(), steps->end(),
                     [](const WriteStep& a, const WriteStep& b) { return a.isBefore(b); });
    return steps;
}

/// Applies the writes to the snapshot.
class Replay {
public:
    explicit Replay(TableState& state)
        : m_state(state)
    {}

    void apply(const WriteStep& step)
    {
        if (step.outcome == QLatin1String("refused") || step.outcome == QLatin1String("not-sent"))
            return;
        // Lost at the next power-off by design; values set by a test or by blinking are restored.
        if (step.temporary || step.outcome == QLatin1String("temporary")) {
            noteTemporary(step);
            return;
        }
        // After a reset by the servo itself (0x06) old and new value are equal in all rows; the
        // values of a restored snapshot are known.
        const bool measured = step.kind == base::IntentKind::Calibrate; // by the servo itself
        if (step.kind == base::IntentKind::Restore && !step.valuesKnown) {
            forgetSettings();
        } else if (!measured && step.isPersistent()) {
            set(step.key, step.readBack.value_or(step.newRaw));
            if (step.isNewId())
                noteId(step);
        } else if (!measured && step.outcome == QLatin1String("undone")) {
            set(step.key, step.oldRaw);
        } else {
            forget(step.key);
        }
    }

private:
    snapshot::SnapshotRegister* find(const QString& key)
    {
        const auto row =
            std::find_if(m_state.table.registers.begin(), m_state.table.registers.end(),
                         [&](const snapshot::SnapshotRegister& one) { return one.key == key; });
        return row == m_state.table.registers.end() ? nullptr : &*row;
    }
    void noteId(const WriteStep& step)
    {
        m_state.changedId.reset();
        if (step.newRaw != m_state.table.servo.id)
            m_state.changedId = {int(step.newRaw),
                                 QDateTime::fromMSecsSinceEpoch(step.ended, Qt::UTC)};
    }
    /// Until power-off the value in effect differs from the stored one.
    void noteTemporary(const WriteStep& step)
    {
        const snapshot::SnapshotRegister* row = find(step.key);
        if (row != nullptr && row->area == catalog::Area::Eprom &&
            step.outcome != QLatin1String("undone") && !m_state.temporary.contains(step.key))
            m_state.temporary.append(step.key);
    }
    void set(const QString& key, std::int64_t raw)
    {
        snapshot::SnapshotRegister* row = find(key);
        if (row == nullptr)
            return;
        row->raw = raw;
        row->value.reset();
        m_state.unknown.removeAll(key);
        m_state.temporary.removeAll(key);
        if (!m_state.replayed.contains(key))
            m_state.replayed.append(key);
    }
    void forget(const QString& key)
    {
        snapshot::SnapshotRegister* row = find(key);
        if (row == nullptr)
            return;
        row->raw.reset();
        row->value.reset();
        m_state.replayed.removeAll(key);
        if (!m_state.unknown.contains(key))
            m_state.unknown.append(key);
    }
    /// The stored value is in effect now, but it has not been read.
    void forgetSettings()
    {
        for (const snapshot::SnapshotRegister& row : std::vector(m_state.table.registers)) {
            if (row.area == catalog::Area::Eprom && row.access != catalog::Access::ReadOnly)
                forget(row.key);
        }
    }

    TableState& m_state;
};

/// Computes the physical values again: a written register can change the meaning of others.
void fillValues(snapshot::Snapshot& table, const catalog::Catalog& catalog,
                const base::ServoIdentity& servo)
{
    catalog::Identity identity;
    identity.firmwareMajor = servo.firmwareMajor;
    identity.firmwareMinor = servo.firmwareMinor;
    identity.modelMajor = servo.modelMajor;
    identity.modelMinor = servo.modelMinor;
    identity.protocol = servo.protocol;
    const catalog::ProfilePtr profile = catalog.resolve(identity);
    if (!profile || profile->mapKey != table.servo.map)
        return;
    const catalog::Lookup lookup = [&](const QString& key) -> std::optional<std::int64_t> {
        for (const snapshot::SnapshotRegister& row : table.registers) {
            if (row.key == key)
                return row.raw;
        }
        return std::nullopt;
    };
    for (snapshot::SnapshotRegister& row : table.registers) {
        const catalog::Register* reg = profile->find(row.key);
        if (reg == nullptr || !row.raw)
            continue;
        const catalog::ValueFormat meaning = catalog::valueFormat(*reg, *profile, lookup);
        row.value = catalog::toPhysical(*row.raw, meaning);
        row.unit = meaning.unit;
    }
}
} // namespace

base::Result<TableState> tableAt(const HistoryFile& file, const catalog::Catalog& catalog,
                                 std::int64_t servo, const QDateTime& at)
{
    const HistoryLog log(file);
    const auto identity = log.servo(servo);
    if (!identity)
        return tl::unexpected(identity.error());
    HistoryFilter before;
    before.servo = servo;
    before.until = at.addMSecs(1);
    before.limit = 1;
    const auto last = log.snapshots(before);
    if (!last)
        return tl::unexpected(last.error());
    if (last->empty())
        return base::fail(base::ErrorCode::BadArgument, QStringLiteral("history"),
                          QStringLiteral("no-snapshot"));
    const auto table = log.snapshot(last->front().number);
    if (!table)
        return tl::unexpected(table.error());
    const auto steps = allSteps(file, *identity, last->front().at, at);
    if (!steps)
        return tl::unexpected(steps.error());
    TableState state{*table, last->front()};
    state.table.at = at.toUTC();
    Replay replay(state);
    for (const WriteStep& step : *steps)
        replay.apply(step);
    fillValues(state.table, catalog, identity->identity);
    return state;
}
} // namespace history
