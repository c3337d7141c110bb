// SPDX-License-Identifier: GPL-3.0-or-later
// The language of the whole window, Qt's own dialogs included; switchable while the program runs
// (widgets hear of it as QEvent::LanguageChange). One for the program; main thread.
#pragma once

#include <QObject>
#include <QTranslator>

namespace ui {
class LanguageSwitch final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// "en", "zh_CN"; empty: the system's. What is not known is English.
    void apply(const QString& language);
    bool chinese() const;
    /// Without a font for it Chinese would be empty boxes.
    static bool canShowChinese();

Q_SIGNALS:
    void changed();

private:
    QTranslator m_qt; ///< the words of Qt's dialogs
};
} // namespace ui
