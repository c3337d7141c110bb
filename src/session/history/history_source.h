// SPDX-License-Identifier: GPL-3.0-or-later
// Where HistoryService reads: the file of this computer, or the copies on a server. Owned by the
// service; main thread, never waits. Queries are answered one after the other on a thread of the
// source's, with an open history or the reason why there is none.
#pragma once

#include "history/history.h"

#include <functional>

namespace session {
class HistorySource {
public:
    using Query = std::function<void(const base::Result<history::History*>&)>;

    virtual ~HistorySource() = default;
    /// The query may outlive the service: it owns what it uses.
    virtual void start(Query query) = 0;
    /// The bench whose history the next queries read; nullopt: all. A file has one.
    virtual void selectBench(std::optional<std::int64_t> bench) { (void)bench; }
};
} // namespace session
