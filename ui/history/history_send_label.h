// SPDX-License-Identifier: GPL-3.0-or-later
// How far the copies of the history on the server are, and what is wrong with the server; hidden
// without a server. The sender must outlive it; owned by the history page; main thread.
#pragma once

#include "session/history/history_sender.h"

#include <QLabel>

namespace ui {
class HistorySendLabel final : public QLabel {
    Q_OBJECT

public:
    HistorySendLabel(session::HistorySender& sender, QWidget* parent);

private:
    void showState();
    static QString errorText(const session::SendState& state);

    session::HistorySender& m_sender;
};
} // namespace ui
