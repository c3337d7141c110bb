// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/csv_writer.h"

#include "files/file_error.h"

#include <cmath>

namespace recording {
namespace {
const QString csvOperation = QStringLiteral("write-csv");

// Enough for every register, and hides the rounding noise of raw × scale.
constexpr int valueDigits = 12;

QByteArray utf8Cell(const QString& text)
{
    QByteArray bytes = text.toUtf8();
    if (bytes.contains(',') || bytes.contains('"') || bytes.contains('\n'))
        bytes = '"' + bytes.replace("\"", "\"\"") + '"';
    return bytes;
}

QByteArray utf8Cell(std::optional<double> value)
{
    if (!value || !std::isfinite(*value))
        return {};
    return QByteArray::number(*value, 'g', valueDigits);
}
} // namespace

base::Result<std::unique_ptr<CsvWriter>> CsvWriter::create(const QString& path,
                                                           const std::vector<CsvColumn>& columns)
{
    if (path.isEmpty())
        return tl::unexpected(files::noFileNameError(csvOperation));
    if (auto special = files::writeRefusal(csvOperation, path))
        return tl::unexpected(std::move(*special));
    std::unique_ptr<CsvWriter> writer(new CsvWriter(path));
    if (!writer->m_file.open(QIODevice::WriteOnly | QIODevice::Truncate | QIODevice::Unbuffered))
        return tl::unexpected(files::fileError(csvOperation, writer->m_file));
    QByteArray header = "time_us,id";
    for (const CsvColumn& column : columns)
        header += ',' + utf8Cell(QStringLiteral("%1[%2]").arg(column.key, column.unit));
    if (const auto written = writer->append(header); !written)
        return tl::unexpected(written.error());
    return writer;
}

base::Result<void> CsvWriter::write(base::Duration at, int id,
                                    std::span<const std::optional<double>> values)
{
    if (!m_start)
        m_start = at;
    QByteArray line =
        QByteArray::number(qint64((at - *m_start).count())) + ',' + QByteArray::number(id);
    for (const std::optional<double>& value : values)
        line += ',' + utf8Cell(value);
    const auto written = append(line);
    if (written)
        ++m_rows;
    return written;
}

base::Result<void> CsvWriter::append(const QByteArray& line)
{
    const QByteArray bytes = line + '\n';
    if (files::writeAll(m_file, bytes)) {
        m_size += bytes.size();
        return {};
    }
    const base::Error error = files::fileError(csvOperation, m_file);
    m_file.resize(m_size);
    return tl::unexpected(error);
}
} // namespace recording
