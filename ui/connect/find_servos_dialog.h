// SPDX-License-Identifier: GPL-3.0-or-later
// Which port are the servos on? Searches all ports when it is shown, lists what replied at which
// rate, and connects to the port that is chosen. Open it with show(); it does not block, and
// deletes itself. Main thread.
#pragma once

#include "session/port_watcher.h"
#include "session/search/port_finder.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QTableWidget;

namespace ui {
class ThinProgress;

class FindServosDialog final : public QDialog {
    Q_OBJECT

public:
    FindServosDialog(session::Session& session, const session::PortWatcher& ports, QWidget* parent);

Q_SIGNALS:
    void connectRequested(const session::PortRequest& request);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void start();
    void update();
    void showResults();
    void showProgress(const jobs::Progress& progress);
    void connectToSelected();
    void deleteWhenEnded();
    const session::PortResult* selected() const; ///< null: none, or no servo there
    void retranslate();

    session::Session& m_session;
    const session::PortWatcher& m_ports;
    bool m_isShown = false; ///< has been
    session::PortFinder m_finder;
    QLabel* m_intro;
    QTableWidget* m_table;
    QLabel* m_emptyLabel;
    ThinProgress* m_progress;
    QLabel* m_state;
    QPushButton* m_again;
    QPushButton* m_connect;
    QPushButton* m_close;
};
} // namespace ui
