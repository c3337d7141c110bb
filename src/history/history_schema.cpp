// SPDX-License-Identifier: GPL-3.0-or-later
// Times are ms since 1970 UTC, lengths µs. Types and names are such that PostgreSQL takes them too;
// only triggers, partial indexes' use and AUTOINCREMENT are SQLite's own.
#include "history/history_schema.h"

namespace history {
namespace {
/// `label` and `reference` belong to a servo in a run, because servos carry no serial number.
/// The text of a run is kept in pieces, compressed each: a night has more than fits into memory.
/// `uuid` names a run wherever it is copied to.
QStringList testRuns()
{
    return {
        QStringLiteral(
            "CREATE TABLE runs (number INTEGER PRIMARY KEY AUTOINCREMENT, uuid TEXT NOT NULL "
            "UNIQUE, "
            "kind TEXT NOT NULL, at INTEGER NOT NULL, program TEXT NOT NULL, port TEXT NOT NULL, "
            "simulated INTEGER NOT NULL, verdict TEXT NOT NULL, ended TEXT NOT NULL, "
            "operator TEXT NOT NULL, note TEXT NOT NULL, length INTEGER NOT NULL)"),
        QStringLiteral(
            "CREATE TABLE run_servos (run INTEGER NOT NULL REFERENCES runs ON DELETE CASCADE, "
            "place INTEGER NOT NULL, id INTEGER NOT NULL, model TEXT NOT NULL, map TEXT NOT NULL, "
            "firmware TEXT NOT NULL, verdict TEXT NOT NULL, label TEXT NOT NULL, "
            "reference INTEGER NOT NULL, PRIMARY KEY (run, place)) WITHOUT ROWID"),
        QStringLiteral(
            "CREATE TABLE run_texts (run INTEGER NOT NULL REFERENCES runs ON DELETE CASCADE, "
            "part INTEGER NOT NULL, data BLOB NOT NULL, PRIMARY KEY (run, part))"),
        QStringLiteral(
            "CREATE TABLE run_files (run INTEGER NOT NULL REFERENCES runs ON DELETE CASCADE, "
            "place INTEGER NOT NULL, path TEXT NOT NULL, PRIMARY KEY (run, place)) WITHOUT ROWID"),
        QStringLiteral("CREATE INDEX runs_at ON runs (at)"),
        QStringLiteral("CREATE INDEX run_servos_model ON run_servos (model, reference)"),
        QStringLiteral("CREATE INDEX run_servos_id ON run_servos (id)"),
    };
}

/// `about`: the name of this file among copies. `clock`: the revision given last. `removed`: what
/// is gone.
QStringList metadataTables()
{
    return {
        QStringLiteral("CREATE TABLE about (name TEXT NOT NULL PRIMARY KEY, value TEXT NOT NULL)"),
        QStringLiteral("INSERT INTO about (name, value) VALUES ('bench', "
                       "lower(hex(randomblob(16))))"),
        QStringLiteral("CREATE TABLE clock (revision INTEGER NOT NULL)"),
        QStringLiteral("INSERT INTO clock (revision) "
                       "SELECT COALESCE(MAX(number), 0) FROM runs"),
        QStringLiteral("CREATE TABLE removed (revision INTEGER NOT NULL PRIMARY KEY, "
                       "kind TEXT NOT NULL, uuid TEXT NOT NULL)"),
    };
}

/// Of those alike in all but the label, one is current. A simulated servo is never a real one. A
/// fact belongs to a servo, not to a place in a list, so that another servo under the same ID does
/// not inherit it.
QStringList servos()
{
    return {
        QStringLiteral(
            "CREATE TABLE servos (number INTEGER PRIMARY KEY AUTOINCREMENT, uuid TEXT NOT NULL "
            "UNIQUE, revision INTEGER NOT NULL DEFAULT 0, protocol TEXT NOT NULL, "
            "model_major INTEGER NOT NULL, model_minor INTEGER NOT NULL, "
            "firmware_major INTEGER NOT NULL, firmware_minor INTEGER NOT NULL, "
            "map TEXT NOT NULL, id INTEGER NOT NULL, label TEXT NOT NULL, model TEXT NOT NULL, "
            "simulated INTEGER NOT NULL, current INTEGER NOT NULL, UNIQUE (id, simulated, "
            "protocol, model_major, model_minor, "
            "firmware_major, firmware_minor, map, label))"),
        QStringLiteral(
            "CREATE TABLE facts (number INTEGER PRIMARY KEY AUTOINCREMENT, uuid TEXT NOT NULL "
            "UNIQUE, revision INTEGER NOT NULL DEFAULT 0, "
            "servo INTEGER NOT NULL REFERENCES servos, name TEXT NOT NULL, at INTEGER NOT NULL, "
            "content TEXT NOT NULL, UNIQUE (servo, name))"),
    };
}

/// An intent without an outcome is open. `servo` and `at` stand in each write as well, so that a
/// million of them are found by servo, time and register without touching another table; `trouble`
/// is 1 until it has ended well.
QStringList writes()
{
    return {
        QStringLiteral(
            "CREATE TABLE intents (number INTEGER PRIMARY KEY AUTOINCREMENT, uuid TEXT NOT NULL "
            "UNIQUE, revision INTEGER NOT NULL DEFAULT 0, "
            "servo INTEGER NOT NULL REFERENCES servos, at INTEGER NOT NULL, kind TEXT NOT NULL, "
            "temporary INTEGER NOT NULL, lock_opened INTEGER NOT NULL, port TEXT NOT NULL, "
            "baud INTEGER NOT NULL, program TEXT NOT NULL, ended INTEGER, outcome TEXT, "
            "detail TEXT NOT NULL DEFAULT '')"),
        QStringLiteral("CREATE INDEX intents_servo ON intents (servo, at)"),
        QStringLiteral("CREATE INDEX intents_open ON intents (at) WHERE outcome IS NULL"),
        QStringLiteral("CREATE INDEX intents_moves ON intents (servo, at) WHERE kind = 'set-id'"),
        QStringLiteral("CREATE TABLE writes (number INTEGER PRIMARY KEY AUTOINCREMENT, "
                       "intent INTEGER NOT NULL REFERENCES intents ON DELETE CASCADE, "
                       "place INTEGER NOT NULL, servo INTEGER NOT NULL, at INTEGER NOT NULL, "
                       "\"key\" TEXT NOT NULL, address INTEGER NOT NULL, old INTEGER NOT NULL, "
                       "new INTEGER NOT NULL, read_back INTEGER, outcome TEXT, "
                       "trouble INTEGER NOT NULL DEFAULT 1)"),
        QStringLiteral("CREATE INDEX writes_intent ON writes (intent, place)"),
        QStringLiteral("CREATE INDEX writes_at ON writes (at)"),
        QStringLiteral("CREATE INDEX writes_key ON writes (\"key\", at)"),
        QStringLiteral("CREATE INDEX writes_servo ON writes (servo, at)"),
        QStringLiteral("CREATE INDEX writes_servo_key ON writes (servo, \"key\", at)"),
        QStringLiteral("CREATE INDEX writes_trouble ON writes (servo, at) WHERE trouble = 1"),
        QStringLiteral("CREATE INDEX writes_trouble_at ON writes (at) WHERE trouble = 1"),
    };
}

QStringList snapshots()
{
    return {
        QStringLiteral(
            "CREATE TABLE snapshots (number INTEGER PRIMARY KEY AUTOINCREMENT, uuid TEXT NOT NULL "
            "UNIQUE, revision INTEGER NOT NULL DEFAULT 0, "
            "servo INTEGER NOT NULL REFERENCES servos, at INTEGER NOT NULL, "
            "reason TEXT NOT NULL, program TEXT NOT NULL, port TEXT NOT NULL, "
            "baud INTEGER NOT NULL, file TEXT NOT NULL, label TEXT NOT NULL, note TEXT NOT NULL, "
            "registers INTEGER NOT NULL, data BLOB NOT NULL)"),
        QStringLiteral("CREATE INDEX snapshots_at ON snapshots (at)"),
        QStringLiteral("CREATE INDEX snapshots_servo ON snapshots (servo, at)"),
    };
}

QStringList alarmsAndRecordings()
{
    return {
        QStringLiteral(
            "CREATE TABLE alarms (number INTEGER PRIMARY KEY AUTOINCREMENT, uuid TEXT NOT NULL "
            "UNIQUE, revision INTEGER NOT NULL DEFAULT 0, "
            "servo INTEGER NOT NULL REFERENCES servos, \"key\" TEXT NOT NULL, "
            "derived INTEGER NOT NULL, at INTEGER NOT NULL, went INTEGER, port TEXT NOT NULL)"),
        QStringLiteral("CREATE INDEX alarms_at ON alarms (at)"),
        QStringLiteral("CREATE INDEX alarms_servo ON alarms (servo, at)"),
        QStringLiteral(
            "CREATE TABLE recordings (number INTEGER PRIMARY KEY AUTOINCREMENT, uuid TEXT NOT NULL "
            "UNIQUE, revision INTEGER NOT NULL DEFAULT 0, at INTEGER NOT NULL, "
            "length INTEGER NOT NULL, file TEXT NOT NULL, readings INTEGER NOT NULL, "
            "port TEXT NOT NULL, simulated INTEGER NOT NULL)"),
        QStringLiteral("CREATE INDEX recordings_at ON recordings (at)"),
        QStringLiteral("CREATE TABLE recording_servos (recording INTEGER NOT NULL REFERENCES "
                       "recordings ON DELETE CASCADE, place INTEGER NOT NULL, "
                       "servo INTEGER NOT NULL REFERENCES servos, PRIMARY KEY (recording, place))"),
        QStringLiteral("CREATE INDEX recording_servos_servo ON recording_servos (servo)"),
    };
}

/// Triggers give every changed row the next revision, so that no writer can forget it.
QStringList revisionTriggers(const QString& table, const QString& columns)
{
    const QString next = QStringLiteral("UPDATE clock SET revision = revision + 1; ");
    const QString mark = next + QStringLiteral("UPDATE %1 SET revision = (SELECT revision FROM "
                                               "clock) WHERE number = NEW.number; ");
    const QStringList all{
        QStringLiteral("CREATE INDEX %1_revision ON %1 (revision)"),
        QStringLiteral("CREATE TRIGGER %1_came AFTER INSERT ON %1 BEGIN ") + mark +
            QStringLiteral("END"),
        QStringLiteral("CREATE TRIGGER %1_changed AFTER UPDATE OF ") + columns +
            QStringLiteral(" ON %1 BEGIN ") + mark + QStringLiteral("END"),
        QStringLiteral("CREATE TRIGGER %1_went AFTER DELETE ON %1 BEGIN ") + next +
            QStringLiteral("INSERT INTO removed (revision, kind, uuid) SELECT revision, '%1', "
                           "OLD.uuid FROM clock; END"),
    };
    QStringList made;
    for (const QString& sql : all)
        made.append(QString(sql).replace(QStringLiteral("%1"), table));
    return made;
}

QStringList allButRuns()
{
    QStringList all = metadataTables() + servos() + writes() + snapshots() + alarmsAndRecordings();
    all << QStringLiteral("ALTER TABLE runs ADD COLUMN revision INTEGER NOT NULL DEFAULT 0")
        << QStringLiteral("UPDATE runs SET revision = number");
    all += revisionTriggers(QStringLiteral("servos"), QStringLiteral("label, model, current"));
    all += revisionTriggers(QStringLiteral("intents"), QStringLiteral("outcome, detail, ended"));
    all += revisionTriggers(QStringLiteral("snapshots"), QStringLiteral("label, note, file"));
    all += revisionTriggers(QStringLiteral("alarms"), QStringLiteral("went"));
    all += revisionTriggers(QStringLiteral("recordings"), QStringLiteral("file"));
    all += revisionTriggers(QStringLiteral("facts"), QStringLiteral("content"));
    all += revisionTriggers(QStringLiteral("runs"), QStringLiteral("note, operator"));
    all << QStringLiteral("CREATE TRIGGER run_servos_changed AFTER UPDATE ON run_servos BEGIN "
                          "UPDATE clock SET revision = revision + 1; UPDATE runs SET revision = "
                          "(SELECT revision FROM clock) WHERE number = NEW.run; END");
    return all;
}
} // namespace

const std::vector<QStringList>& historyMigrations()
{
    static const std::vector<QStringList> all{testRuns(), allButRuns()};
    return all;
}

const QStringList& syncedTables()
{
    static const QStringList all{QStringLiteral("servos"),     QStringLiteral("intents"),
                                 QStringLiteral("snapshots"),  QStringLiteral("alarms"),
                                 QStringLiteral("recordings"), QStringLiteral("facts"),
                                 QStringLiteral("runs")};
    return all;
}
} // namespace history
