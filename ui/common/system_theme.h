// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the desktop is light or dark: the palette of the application at its start, then what the
// desktop portal reports. Without a portal there is no answer. Main thread; asks without waiting.
#pragma once

#include <QDBusVariant>
#include <QObject>

namespace ui {
class SystemTheme final : public QObject {
    Q_OBJECT

public:
    /// Needs the QApplication, before it gets a palette of its own.
    explicit SystemTheme(QObject* parent = nullptr);

    bool usesDarkTheme() const { return m_dark; }

Q_SIGNALS:
    void changed();

private Q_SLOTS:
    void portalSetting(const QString& group, const QString& key, const QDBusVariant& value);

private:
    void askPortal();

    bool m_dark;
};
} // namespace ui
