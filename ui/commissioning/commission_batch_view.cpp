// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commissioning/commission_batch_view.h"

#include "text/bus_text.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/fit_columns.h"
#include "ui/widgets/tone_delegate.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>

namespace ui {
CommissionBatchView::CommissionBatchView(QWidget* parent)
    : QWidget(parent)
{
    build();
    connect(m_copy, &QPushButton::clicked, this, &CommissionBatchView::copyLabels);
    connect(m_report, &QPushButton::clicked, this, &CommissionBatchView::reportRequested);
    followLanguage(this, [this] { retranslate(); });
}

void CommissionBatchView::build()
{
    auto* column = new QVBoxLayout(this);
    m_title = new QLabel(this);
    makeHeading(m_title);
    m_emptyLabel = new QLabel(this);
    m_emptyLabel->setObjectName(QStringLiteral("commissionNothing"));
    makeEmptyState(m_emptyLabel);
    m_table = new QTableView(this);
    m_table->setObjectName(QStringLiteral("commissionTable"));
    m_table->setModel(&m_model);
    m_table->setItemDelegate(new ToneDelegate(m_table));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setFrameShape(QFrame::NoFrame);
    styleTable(m_table);
    // The remarks on a servo are beside its verdict, visible at every width.
    m_table->horizontalHeader()->moveSection(CommissionModel::Remarks, 1);
    m_columns = new FitColumns(m_table);
    m_summary = new QLabel(this);
    m_summary->setObjectName(QStringLiteral("commissionSum"));
    m_summary->setWordWrap(true);
    m_copy = new QPushButton(this);
    m_copy->setObjectName(QStringLiteral("commissionCopy"));
    m_report = new QPushButton(this);
    m_report->setObjectName(QStringLiteral("commissionReport"));
    auto* head = new QHBoxLayout;
    head->setSpacing(12);
    head->addWidget(m_title, 1);
    head->addWidget(m_copy);
    head->addWidget(m_report);
    column->addLayout(head);
    column->addWidget(m_summary);
    column->addWidget(m_table, 1);
    column->addWidget(m_emptyLabel, 1);
    makeCard(this);
}

void CommissionBatchView::show(const results::CommissionBatch& batch)
{
    m_batch = batch;
    m_model.show(batch);
    const auto any = [&batch](auto has) {
        return std::any_of(batch.rows.begin(), batch.rows.end(), has);
    };
    // What no servo of the batch has takes no room.
    m_table->setColumnHidden(CommissionModel::Remarks,
                             !any([](const auto& row) { return !row.issues.empty(); }));
    m_table->setColumnHidden(CommissionModel::Written,
                             !any([](const auto& row) { return !row.templateName.isEmpty(); }));
    m_columns->fit();
    m_table->scrollToBottom();
    showSummary();
}

void CommissionBatchView::setIds(const std::vector<int>& ids)
{
    m_ids = ids;
    showSummary();
}

/// "4–6, 9"; with their number, if that is not seen at once.
QString CommissionBatchView::idsToComeText() const
{
    constexpr std::size_t maxUncounted = 4;
    std::vector<int> left;
    std::copy_if(m_ids.begin(), m_ids.end(), std::back_inserter(left),
                 [this](int id) { return !m_batch.isIdTaken(id); });
    const QString ids = text::idRangesText(left);
    const int count = static_cast<int>(left.size());
    return left.size() > maxUncounted ? tr("%1 (%n ID(s))", nullptr, count).arg(ids) : ids;
}

void CommissionBatchView::showSummary()
{
    const int failed = m_batch.count(results::CommissionVerdict::Failed);
    const int aside = m_batch.count(results::CommissionVerdict::Skipped);
    const int unfinished = static_cast<int>(m_batch.pending.size());
    QStringList parts{tr("%1 done").arg(m_batch.done())};
    if (failed > 0)
        parts << tr("%1 failed").arg(failed);
    if (aside > 0)
        parts << tr("%1 set aside").arg(aside);
    if (unfinished > 0)
        parts << tr("%1 unfinished").arg(unfinished);
    if (const QString ids = idsToComeText(); !ids.isEmpty())
        parts << tr("Next IDs: %1").arg(ids);
    m_summary->setText(parts.join(QStringLiteral(" · ")));
    m_table->setVisible(!m_batch.rows.empty());
    m_emptyLabel->setVisible(m_batch.rows.empty());
    m_copy->setEnabled(!m_model.labels({}).isEmpty());
    m_report->setEnabled(!m_batch.rows.empty());
}

void CommissionBatchView::copyLabels()
{
    QList<int> rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows())
        rows.append(index.row());
    QGuiApplication::clipboard()->setText(m_model.labels(rows).join(QLatin1Char('\n')));
}

void CommissionBatchView::retranslate()
{
    m_title->setText(tr("Servos"));
    m_emptyLabel->setText(
        tr("No servo has been set up yet. Click Start, then connect the first servo."));
    setAccessText(m_table, tr("Servos in the batch"),
                  tr("One row per servo, as in the batch file"));
    setButtonText(m_copy, tr("Copy labels"),
                  tr("Copies the labels of the selected servos, or of all servos if none is "
                     "selected, one per line"));
    setButtonText(m_report, tr("Save report…"),
                  tr("Saves the batch as a report to hand over with the servos"));
    m_model.retranslate();
    showSummary();
}
} // namespace ui
