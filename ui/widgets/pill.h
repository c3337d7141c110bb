// SPDX-License-Identifier: GPL-3.0-or-later
// A short state in a rounded frame: a light in its tone and a text; a shorter text where space is
// scarce, and then the whole in the tooltip. Filled, it is a conspicuous badge. Owned by its
// parent; main thread.
#pragma once

#include "ui/common/theme.h"

#include <QWidget>

namespace ui {
class Pill final : public QWidget {
    Q_OBJECT

public:
    explicit Pill(QWidget* parent = nullptr, bool filled = false);

    /// `brief` where `words` find no room; the tooltip begins with `words` and goes on with `more`.
    void setState(Tone light, const QString& words, const QString& shortText = {},
                  const QString& more = {});
    const QString& text() const { return m_text; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    int widthFor(const QString& text) const;

    bool m_filled;
    Tone m_tone = Tone::Quiet;
    QString m_text;
    QString m_shortText;
};
} // namespace ui
