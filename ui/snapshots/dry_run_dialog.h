// SPDX-License-Identifier: GPL-3.0-or-later
// Exactly what restoring would do, step by step, before anything is written; can be copied. A
// picture of the plan it was given; main thread.
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

protected:
    void changeEvent(QEvent* event) override;

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
    QString m_otherModel; ///< that the snapshot is of; empty: of this one
    int m_id = -1;
    QLabel* m_title = nullptr;
    QLabel* m_warning = nullptr;
    QTableWidget* m_table = nullptr;
    QPushButton* m_copy = nullptr;
    QPushButton* m_close = nullptr;
};
} // namespace ui
