// SPDX-License-Identifier: GPL-3.0-or-later
// The choice of a port: connected adapters, names typed by hand, the simulated buses. Only the user
// changes the choice; plugging an adapter in or out does not. A chosen adapter that is unplugged
// stays in the list, marked as missing, and is followed when it comes back under another name.
// Owned by its parent; main thread.
#pragma once

#include "session/port_watcher.h"

#include <QComboBox>

class QStandardItem;

namespace ui {
class PortPicker final : public QComboBox {
    Q_OBJECT

public:
    explicit PortPicker(session::PortWatcher& ports, QWidget* parent = nullptr);

    QString port() const { return m_port; } ///< empty: none chosen
    /// A name that is in no list becomes an entry of its own. Emits nothing.
    void setPort(const QString& port);
    /// Chosen by the program because the user has chosen nothing yet; a better one may replace it.
    void suggest(const QString& port);
    bool isSelectedByUser() const { return m_selectedByUser; }
    /// Chosen, an adapter, and not plugged in.
    bool isMissing() const;

    void keyPressEvent(QKeyEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void showPopup() override;

Q_SIGNALS:
    void portSelected(const QString& port); ///< by the user, or the adapter is elsewhere now
    void otherPortRequested();              ///< the entry for typing a name

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Entry {
        QString key; ///< port name; "-1" …: a line between groups
        QString text;
        QString tip;
        bool separator = false;
        QString about{}; ///< shown in the open list only
    };
    std::vector<Entry> entries() const;
    Entry entryFor(const session::PortInfo& info) const;
    void refresh();
    void sync(const std::vector<Entry>& entries);
    void updatePath();
    void setCurrent(const QString& port);
    void activatedAt(int index);
    void showTip();

    session::PortWatcher& m_ports;
    QString m_port;
    QString m_key;     ///< of the adapter, as known while it was there
    QString m_shownAs; ///< its text while it was there
    QStringList m_typed;
    bool m_selectedByUser = false;
};
} // namespace ui
