// SPDX-License-Identifier: GPL-3.0-or-later
// The top row of the window: port, baud rate and protocol, Connect or Disconnect, and the state of
// the bus. Settings that worked with an adapter are remembered and restored when it is selected.
// Executes Command::Connect, UseSimulation and UseSimulatedArm. Owned by the window; main thread.
#pragma once

#include "session/port_watcher.h"
#include "session/settings.h"
#include "session/workbench.h"
#include "ui/common/commands.h"
#include "ui/connect/link_meter.h"

#include <QWidget>

class QComboBox;
class QToolButton;

namespace ui {
class LinkOptions;
class Pill;
class PortPicker;

class ConnectBar final : public QWidget {
    Q_OBJECT

public:
    ConnectBar(session::Workbench& workbench, Commands& commands, session::Settings& settings,
               session::PortWatcher& ports, QWidget* parent = nullptr);

    /// As the fields stand.
    session::PortRequest request() const;
    /// Fills the fields; nothing remembered is mixed in.
    void setRequest(const session::PortRequest& request);
    /// Opens the port in the fields; without one, the list of ports.
    void connectNow();

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void connectSignals();
    void suggestPort();
    void portChosen(const QString& port);
    void askForPort();
    void linkChanged();
    void saveRequest();
    void showButton();
    void updateState();
    void showStatistics();
    void retranslate();

    session::Workbench& m_workbench;
    Commands& m_commands;
    session::Settings& m_settings;
    session::PortWatcher& m_ports;

    PortPicker* m_port;
    QComboBox* m_baud;
    QComboBox* m_protocol;
    QToolButton* m_more;
    LinkOptions* m_options;
    QToolButton* m_button;
    Pill* m_status;
    Pill* m_simulated;

    QTimer m_timer;
    LinkMeter m_meter;
    bool m_stopped = false; ///< torque was taken off the whole bus since the last look
    session::LinkState m_state = session::LinkState::Off;
};
} // namespace ui
