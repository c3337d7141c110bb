// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commissioning/commission_batch_view.h"

#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/tone_delegate.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

namespace ui {
CommissionBatchView::CommissionBatchView(QWidget* parent)
    : QWidget(parent)
{
    build();
    connect(m_copy, &QPushButton::clicked, this, &CommissionBatchView::copyLabels);
    retranslate();
}

void CommissionBatchView::build()
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    m_table = new QTableView(this);
    m_table->setObjectName(QStringLiteral("commissionTable"));
    m_table->setModel(&m_model);
    m_table->setItemDelegate(new ToneDelegate(m_table));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setFrameShape(QFrame::NoFrame);
    styleTable(m_table);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    // The remarks on a servo are beside its verdict, visible at every width.
    m_table->horizontalHeader()->moveSection(CommissionModel::Remarks, 1);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_summary = new QLabel(this);
    m_summary->setObjectName(QStringLiteral("commissionSum"));
    m_summary->setWordWrap(true);
    m_copy = new QPushButton(this);
    m_copy->setObjectName(QStringLiteral("commissionCopy"));
    auto* foot = new QHBoxLayout;
    foot->addWidget(m_summary, 1);
    foot->addWidget(m_copy);
    column->addWidget(m_table, 1);
    column->addLayout(foot);
}

void CommissionBatchView::show(const results::CommissionBatch& batch)
{
    m_batch = batch;
    m_model.show(batch);
    // Qt does this by itself for new rows only.
    m_table->horizontalHeader()->resizeSections(QHeaderView::ResizeToContents);
    m_table->scrollToBottom();
    showSummary();
}

void CommissionBatchView::showSummary()
{
    m_summary->setText(tr("%1 done, %2 failed, %3 set aside, %4 unfinished")
                           .arg(m_batch.done())
                           .arg(m_batch.count(results::CommissionVerdict::Failed))
                           .arg(m_batch.count(results::CommissionVerdict::Skipped))
                           .arg(m_batch.pending.size()));
    m_copy->setEnabled(!m_model.labels({}).isEmpty());
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
    setAccessText(m_table, tr("Servos of the batch"),
                  tr("One line per servo, as in the batch file"));
    setButtonText(m_copy, tr("Copy labels"),
                  tr("Copies the labels of the selected (or all) servos, one per line"));
    m_model.retranslate();
    showSummary();
}

void CommissionBatchView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_copy != nullptr)
        retranslate();
}
} // namespace ui
