// SPDX-License-Identifier: GPL-3.0-or-later
// Names, columns and units are those of history_schema.cpp, since both are asked with the same
// statements. Texts compare byte by byte, as in SQLite, independent of the language of the
// database.
#include "history/server/history_server_schema.h"

#include "history/server/server_error.h"

namespace history {
namespace {
/// Any number, the same in all versions: the lock under which programs change the schema.
constexpr const char* lockStatement = "SELECT pg_advisory_xact_lock(7310579043018)";

/// `progress`: the revision up to which the server has the rows of a bench's file. `origin`
/// distinguishes a file from a copy of it, so that neither hides rows of the other.
QStringList benches()
{
    return {
        QStringLiteral("CREATE TABLE benches (number BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY "
                       "KEY, uuid TEXT NOT NULL UNIQUE, name TEXT NOT NULL, "
                       "program TEXT NOT NULL, sent BIGINT NOT NULL)"),
        QStringLiteral("CREATE TABLE progress (bench BIGINT NOT NULL REFERENCES benches, "
                       "origin TEXT NOT NULL, revision BIGINT NOT NULL, "
                       "PRIMARY KEY (bench, origin))"),
    };
}

/// The table `name` with the common columns; `columns` each end in a comma.
QString table(const char* name, const char* columns, bool ofServo)
{
    const QString servo =
        ofServo ? QStringLiteral("servo BIGINT NOT NULL REFERENCES servos ON DELETE CASCADE, ")
                : QString();
    return QStringLiteral("CREATE TABLE %1 (number BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY "
                          "KEY, uuid TEXT NOT NULL UNIQUE, %2%3"
                          "bench BIGINT NOT NULL REFERENCES benches)")
        .arg(QString::fromLatin1(name), QString::fromLatin1(columns), servo);
}

/// A servo may be referred to before it is sent: until then it is a row without content.
QStringList servos()
{
    return {
        table("servos",
              "protocol TEXT COLLATE \"C\" NOT NULL DEFAULT '', "
              "model_major BIGINT NOT NULL DEFAULT -1, model_minor BIGINT NOT NULL DEFAULT -1, "
              "firmware_major BIGINT NOT NULL DEFAULT -1, "
              "firmware_minor BIGINT NOT NULL DEFAULT -1, "
              "map TEXT COLLATE \"C\" NOT NULL DEFAULT '', id BIGINT NOT NULL DEFAULT -1, "
              "label TEXT COLLATE \"C\" NOT NULL DEFAULT '', "
              "model TEXT COLLATE \"C\" NOT NULL DEFAULT '', "
              "simulated BIGINT NOT NULL DEFAULT 0, current BIGINT NOT NULL DEFAULT 0, ",
              false),
        QStringLiteral("CREATE INDEX servos_id ON servos (id)"),
        QStringLiteral("CREATE INDEX servos_model ON servos (lower(model))"),
        table("facts", "name TEXT NOT NULL, at BIGINT NOT NULL, content TEXT NOT NULL, ", true),
        QStringLiteral("CREATE INDEX facts_servo ON facts (servo, name)"),
    };
}

QStringList writes()
{
    return {
        table("intents",
              "at BIGINT NOT NULL, kind TEXT COLLATE \"C\" NOT NULL, temporary BIGINT NOT NULL, "
              "lock_opened BIGINT NOT NULL, port TEXT NOT NULL, baud BIGINT NOT NULL, "
              "program TEXT NOT NULL, ended BIGINT, outcome TEXT, detail TEXT NOT NULL, ",
              true),
        QStringLiteral("CREATE INDEX intents_servo ON intents (servo, at)"),
        QStringLiteral("CREATE INDEX intents_bench ON intents (bench, at)"),
        QStringLiteral("CREATE TABLE writes (number BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY "
                       "KEY, intent BIGINT NOT NULL REFERENCES intents ON DELETE CASCADE, "
                       "place BIGINT NOT NULL, "
                       "servo BIGINT NOT NULL REFERENCES servos ON DELETE CASCADE, "
                       "at BIGINT NOT NULL, \"key\" TEXT COLLATE \"C\" NOT NULL, "
                       "address BIGINT NOT NULL, old BIGINT NOT NULL, new BIGINT NOT NULL, "
                       "read_back BIGINT, outcome TEXT, trouble BIGINT NOT NULL, "
                       "bench BIGINT NOT NULL REFERENCES benches, UNIQUE (intent, place))"),
        QStringLiteral("CREATE INDEX writes_at ON writes (at, number)"),
        QStringLiteral("CREATE INDEX writes_bench ON writes (bench, at, number)"),
        QStringLiteral("CREATE INDEX writes_key ON writes (\"key\", at, number)"),
        QStringLiteral("CREATE INDEX writes_servo ON writes (servo, at, number)"),
        QStringLiteral("CREATE INDEX writes_servo_key ON writes (servo, \"key\", at, number)"),
        QStringLiteral("CREATE INDEX writes_trouble ON writes (at, number) WHERE trouble = 1"),
    };
}

QStringList snapshotsAndAlarms()
{
    return {
        table("snapshots",
              "at BIGINT NOT NULL, reason TEXT COLLATE \"C\" NOT NULL, program TEXT NOT NULL, "
              "port TEXT NOT NULL, baud BIGINT NOT NULL, file TEXT NOT NULL, "
              "label TEXT NOT NULL, note TEXT NOT NULL, registers BIGINT NOT NULL, "
              "data BYTEA NOT NULL, ",
              true),
        QStringLiteral("CREATE INDEX snapshots_at ON snapshots (at, number)"),
        QStringLiteral("CREATE INDEX snapshots_servo ON snapshots (servo, at, number)"),
        table("alarms",
              "\"key\" TEXT COLLATE \"C\" NOT NULL, derived BIGINT NOT NULL, at BIGINT NOT NULL, "
              "went BIGINT, port TEXT NOT NULL, ",
              true),
        QStringLiteral("CREATE INDEX alarms_at ON alarms (at, number)"),
        QStringLiteral("CREATE INDEX alarms_servo ON alarms (servo, at, number)"),
        table("recordings",
              "at BIGINT NOT NULL, length BIGINT NOT NULL, file TEXT NOT NULL, "
              "readings BIGINT NOT NULL, port TEXT NOT NULL, simulated BIGINT NOT NULL, ",
              false),
        QStringLiteral("CREATE INDEX recordings_at ON recordings (at, number)"),
        QStringLiteral("CREATE TABLE recording_servos (recording BIGINT NOT NULL REFERENCES "
                       "recordings ON DELETE CASCADE, place BIGINT NOT NULL, "
                       "servo BIGINT NOT NULL REFERENCES servos ON DELETE CASCADE, "
                       "PRIMARY KEY (recording, place))"),
        QStringLiteral("CREATE INDEX recording_servos_servo ON recording_servos (servo)"),
    };
}

QStringList testRuns()
{
    return {
        table("runs",
              "kind TEXT COLLATE \"C\" NOT NULL, at BIGINT NOT NULL, program TEXT NOT NULL, "
              "port TEXT COLLATE \"C\" NOT NULL, simulated BIGINT NOT NULL, "
              "verdict TEXT NOT NULL, ended TEXT NOT NULL, operator TEXT COLLATE \"C\" NOT NULL, "
              "note TEXT COLLATE \"C\" NOT NULL, length BIGINT NOT NULL, ",
              false),
        QStringLiteral("CREATE INDEX runs_at ON runs (at, number)"),
        QStringLiteral("CREATE TABLE run_servos (run BIGINT NOT NULL REFERENCES runs ON DELETE "
                       "CASCADE, place BIGINT NOT NULL, id BIGINT NOT NULL, "
                       "model TEXT COLLATE \"C\" NOT NULL, map TEXT COLLATE \"C\" NOT NULL, "
                       "firmware TEXT COLLATE \"C\" NOT NULL, verdict TEXT NOT NULL, "
                       "label TEXT COLLATE \"C\" NOT NULL, reference BIGINT NOT NULL, "
                       "PRIMARY KEY (run, place))"),
        QStringLiteral("CREATE INDEX run_servos_model ON run_servos (model, reference)"),
        QStringLiteral("CREATE INDEX run_servos_id ON run_servos (id)"),
        QStringLiteral("CREATE TABLE run_texts (run BIGINT NOT NULL REFERENCES runs ON DELETE "
                       "CASCADE, part BIGINT NOT NULL, data BYTEA NOT NULL, "
                       "PRIMARY KEY (run, part))"),
        QStringLiteral("CREATE TABLE run_files (run BIGINT NOT NULL REFERENCES runs ON DELETE "
                       "CASCADE, place BIGINT NOT NULL, path TEXT NOT NULL, "
                       "PRIMARY KEY (run, place))"),
    };
}

/// The same lists of one bench, selected by a setting of the connection; tables not listed here
/// are children of those that are.
QStringList benchViews()
{
    QStringList all;
    for (const char* name :
         {"servos", "facts", "intents", "writes", "snapshots", "alarms", "recordings", "runs"})
        all.append(QStringLiteral("CREATE VIEW servodesk_bench.%1 AS SELECT * FROM servodesk.%1 "
                                  "WHERE bench = current_setting('servodesk.bench')::bigint")
                       .arg(QString::fromLatin1(name)));
    return all;
}

/// One element per schema version. Published ones never change.
const std::vector<QStringList>& migrations()
{
    static const std::vector<QStringList> all{benches() + servos() + writes() +
                                              snapshotsAndAlarms() + testRuns() + benchViews()};
    return all;
}

int newest()
{
    return int(migrations().size());
}

/// 0: there is no schema yet.
base::Result<int> versionOf(const HistoryFile& server)
{
    // Not to_regclass(): within a transaction it may return an old result, although another bench
    // created the schema while this one waited for the lock.
    const auto existing = server.run(QStringLiteral("SELECT 1 FROM pg_catalog.pg_tables WHERE "
                                                    "schemaname = 'servodesk' AND tablename = "
                                                    "'about'"));
    if (!existing)
        return tl::unexpected(existing.error());
    if (existing->rows.empty())
        return 0;
    const auto asked = server.run(QStringLiteral("SELECT max(version) FROM servodesk.about"));
    if (!asked)
        return tl::unexpected(asked.error());
    const int found = asked->rows.front().value(0).toInt();
    if (found > newest())
        return tl::unexpected(serverError(
            ServerErrorKind::Newer,
            QStringLiteral("schema %1, this program knows up to %2").arg(found).arg(newest())));
    return found;
}

base::Result<void> runAll(const HistoryFile& server, const QStringList& statements)
{
    for (const QString& sql : statements) {
        if (const auto done = server.run(sql); !done)
            return tl::unexpected(done.error());
    }
    return {};
}

/// Schemas created by an administrator need no right to create schemas.
base::Result<void> createSchemas(const HistoryFile& server)
{
    for (const char* name : {"servodesk", "servodesk_bench"}) {
        const auto existing =
            server.run(QStringLiteral("SELECT 1 FROM pg_namespace WHERE nspname = '%1'")
                           .arg(QString::fromLatin1(name)));
        if (!existing)
            return tl::unexpected(existing.error());
        if (!existing->rows.empty())
            continue;
        const auto made =
            server.run(QStringLiteral("CREATE SCHEMA %1").arg(QString::fromLatin1(name)));
        if (!made)
            return tl::unexpected(made.error());
    }
    return runAll(server, {QStringLiteral("CREATE TABLE IF NOT EXISTS servodesk.about "
                                          "(version INTEGER NOT NULL)")});
}
} // namespace

base::Result<void> migrateSchema(const HistoryFile& server)
{
    const auto before = versionOf(server);
    if (!before)
        return tl::unexpected(before.error());
    if (*before == newest())
        return {};
    return server.transaction([&]() -> base::Result<void> {
        if (const auto mine = server.run(QString::fromLatin1(lockStatement)); !mine)
            return tl::unexpected(mine.error());
        const auto found = versionOf(server); // another bench may have been first
        if (!found)
            return tl::unexpected(found.error());
        if (*found == newest())
            return {};
        if (const auto made = createSchemas(server); !made)
            return made;
        for (int step = *found; step < newest(); ++step) {
            if (const auto done = runAll(server, migrations()[std::size_t(step)]); !done)
                return done;
        }
        return runAll(server,
                      {QStringLiteral("DELETE FROM servodesk.about"),
                       QStringLiteral("INSERT INTO servodesk.about VALUES (%1)").arg(newest())});
    });
}

base::Result<void> checkSchema(const HistoryFile& server)
{
    const auto found = versionOf(server);
    if (!found)
        return tl::unexpected(found.error());
    if (*found == 0)
        return tl::unexpected(serverError(ServerErrorKind::Empty, {}));
    if (*found < newest())
        return tl::unexpected(serverError(
            ServerErrorKind::Older,
            QStringLiteral("schema %1, this program needs %2").arg(*found).arg(newest())));
    return {};
}

const std::vector<ServerTable>& serverTables()
{
    const auto toKeywords = [](const char* text) {
        return QString::fromLatin1(text).split(QLatin1Char(' '));
    };
    static const std::vector<ServerTable> all{
        {"servos",
         toKeywords("protocol model_major model_minor firmware_major firmware_minor map id "
                    "label model simulated current")},
        {"intents",
         toKeywords("at kind temporary lock_opened port baud program ended outcome detail"),
         true,
         {{"writes", "intent", "place",
           toKeywords("place at key address old new read_back outcome trouble"), true, true}}},
        {"snapshots", toKeywords("at reason program port baud file label note registers data"),
         true},
        {"alarms", toKeywords("key derived at went port"), true},
        {"recordings",
         toKeywords("at length file readings port simulated"),
         false,
         {{"recording_servos", "recording", "place", toKeywords("place"), true}}},
        {"facts", toKeywords("name at content"), true},
        {"runs",
         toKeywords("kind at program port simulated verdict ended operator note length"),
         false,
         {{"run_servos", "run", "place",
           toKeywords("place id model map firmware verdict label reference")},
          {"run_texts", "run", "part", toKeywords("part data")},
          {"run_files", "run", "place", toKeywords("place path")}}},
    };
    return all;
}
} // namespace history
