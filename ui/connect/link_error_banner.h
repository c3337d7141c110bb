// SPDX-License-Identifier: GPL-3.0-or-later
// Shows in the banner what is wrong with the port: why it could not be opened, that it was
// unplugged, that the braille service has taken an adapter. While the message about a lost port
// stands, the same adapter is opened again as soon as it is back; closing the message ends that.
// Owned by the window; main thread.
#pragma once

#include "session/link/link_controller.h"
#include "session/port_watcher.h"
#include "ui/widgets/banner.h"

#include <QTimer>

#include <optional>

class QAction;

namespace ui {
class ConnectBar;

class LinkErrorBanner final : public QObject {
    Q_OBJECT

public:
    LinkErrorBanner(session::LinkController& link, session::PortWatcher& ports, ConnectBar& bar,
                    Banner& banner, QObject* parent = nullptr);

    bool isWaiting() const { return m_retryTimer.isActive(); } ///< for a lost adapter

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void connectFailed(const base::Error& error);
    void linkChanged();
    void linkLost();
    void noteAdapter();
    void detectBraille();
    QString presentPath() const; ///< where the lost adapter is now; empty: not there
    void reconnectIfBack();
    void reconnectNow();
    void reconnectFailed(const base::Error& error);
    void stopWaiting();
    void hideOurMessage();
    void retranslate();

    session::LinkController& m_link;
    session::PortWatcher& m_ports;
    ConnectBar& m_bar;
    Banner& m_banner;
    QAction* m_retry;
    QAction* m_reconnect;
    session::ReplugWatcher m_replug;
    QTimer m_retryTimer;         ///< runs while a lost port is waited for
    QString m_openKey;           ///< of the adapter in use, as known while it is there
    QString m_backAs;            ///< where it was plugged in again
    bool m_bannerIsOurs = false; ///< the banner shows something of ours
    std::optional<base::ErrorCode> m_reportedFailure; ///< why it could not be opened again
    QStringList m_reportedBraille;
};
} // namespace ui
