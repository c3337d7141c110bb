// SPDX-License-Identifier: GPL-3.0-or-later
#include "results/sweep_points.h"

#include "files/csv_line_parser.h"
#include "files/text_file.h"

#include <QList>

namespace results {
using base::ErrorCode;

namespace {
const QString loadPointsOperation = QStringLiteral("load");
constexpr int maxPause = 3'600'000; ///< ms

QString toQString(std::string_view text)
{
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

base::Result<SweepPoint> pointOf(const std::vector<std::string_view>& cells, int line)
{
    SweepPoint point{toQString(cells.front())};
    if (point.target.isEmpty() || cells.size() > 2)
        return base::fail(ErrorCode::FileFormat, loadPointsOperation,
                          QStringLiteral("line %1").arg(line));
    if (cells.size() == 2 && !cells[1].empty()) {
        bool whole = false;
        const int pause = toQString(cells[1]).toInt(&whole);
        if (!whole || pause < 1 || pause > maxPause)
            return base::fail(ErrorCode::FileFormat, loadPointsOperation,
                              QStringLiteral("line %1, pause").arg(line));
        point.pause = std::chrono::milliseconds(pause);
    }
    return point;
}
} // namespace

base::Result<std::vector<SweepPoint>> decodeSweepPoints(const QByteArray& text)
{
    std::vector<SweepPoint> points;
    files::CsvLineParser split;
    int number = 0;
    for (const QByteArray& whole : text.split('\n')) {
        ++number;
        const QByteArray line =
            whole.left(whole.indexOf('#') < 0 ? whole.size() : whole.indexOf('#')).trimmed();
        if (line.isEmpty())
            continue;
        const auto& cells =
            split.split(std::string_view(line.constData(), std::size_t(line.size())));
        if (points.empty() && cells.front() == "target")
            continue;
        const auto point = pointOf(cells, number);
        if (!point)
            return tl::unexpected(point.error());
        points.push_back(*point);
    }
    return points;
}

base::Result<std::vector<SweepPoint>> loadSweepPoints(const QString& path)
{
    constexpr qint64 maxFileSize = 16 << 20;
    const auto text = files::readTextFile(loadPointsOperation, path, maxFileSize);
    if (!text)
        return tl::unexpected(text.error());
    return decodeSweepPoints(*text);
}
} // namespace results
