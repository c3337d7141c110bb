// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/link_trouble.h"

#include "text/error_words.h"
#include "ui/widgets/connect_bar.h"

#include <QAction>
#include <QEvent>
#include <QFileInfo>
#include <QIcon>

namespace ui {
using session::LinkState;
using namespace std::chrono_literals;

namespace {
/// By then the list of ports has been renewed: what it shows is there.
constexpr auto settleTime = 1500ms;
} // namespace

LinkTrouble::LinkTrouble(session::Desk& desk, session::PortWatch& ports, ConnectBar& bar,
                         Banner& banner, QObject* parent)
    : QObject(parent)
    , m_desk(desk)
    , m_ports(ports)
    , m_bar(bar)
    , m_banner(banner)
    , m_retry(new QAction(this))
    , m_again(new QAction(this))
{
    m_retry->setIcon(QIcon::fromTheme(QStringLiteral("view-refresh")));
    m_again->setIcon(QIcon::fromTheme(QStringLiteral("network-connect")));
    connect(m_retry, &QAction::triggered, &m_bar, &ConnectBar::connectNow);
    connect(m_again, &QAction::triggered, this, &LinkTrouble::goOn);
    connect(&m_desk, &session::Desk::connectFailed, this, &LinkTrouble::failed);
    connect(&m_desk, &session::Desk::linkChanged, this, &LinkTrouble::linkChanged);
    connect(&m_ports, &session::PortWatch::portsChanged, this, [this] {
        lookForAdapter();
        lookForBraille();
    });
    connect(&m_banner, &Banner::dismissed, this, [this] {
        m_replug.stop();
        m_ours = false;
    });
    m_banner.installEventFilter(this);
    retranslate();
}

void LinkTrouble::failed(const base::Error& error)
{
    m_ours = true;
    m_banner.present(error, {m_retry});
}

void LinkTrouble::linkChanged()
{
    switch (m_desk.state()) {
    case LinkState::Opening:
    case LinkState::Open:
        m_replug.stop();
        m_openKey = m_ports.adapterKey(m_desk.lastRequest().name);
        settled();
        return;
    case LinkState::Lost:
        lost();
        return;
    case LinkState::Off:
    case LinkState::Closing:
        return;
    }
}

/// What was said of the port is of the past.
void LinkTrouble::settled()
{
    if (m_ours)
        m_banner.clear();
    m_ours = false;
}

void LinkTrouble::lost()
{
    const QString port = m_desk.lastRequest().name;
    m_ours = true;
    m_backAt.clear();
    m_replug.start(m_ports, m_openKey, port);
    m_banner.present(
        [port] {
            const text::Description words =
                text::describe({base::ErrorCode::LinkLost, QStringLiteral("read"), port});
            const bool bridge = port.startsWith(QLatin1String("tcp:"));
            const bool there = QFileInfo::exists(port); // it hung up, or is back already
            const QString what = bridge || there ? tr("The connection to %1 broke off.").arg(port)
                                                 : tr("%1 was unplugged.").arg(port);
            const QString remedy = tr("Plug it in again: then you can go on here. What was being "
                                      "written is in the journal, and is looked at first.");
            return BannerWords{Tone::Bad, what, words.cause, bridge ? words.remedy : remedy};
        },
        port.startsWith(QLatin1String("tcp:")) ? QList<QAction*>{m_retry} : QList<QAction*>{});
    QTimer::singleShot(settleTime, this, [this] {
        m_replug.settle();
        lookForAdapter();
    });
}

void LinkTrouble::lookForAdapter()
{
    const QString back = m_replug.look(m_ports);
    if (m_desk.state() != LinkState::Lost || back == m_backAt)
        return;
    m_backAt = back;
    if (back.isEmpty()) { // and gone again
        lost();
        return;
    }
    m_banner.present(
        [back] {
            return BannerWords{Tone::Good,
                               tr("The adapter is back at %1.").arg(back),
                               {},
                               tr("Connect again to go on with its servos; nothing is written.")};
        },
        {m_again});
}

void LinkTrouble::goOn()
{
    session::PortRequest request = m_desk.lastRequest();
    if (!m_backAt.isEmpty())
        request.name = m_backAt;
    m_bar.setRequest(request);
    m_bar.connectNow();
}

void LinkTrouble::lookForBraille()
{
    const QStringList taken = m_ports.taken();
    if (taken == m_brailleTold)
        return;
    m_brailleTold = taken;
    const bool idle = m_desk.state() == LinkState::Off || m_desk.state() == LinkState::Lost;
    if (taken.isEmpty() || !idle)
        return;
    m_ours = true;
    m_banner.present([chip = taken.constFirst()] {
        const text::Description words =
            text::describe({base::ErrorCode::PortMissing, QStringLiteral("open"),
                            chip + QStringLiteral(", brltty")});
        return BannerWords{Tone::Warn, words.what, words.cause, words.remedy};
    });
}

void LinkTrouble::retranslate()
{
    m_retry->setText(tr("Try again"));
    m_retry->setToolTip(tr("Open the port once more, as the fields above say"));
    m_again->setText(tr("Connect again"));
    m_again->setToolTip(tr("Open the port again with the same settings and search it"));
}

/// A plain object hears of a change of language through a widget only.
bool LinkTrouble::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    return QObject::eventFilter(watched, event);
}
} // namespace ui
