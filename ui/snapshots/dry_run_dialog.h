// SPDX-License-Identifier: GPL-3.0-or-later
// The exact steps of a restore before anything is written; they can be copied. Shows the plan it
// was given, which it does not follow afterwards; main thread.
#pragma once

#include "ui/snapshots/compare_model.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QTableWidget;

namespace ui {
class DryRunDialog final : public QDialog {
    Q_OBJECT

public:
    /// The model gives names and units.
    DryRunDialog(const CompareModel& model, const jobs::RestorePlan& plan, QWidget* parent);

private:
    struct Line {
        jobs::RestoreStep step;
        catalog::Text name{}; ///< of the register
        QString from{};
        QString to{};
    };
    void build();
    void retranslate();
    QString text() const; ///< all of it, for the clipboard

    QString alarmsText() const;

    struct AlarmLine {
        catalog::Text name{};
        QString fault{};
        QString limit{};
        QString reading{};
        bool selected = false;
    };
    std::vector<Line> m_lines;
    std::vector<AlarmLine> m_alarms;
    QString m_otherModel; ///< of the snapshot; empty: the model of the servo
    int m_id = -1;
    QLabel* m_title = nullptr;
    QLabel* m_warning = nullptr;
    QTableWidget* m_table = nullptr;
    QPushButton* m_copy = nullptr;
    QPushButton* m_close = nullptr;
};
} // namespace ui
