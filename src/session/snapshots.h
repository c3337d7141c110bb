// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots for the window: taken from a servo or a whole bus, opened and saved as files, kept in
// the history. Beside Desk and Archive, which must outlive it; main thread, never waits. Restoring
// is the desk's (session/restore_order.h).
#pragma once

#include "record/bundle.h"
#include "record/restore_result.h"
#include "session/archive.h"
#include "session/desk.h"

namespace session {
using SharedBundle = std::shared_ptr<const record::Bundle>;

struct SnapshotWish {
    QString label{};
    QString note{};
    QString path{}; ///< empty: it is kept in the history only
};

/// What a file turned out to be: one of them is set.
struct OpenedFile {
    QString path{};
    SharedSnapshot snapshot{};
    SharedBundle bundle{};
};

class Snapshots final : public QObject {
    Q_OBJECT

public:
    Snapshots(Desk& desk, Archive& archive, QObject* parent = nullptr);

    /// Reads the table anew, keeps it in the history and in the file. taken() or failed().
    void take(ServoRef servo, const SnapshotWish& wish);
    /// All servos of the list that are known and answer at the port's rate. bundled() or failed();
    /// one that cannot be read fails the whole.
    void takeAll(const SnapshotWish& wish);
    bool taking() const { return m_taking; }

    /// What has been read of a servo so far; null: gone, or not known what it is.
    SharedSnapshot now(ServoRef servo) const;
    /// What such a servo leaves the factory with.
    SharedSnapshot factory(const record::Snapshot& like) const;
    /// Chosen rows only; errors as record::makeTemplate.
    base::Result<SharedSnapshot> asTemplate(const record::Snapshot& from, const QStringList& keys,
                                            const SnapshotWish& wish) const;

    /// A snapshot, a template or a bundle. opened() or failed().
    void open(const QString& path);
    /// CSV where the name ends so. saved() or failed().
    void save(SharedSnapshot snapshot, const QString& path);
    void save(std::vector<record::RestoreResult> results, const QString& path);

Q_SIGNALS:
    void taken(const session::SharedSnapshot& snapshot, const QString& path);
    void bundled(const session::SharedBundle& bundle, const QString& path);
    void opened(const session::OpenedFile& file);
    void saved(const QString& path);
    void failed(const base::Error& error);
    void takingChanged();

private:
    void setTaking(bool taking);
    /// `keep`: what goes into the history whether or not the file could be written, so that it
    /// names none that is not there.
    void onDisk(std::function<base::Result<void>()> write, std::function<void()> then,
                std::function<void(bool written)> keep = {});

    Desk& m_desk;
    Archive& m_archive;
    bool m_taking = false;
};
} // namespace session
