// SPDX-License-Identifier: GPL-3.0-or-later
// What only a history server knows: the benches that send there.
#include "session/history/history_service.h"

namespace session {
using history::History;
using history::HistoryServer;

void HistoryService::benches(QObject* context, Answer<std::vector<history::HistoryBench>> answer)
{
    using Benches = std::vector<history::HistoryBench>;
    query<Benches>(
        [](History& history) -> base::Result<Benches> {
            const auto* server = dynamic_cast<const HistoryServer*>(&history.file());
            return server == nullptr ? Benches() : server->benches();
        },
        context, std::move(answer));
}

void HistoryService::benchNames(const QString& table, const std::vector<std::int64_t>& numbers,
                                QObject* context, Answer<QMap<qint64, QString>> answer)
{
    using Names = QMap<qint64, QString>;
    query<Names>(
        [table, numbers](History& history) -> base::Result<Names> {
            const auto* server = dynamic_cast<const HistoryServer*>(&history.file());
            return server == nullptr ? Names() : server->benchNames(table, numbers);
        },
        context, std::move(answer));
}
} // namespace session
