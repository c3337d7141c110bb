// SPDX-License-Identifier: GPL-3.0-or-later
// Earlier sweep tests: found again, labeled, compared, one of a model marked as the reference,
// their reports saved, deleted. Stays open beside the window and follows the history, which must
// outlive it. Main thread, never waits.
#pragma once

#include "session/settings.h"
#include "ui/widgets/run_list_dialog.h"

namespace ui {
class RunsDialog final : public RunListDialog {
    Q_OBJECT

public:
    RunsDialog(session::HistoryService& historyService, session::Settings& settings,
               QWidget* parent);

protected:
    void retranslate() override;
    void updateButtons() override;
    QString deletionText() const override;

private:
    static QString noReferenceReason(const history::TestRun& run, const history::TestServo& servo);
    void openReport();
    void saveReport(const RunRow& row, const QString& path, const QStringList& files);
    void compare();
    void markReference();
    void showSaved(const QString& path);

    session::Settings& m_settings;
    QPushButton* m_report;
    QPushButton* m_compare;
    QPushButton* m_reference;
};

/// "Hysteresis, both sides +5 step (worse)", after "Compared with reference STS3215 (test of 12
/// Nov):"; what the sweep page shows after a run. Empty: no reference.
QString referenceText(const session::ReferenceResult& result);
} // namespace ui
