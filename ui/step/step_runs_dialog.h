// SPDX-License-Identifier: GPL-3.0-or-later
// Earlier step responses: found again, labeled, deleted, and opened on the step page, where the
// next run is compared with them. Shows what a selected one has measured. Stays open next to the
// window and follows the history, which must outlive it. Main thread, never waits.
#pragma once

#include "catalog/catalog.h"
#include "ui/widgets/run_list_dialog.h"

namespace ui {
class StepRunsDialog final : public RunListDialog {
    Q_OBJECT

public:
    StepRunsDialog(session::HistoryService& historyService, const catalog::Catalog& catalog,
                   QWidget* parent);

Q_SIGNALS:
    void openRequested(const std::vector<std::int64_t>& numbers); ///< oldest first

protected:
    void retranslate() override;
    void updateButtons() override;
    QString deletionText() const override;

private:
    void openSelected();
    void showDetails(std::int64_t number);

    catalog::Catalog m_catalog; ///< its data is shared
    QPushButton* m_open;
    std::int64_t m_detailsOf = 0; ///< the run that the hint describes or will describe
};
} // namespace ui
