// SPDX-License-Identifier: GPL-3.0-or-later
// What the line shows: passes each change of its view to the callback, and nothing twice. Internal
// to jobs; the job's thread.
#pragma once

#include "jobs/commission/commission.h"

namespace jobs {
class CommissionDisplay {
public:
    explicit CommissionDisplay(const CommissionCallbacks& callbacks)
        : m_callbacks(callbacks)
    {}

    void show(const CommissionView& view)
    {
        if (m_view == view)
            return;
        m_view = view;
        if (m_callbacks.onChange)
            m_callbacks.onChange(view);
    }
    const CommissionView& view() const { return *m_view; } ///< after the first show()

private:
    const CommissionCallbacks& m_callbacks;
    std::optional<CommissionView> m_view;
};
} // namespace jobs
