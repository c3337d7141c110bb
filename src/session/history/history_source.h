// SPDX-License-Identifier: GPL-3.0-or-later
// Where session::Archive asks: the file of this computer, or the copies on a server. Owned by the
// archive; main thread, never waits. Questions are answered one after the other on a thread of the
// source's, with an open history or the reason why there is none.
#pragma once

#include "history/history.h"

#include <functional>

namespace session {
class HistorySource {
public:
    using Query = std::function<void(const base::Result<record::History*>&)>;

    virtual ~HistorySource() = default;
    /// The question may outlive the archive: it owns what it uses.
    virtual void start(Query query) = 0;
    /// Whose history the next questions are about; nullopt: everybody's. A file has one.
    virtual void selectBench(std::optional<std::int64_t> bench) { (void)bench; }
};
} // namespace session
