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
constexpr auto settleDelay = 1500ms;
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
    connect(m_reconnect, &QAction::triggered, this, &LinkErrorBanner::reconnect);
    connect(&m_link, &session::LinkController::connectFailed, this,
            &LinkErrorBanner::connectFailed);
    connect(&m_link, &session::LinkController::linkChanged, this, &LinkErrorBanner::linkChanged);
    connect(&m_ports, &session::PortWatcher::portsChanged, this, [this] {
        detectAdapter();
        detectBraille();
    });
    connect(&m_banner, &Banner::dismissed, this, [this] {
        m_replug.stop();
        m_bannerIsOurs = false;
    });
    m_banner.installEventFilter(this);
    retranslate();
}

void LinkErrorBanner::connectFailed(const base::Error& error)
{
    m_bannerIsOurs = true;
    m_banner.showMessage(error, {m_retry});
}

void LinkErrorBanner::linkChanged()
{
    switch (m_link.state()) {
    case LinkState::Opening:
    case LinkState::Open:
        m_replug.stop();
        m_openKey = m_ports.adapterKey(m_link.lastRequest().name);
        adapterSettled();
        return;
    case LinkState::Lost:
        linkLost();
        return;
    case LinkState::Off:
    case LinkState::Closing:
        return;
    }
}

/// The message about the port is out of date.
void LinkErrorBanner::adapterSettled()
{
    if (m_bannerIsOurs)
        m_banner.hideMessage();
    m_bannerIsOurs = false;
}

void LinkErrorBanner::linkLost()
{
    const QString port = m_link.lastRequest().name;
    m_bannerIsOurs = true;
    m_newPath.clear();
    m_replug.start(m_ports, m_openKey, port);
    m_banner.showMessage(
        [port] {
            const text::Description words =
                text::describe({base::ErrorCode::LinkLost, QStringLiteral("read"), port});
            const bool bridge = port.startsWith(QLatin1String("tcp:"));
            const bool there = QFileInfo::exists(port); // it hung up, or is back already
            const QString what = bridge || there ? tr("The connection to %1 was lost.").arg(port)
                                                 : tr("%1 was unplugged.").arg(port);
            const QString remedy =
                tr("Plug the adapter in again to continue. A write that was in progress is "
                   "recorded in the journal and will be checked first.");
            return BannerText{Tone::Bad, what, words.cause, bridge ? words.remedy : remedy};
        },
        port.startsWith(QLatin1String("tcp:")) ? QList<QAction*>{m_retry} : QList<QAction*>{});
    QTimer::singleShot(settleDelay, this, [this] {
        m_replug.forgetOldPath();
        detectAdapter();
    });
}

void LinkErrorBanner::detectAdapter()
{
    const QString back = m_replug.detect(m_ports);
    if (m_link.state() != LinkState::Lost || back == m_newPath)
        return;
    m_newPath = back;
    if (back.isEmpty()) { // and gone again
        linkLost();
        return;
    }
    m_banner.showMessage(
        [back] {
            return BannerText{
                Tone::Good,
                tr("The adapter is available again as %1.").arg(back),
                {},
                tr("Reconnect to continue with the same servos; reconnecting writes nothing.")};
        },
        {m_reconnect});
}

void LinkErrorBanner::reconnect()
{
    session::PortRequest request = m_link.lastRequest();
    if (!m_newPath.isEmpty())
        request.name = m_newPath;
    m_bar.setRequest(request);
    m_bar.connectNow();
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
    m_bannerIsOurs = true;
    m_banner.showMessage([chip = taken.constFirst()] {
        const text::Description words =
            text::describe({base::ErrorCode::PortMissing, QStringLiteral("open"),
                            chip + QStringLiteral(", brltty")});
        return BannerText{Tone::Warn, words.message, words.cause, words.remedy};
    });
}

void LinkErrorBanner::retranslate()
{
    m_retry->setText(tr("Try again"));
    m_retry->setToolTip(tr("Opens the port again with the settings above"));
    m_reconnect->setText(tr("Connect again"));
    m_reconnect->setToolTip(
        tr("Opens the port again with the same settings and searches it for servos"));
}

/// A plain QObject gets language changes only through a widget.
bool LinkErrorBanner::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    return QObject::eventFilter(watched, event);
}
} // namespace ui
