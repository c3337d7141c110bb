// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/message_log.h"

#include "ui/app/event_text.h"
#include "ui/common/follow_language.h"

namespace ui {
namespace {
constexpr std::size_t maxEvents = 1000;
} // namespace

MessageLog::MessageLog(const session::ServoRegistry& registry, QWidget* parent)
    : QPlainTextEdit(parent)
    , m_registry(registry)
{
    setObjectName(QStringLiteral("messageLog"));
    setReadOnly(true);
    setMaximumBlockCount(static_cast<int>(maxEvents) * 4);
    followLanguage(this, [this] { retranslate(); });
}

/// A few lines: the chart above needs the room.
QSize MessageLog::sizeHint() const
{
    constexpr int lines = 5;
    return {QPlainTextEdit::sizeHint().width(), lines * fontMetrics().lineSpacing() + 12};
}

void MessageLog::add(const session::Event& event)
{
    m_events.push_back(event);
    if (m_events.size() > maxEvents)
        m_events.pop_front();
    write(event);
}

void MessageLog::write(const session::Event& event)
{
    const EventText eventText = describe(event, m_registry);
    if (eventText.message.isEmpty())
        return;
    QString text = QStringLiteral("%1  %2  %3")
                       .arg(event.at.toString(QStringLiteral("HH:mm:ss")), eventText.symbol,
                            eventText.message);
    for (const QString& more : eventText.details)
        text += QStringLiteral("\n             ") + more;
    appendPlainText(text);
}

void MessageLog::retranslate()
{
    setAccessibleName(tr("Messages"));
    setToolTip(tr("All messages since the program started"));
    setPlaceholderText(tr("No messages yet."));
    clear();
    for (const session::Event& event : m_events)
        write(event);
}
} // namespace ui
