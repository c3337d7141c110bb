// SPDX-License-Identifier: GPL-3.0-or-later
// What the program remembers between starts: language, theme, window, the port used last and how
// each adapter was used. One ini file in the user's configuration folder; main thread. A file that
// is broken, from another version or holds nonsense never stops the start: what cannot be used is
// left at its default, a broken file is put aside first and named in brokenCopy(). What a newer
// version has written there and this one does not know stays in the file.
#pragma once

#include "session/connection.h"

#include <QSettings>

namespace session {
enum class Theme : std::uint8_t { System, Light, Dark };

class Settings {
public:
    /// Empty: servodesk.ini in the configuration folder.
    explicit Settings(const QString& path = {});

    QString path() const { return m_file.fileName(); }
    /// Where a file that could not be read was put; empty when all was well.
    const QString& brokenCopy() const { return m_brokenCopy; }

    QString language() const; ///< "en", "zh_CN", empty: the system's
    void setLanguage(const QString& language);
    Theme theme() const;
    void setTheme(Theme theme);

    QString lastPort() const;    ///< empty: nothing was ever opened
    QString lastAdapter() const; ///< its key: the adapter may be at another port today
    /// How this adapter (PortWatcher::adapterKey) was used last; baud, protocol … not set if never.
    PortRequest lastRequestFor(const QString& adapterKey) const;
    void saveRequest(const QString& adapterKey, const PortRequest& request);

    QByteArray windowGeometry() const;
    QByteArray windowState() const;
    void setWindow(const QByteArray& geometry, const QByteArray& state);

    /// A page's own small choices ("memory/physical_first"). The default's type decides; a stored
    /// value of another type is passed over.
    QVariant pageValue(const QString& key, const QVariant& byDefault) const;
    void setPageValue(const QString& key, const QVariant& value);

private:
    void write(const QString& key, const QVariant& value);
    QString readText(const QString& key) const;
    std::optional<int> readNumber(const QString& key, int min, int max) const;

    QString m_brokenCopy;
    mutable QSettings m_file;
};
} // namespace session
