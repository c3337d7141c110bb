// SPDX-License-Identifier: GPL-3.0-or-later
// The history database in the user's data folder: the test runs; log() has servos, writes,
// snapshots, alarms and recordings. SQLite; several programs may use one file at the same time. An
// object belongs to the thread that opened it, and any number may be open. Everything fails as
// history/history_file.h; a run that is not there is a BadArgument. Servos carry no serial
// number: a servo is a model, a firmware, an ID and the user's label.
#pragma once

#include "files/text_file.h"
#include "history/history_log.h"
#include "history/history_timeout.h"
#include "results/step_run.h"
#include "results/sweep_run.h"

#include <QVariantList>

#include <chrono>
#include <memory>

namespace history {
class HistoryFile;

/// A servo in a run.
struct TestServo {
    int id = -1;
    QString model{};
    QString map{}; ///< of its registers, the same for a series
    QString firmware{};
    results::Grade verdict = results::Grade::NotMeasured;
    QString label{};        ///< the user's
    bool reference = false; ///< what others of its model are held against; one a model
    bool operator==(const TestServo&) const = default;
};

/// What a list shows of a run; the run itself is loaded.
struct TestRun {
    std::int64_t number = 0;                ///< in this file; never given twice
    QString uuid{};                         ///< the same in every copy
    QString kind = QStringLiteral("sweep"); ///< or "step"
    QDateTime at{};                         ///< UTC
    QString program{};
    QString port{};
    bool simulated = false;
    results::Grade verdict = results::Grade::NotMeasured;
    QString end{}; ///< sweepEndName()
    QString operatorName{};
    QString note{};
    base::Duration length{};
    std::vector<TestServo> servos{};
    QStringList files{}; ///< readings and report, where they were written to
    bool operator==(const TestRun&) const = default;
};

/// Empty members do not choose.
struct RunFilter {
    QString kind{};
    QString model{};
    QString firmware{};
    std::optional<int> id{};
    QDateTime from{};  ///< inclusive
    QDateTime until{}; ///< exclusive
    QString text{};    ///< in model, firmware, label, note, operator or port
    int limit = 10000;
};

/// A run that did not finish has no verdict on a good servo.
bool canBeReference(const TestRun& run);
/// Nor can a servo that failed.
bool canBeReference(const TestRun& run, const TestServo& servo);

struct ReferenceServo {
    TestRun run;
    TestServo servo;
    bool isUsable() const { return canBeReference(run, servo); } ///< a database may hold any
};

class History {
public:
    /// `patience`: how long it waits for another program that is writing.
    static base::Result<std::unique_ptr<History>>
    open(const QString& path, std::chrono::milliseconds timeout = historyTimeout);
    /// Over one that is open, such as a server's copies.
    explicit History(std::unique_ptr<HistoryFile> file);
    ~History();

    /// Returns its number. `write` writes the whole run as text; number and uuid of `head` are set
    /// here.
    base::Result<std::int64_t> add(const TestRun& head,
                                   const std::function<void(const files::TextSink&)>& write);
    base::Result<std::int64_t> add(const results::SweepRun& run, const QStringList& files = {});
    base::Result<std::int64_t> add(const results::StepRun& run, const QStringList& files = {});

    /// Newest first.
    base::Result<std::vector<TestRun>> runs(const RunFilter& filter = {}) const;
    base::Result<TestRun> run(std::int64_t number) const;
    base::Result<QByteArray> text(std::int64_t number) const;
    /// With the labels and the note as they are now.
    base::Result<results::SweepRun> sweep(std::int64_t number) const;
    base::Result<results::StepRun> step(std::int64_t number) const;
    base::Result<void> remove(std::int64_t number);

    base::Result<void> setLabel(std::int64_t number, int servo, const QString& label);
    base::Result<void> setNote(std::int64_t number, const QString& note);
    /// Takes the mark from the model's reference before. Refused "unfinished-reference": the run
    /// did not finish; "failed-reference": this servo failed.
    base::Result<void> setReference(std::int64_t number, int servo, bool reference);
    base::Result<std::optional<ReferenceServo>> reference(const QString& model) const;

    /// Borrows this connection.
    HistoryLog log() const { return HistoryLog(*m_file); }
    const HistoryFile& file() const { return *m_file; }

private:
    base::Result<void> change(const QString& sql, const QVariantList& values, std::int64_t number);
    base::Result<void> addParts(const TestRun& head, std::int64_t number,
                                const std::function<void(const files::TextSink&)>& write);
    base::Result<std::vector<TestRun>> read(const QString& whereClause,
                                            const QVariantList& values) const;

    std::unique_ptr<HistoryFile> m_file;
};

TestRun toTestRun(const results::SweepRun& run);
TestRun toTestRun(const results::StepRun& run);

struct SavedRun {
    std::int64_t number = 0;              ///< in the history; 0: it is not there
    std::optional<base::Error> trouble{}; ///< why
    QString file{};                       ///< where the run was left instead; empty: nowhere
};

/// Opens the history, adds the run, closes it. If that cannot be, the run becomes a JSON file
/// beside it: what was measured is not lost. It waits longer than a list or a write that has yet to
/// begin.
SavedRun saveRun(const QString& historyPath, const results::SweepRun& run,
                 const QStringList& files = {},
                 std::chrono::milliseconds timeout = std::chrono::seconds(5));
SavedRun saveRun(const QString& historyPath, const results::StepRun& run,
                 const QStringList& files = {},
                 std::chrono::milliseconds timeout = std::chrono::seconds(5));
} // namespace history
