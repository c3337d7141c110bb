// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/history_send_label.h"

#include "text/error_text.h"
#include "ui/common/follow_language.h"

namespace ui {
HistorySendLabel::HistorySendLabel(session::HistorySender& sender, QWidget* parent)
    : QLabel(parent)
    , m_sender(sender)
{
    setObjectName(QStringLiteral("historyServerState"));
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    connect(&m_sender, &session::HistorySender::stateChanged, this, &HistorySendLabel::showState);
    followLanguage(this, [this] { showState(); });
}

/// What is wrong with the server, why, and what to do.
QString HistorySendLabel::errorText(const session::SendState& state)
{
    const QString first = tr("⚠ %1: new data will be sent later.")
                              .arg(state.server.isEmpty() ? tr("History server") : state.server);
    if (!state.error)
        return first;
    const text::Description words = text::describe(*state.error);
    QStringList lines{first, words.message, words.cause, words.remedy};
    lines.removeAll(QString());
    return lines.join(u'\n');
}

void HistorySendLabel::showState()
{
    using Phase = session::SendState::Phase;
    const session::SendState& state = m_sender.state();
    QString words;
    switch (state.phase) {
    case Phase::Off:
        break;
    case Phase::Waiting:
    case Phase::Sending:
        words = state.pending
                    ? tr("Sending %Ln row(s) to %1", nullptr, int(*state.pending)).arg(state.server)
                    : tr("Sending to %1…").arg(state.server);
        break;
    case Phase::UpToDate:
        words = tr("✔ %1 is up to date").arg(state.server);
        break;
    case Phase::Failed:
        words = errorText(state);
        break;
    }
    setText(words);
    setVisible(!words.isEmpty());
}
} // namespace ui
