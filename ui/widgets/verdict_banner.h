// SPDX-License-Identifier: GPL-3.0-or-later
// The outcome of a test at a glance: the grade in large letters, its reason, and below them a chip
// for each servo tested, which shows that servo. Owned by its parent; main thread.
#pragma once

#include "ui/common/theme.h"

#include <QFrame>

#include <vector>

class QButtonGroup;
class QLabel;

namespace ui {
struct VerdictChip {
    QString text; ///< "✘ ID 2"
    Tone tone = Tone::Quiet;
    QString tip; ///< which servo, its grade and why, in words; also for screen readers
};

class VerdictBanner final : public QFrame {
    Q_OBJECT

public:
    explicit VerdictBanner(QWidget* parent);

    void setVerdict(Tone tone, const QString& grade, const QString& reason = {});
    /// None for a single servo. The same number of chips keeps the buttons and their focus.
    void setChips(const std::vector<VerdictChip>& chips, int selected);
    QString text() const; ///< "FAIL: Overshoot"

Q_SIGNALS:
    void chipClicked(int index);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Tone m_tone = Tone::Quiet;
    QLabel* m_grade;
    QLabel* m_reason;
    QWidget* m_chipRow;
    QButtonGroup* m_chips;
};
} // namespace ui
