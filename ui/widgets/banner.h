// SPDX-License-Identifier: GPL-3.0-or-later
// Shows in the window what went wrong, why, and what to do about it, until it is closed or hidden;
// it never blocks. The text can be copied. A function provides the text, so that it follows the
// language. Owned by the window; main thread.
#pragma once

#include "base/error.h"
#include "ui/common/theme.h"

#include <QFrame>

#include <functional>

class QAction;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace ui {
struct BannerText {
    Tone tone = Tone::Bad;
    QString message;
    QString cause{};
    QString remedy{};
};

class Banner final : public QFrame {
    Q_OBJECT

public:
    using TextProvider = std::function<BannerText()>;

    explicit Banner(QWidget* parent = nullptr);

    /// Replaces the previous message. Each action becomes a button; it stays owned by its owner.
    void showMessage(TextProvider textProvider, const QList<QAction*>& actions = {});
    void showMessage(const base::Error& error, const QList<QAction*>& actions = {});
    /// Hides it, without `dismissed`.
    void hideMessage();

Q_SIGNALS:
    void messageReplaced(); ///< another one is about to be shown
    void dismissed();       ///< closed by the user

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void fill();

    TextProvider m_textProvider;
    Tone m_tone = Tone::Bad;
    QLabel* m_symbol;
    QLabel* m_what;
    QLabel* m_more;
    QHBoxLayout* m_buttons;
    QToolButton* m_close;
};
} // namespace ui
