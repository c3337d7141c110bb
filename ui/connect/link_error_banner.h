// SPDX-License-Identifier: GPL-3.0-or-later
// Shows in the banner what is wrong with the port: why it could not be opened, that it was
// unplugged, that the braille service has taken an adapter. Offers to reconnect when the adapter is
// back. Opens nothing on its own. Owned by the window; main thread.
#pragma once

#include "session/link/link_controller.h"
#include "session/port_watcher.h"
#include "ui/widgets/banner.h"

class QAction;

namespace ui {
class ConnectBar;

class LinkErrorBanner final : public QObject {
    Q_OBJECT

public:
    LinkErrorBanner(session::LinkController& link, session::PortWatcher& ports, ConnectBar& bar,
                    Banner& banner, QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void connectFailed(const base::Error& error);
    void linkChanged();
    void linkLost();
    void detectAdapter();
    void detectBraille();
    void reconnect();
    void adapterSettled();
    void retranslate();

    session::LinkController& m_link;
    session::PortWatcher& m_ports;
    ConnectBar& m_bar;
    Banner& m_banner;
    QAction* m_retry;
    QAction* m_reconnect;
    session::ReplugWatcher m_replug;
    QString m_openKey;           ///< of the adapter in use, as known while it is there
    QString m_newPath;           ///< where it is again
    bool m_bannerIsOurs = false; ///< the banner shows something of ours
    QStringList m_reportedBraille;
};
} // namespace ui
