// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/connect/link_error_banner.h"

#include "text/error_text.h"
#include "ui/connect/connect_bar.h"

#include <QAction>
#include <QEvent>
#include <QFileInfo>
#include <QIcon>

namespace ui {
using session::LinkState;
using namespace std::chrono_literals;

namespace {
/// By then the list of ports has been updated and shows only present ports.
constexpr auto retryInterval = 1500ms;
} // namespace

LinkErrorBanner::LinkErrorBanner(session::LinkController& link, session::PortWatcher& ports,
                                 ConnectBar& bar, Banner& banner, QObject* parent)
    : QObject(parent)
    , m_link(link)
    , m_ports(ports)
    , m_bar(bar)
    , m_banner(banner)
    , m_retry(new QAction(this))
    , m_reconnect(new QAction(this))
{
    m_retry->setIcon(QIcon::fromTheme(QStringLiteral("view-refresh")));
    m_reconnect->setIcon(QIcon::fromTheme(QStringLiteral("network-connect")));
    connect(m_retry, &QAction::triggered, &m_bar, &ConnectBar::connectNow);
    connect(m_reconnect, &QAction::triggered, this, [this] {
        m_reportedFailure.reset();
        m_retryTimer.start();
        reconnectNow();
    });
    m_retryTimer.setInterval(retryInterval);
    connect(&m_retryTimer, &QTimer::timeout, this, [this] {
        m_replug.forgetOldPath();
        m_backAs = m_replug.detect(m_ports);
        reconnectIfBack();
    });
    connect(&m_link, &session::LinkController::connectFailed, this,
            &LinkErrorBanner::connectFailed);
    connect(&m_link, &session::LinkController::linkChanged, this, &LinkErrorBanner::linkChanged);
    connect(&m_ports, &session::PortWatcher::portsChanged, this, [this] {
        noteAdapter();
        if (m_retryTimer.isActive()) {
            m_backAs = m_replug.detect(m_ports);
            reconnectIfBack();
        }
        detectBraille();
    });
    connect(&m_banner, &Banner::messageReplaced, this, [this] { m_bannerIsOurs = false; });
    connect(&m_banner, &Banner::dismissed, this, [this] {
        if (!std::exchange(m_bannerIsOurs, false))
            return;
        stopWaiting();
        m_link.cancelReconnect();
    });
    m_banner.installEventFilter(this);
    retranslate();
}

void LinkErrorBanner::connectFailed(const base::Error& error)
{
    if (m_link.state() == LinkState::Lost) {
        reconnectFailed(error);
        return;
    }
    m_banner.showMessage(error, {m_retry});
    m_bannerIsOurs = true;
}

void LinkErrorBanner::linkChanged()
{
    switch (m_link.state()) {
    case LinkState::Lost:
        linkLost();
        return;
    case LinkState::Opening:
    case LinkState::Open:
        m_openKey = m_ports.adapterKey(m_link.lastRequest().name);
        break;
    case LinkState::Off:
    case LinkState::Closing:
        break;
    }
    if (m_link.state() == LinkState::Open && m_link.isReconnect())
        m_bar.setRequest(m_link.lastRequest()); // the adapter may have another name now
    stopWaiting();
    hideOurMessage();
}

/// The list of ports may come later than the port. Without its adapter the key is the name.
void LinkErrorBanner::noteAdapter()
{
    const QString& name = m_link.lastRequest().name;
    const QString key = m_ports.adapterKey(name);
    const bool isOpen = m_link.state() == LinkState::Opening || m_link.state() == LinkState::Open;
    if (isOpen && key != name)
        m_openKey = key;
}

/// The message about the port is out of date.
void LinkErrorBanner::hideOurMessage()
{
    if (m_bannerIsOurs)
        m_banner.hideMessage();
    m_bannerIsOurs = false;
}

void LinkErrorBanner::stopWaiting()
{
    m_retryTimer.stop();
    m_replug.stop();
    m_reportedFailure.reset();
    m_backAs.clear();
}

void LinkErrorBanner::linkLost()
{
    const QString port = m_link.lastRequest().name;
    stopWaiting();
    m_replug.start(m_ports, m_openKey, port);
    m_retryTimer.start();
    m_banner.showMessage(
        [port] {
            const text::Description words =
                text::describe({base::ErrorCode::LinkLost, QStringLiteral("read"), port});
            const bool bridge = port.startsWith(QLatin1String("tcp:"));
            const bool there = QFileInfo::exists(port); // it hung up, or is back already
            const QString what = bridge || there ? tr("The connection to %1 was lost.").arg(port)
                                                 : tr("%1 was unplugged.").arg(port);
            const QString remedy =
                bridge ? tr("ServoDesk keeps trying to reconnect until you close this message. A "
                            "write that was in progress is recorded in the journal and will be "
                            "checked first.")
                       : tr("ServoDesk reconnects automatically when you plug the adapter in "
                            "again; close this message to stay disconnected. A write that was in "
                            "progress is recorded in the journal and will be checked first.");
            return BannerText{Tone::Bad, what, words.cause, remedy};
        },
        {m_reconnect});
    m_bannerIsOurs = true;
}

QString LinkErrorBanner::presentPath() const
{
    if (!m_backAs.isEmpty())
        return m_backAs;
    const QString& port = m_link.lastRequest().name;
    return port.startsWith(QLatin1String("tcp:")) ? port : QString();
}

void LinkErrorBanner::reconnectIfBack()
{
    if (m_link.state() == LinkState::Lost && !presentPath().isEmpty())
        reconnectNow();
}

void LinkErrorBanner::reconnectNow()
{
    const QString path = presentPath();
    m_link.reconnect(path.isEmpty() ? m_link.lastRequest().name : path);
}

/// The same failure is said once, not at every attempt, and never in place of another message, such
/// as that of a stop that could not be sent. A port that another program has taken is
/// left to it.
void LinkErrorBanner::reconnectFailed(const base::Error& error)
{
    if (error.code == base::ErrorCode::PortBusy)
        m_retryTimer.stop();
    if (!m_bannerIsOurs || m_reportedFailure == error.code)
        return;
    m_reportedFailure = error.code;
    m_banner.showMessage(error, {m_reconnect});
    m_bannerIsOurs = true;
}

void LinkErrorBanner::detectBraille()
{
    const QStringList taken = m_ports.claimedAdapters();
    if (taken == m_reportedBraille)
        return;
    m_reportedBraille = taken;
    const bool idle = m_link.state() == LinkState::Off || m_link.state() == LinkState::Lost;
    if (taken.isEmpty() || !idle)
        return;
    const bool waits = m_retryTimer.isActive();
    const auto bannerText = [chip = taken.constFirst()] {
        const text::Description words =
            text::describe({base::ErrorCode::PortMissing, QStringLiteral("open"),
                            chip + QStringLiteral(", brltty")});
        return BannerText{Tone::Warn, words.message, words.cause, words.remedy};
    };
    m_banner.showMessage(bannerText, waits ? QList<QAction*>{m_reconnect} : QList<QAction*>{});
    m_bannerIsOurs = true;
}

void LinkErrorBanner::retranslate()
{
    m_retry->setText(tr("Try again"));
    m_retry->setToolTip(tr("Opens the port again with the settings above"));
    m_reconnect->setText(tr("Reconnect"));
    m_reconnect->setToolTip(
        tr("Opens the port again and checks whether the servos in the list reply; writes nothing"));
}

/// A plain QObject gets language changes only through a widget.
bool LinkErrorBanner::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    return QObject::eventFilter(watched, event);
}
} // namespace ui
