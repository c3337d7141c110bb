// SPDX-License-Identifier: GPL-3.0-or-later
// Measurements to a CSV file while they come in: one header line `time_us,id,` and a column a
// register named `key[unit]`; then one line a reading, time in microseconds from the first one,
// decimal points in every locale, an empty cell where nothing was measured. Each line reaches
// the system before write() returns, so a crash loses nothing. One owner, one thread. Fails with
// FileUnwritable or DiskFull; after that the file ends with the last whole line.
#pragma once

#include "base/clock.h"
#include "base/error.h"

#include <QFile>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace recording {
struct CsvColumn {
    QString key;
    QString unit; ///< empty: a plain number, the column is called `key[]`
};

class CsvWriter {
public:
    /// Replaces what is in the file.
    static base::Result<std::unique_ptr<CsvWriter>> create(const QString& path,
                                                           const std::vector<CsvColumn>& columns);

    /// `values` follow the columns.
    base::Result<void> write(base::Duration at, int id,
                             std::span<const std::optional<double>> values);

    quint64 rows() const { return m_rows; }

private:
    explicit CsvWriter(const QString& path)
        : m_file(path)
    {}
    base::Result<void> append(const QByteArray& line);

    QFile m_file;
    qint64 m_size = 0;
    quint64 m_rows = 0;
    std::optional<base::Duration> m_start;
};
} // namespace recording
