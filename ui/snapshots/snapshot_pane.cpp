// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/snapshot_pane.h"

#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/widgets/fit_columns.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/tone_delegate.h"

#include <QEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {
SnapshotPane::SnapshotPane(QWidget* parent)
    : QWidget(parent)
{
    build();
    m_filter.setSourceModel(&m_model);
    m_table->setModel(&m_filter);
    m_fit = new FitColumns(m_table, CompareModel::Address);
    connect(&m_model, &CompareModel::modelReset, m_fit, &FitColumns::fit);
    connect(m_all, &QToolButton::toggled, this, [this](bool all) {
        m_filter.setAll(all);
        showCounts();
        m_fit->fit();
    });
    followLanguage(this, [this] { retranslate(); });
}

void SnapshotPane::build()
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(6);
    m_title = new QLabel(this);
    m_title->setObjectName(QStringLiteral("compareTitle"));
    m_title->setWordWrap(true);
    m_title->setTextFormat(Qt::PlainText);
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    auto* row = new FlowLayout(nullptr, 6);
    const auto pill = [&](const char* name) {
        auto* made = new Pill(this);
        made->setObjectName(QString::fromLatin1(name));
        row->addWidget(made);
        return made;
    };
    m_age = pill("compareAge");
    m_different = pill("compareDifferent");
    m_excluded = pill("compareNever");
    m_same = pill("compareSame");
    m_otherRows = pill("compareRest");
    m_all = new QToolButton(this);
    m_all->setObjectName(QStringLiteral("compareAll"));
    m_all->setCheckable(true);
    m_columns = new QToolButton(this);
    m_columns->setObjectName(QStringLiteral("compareColumns"));
    m_columns->setPopupMode(QToolButton::InstantPopup);
    row->addWidget(m_all);
    row->addWidget(m_columns);
    m_table = new QTableView(this);
    m_table->setObjectName(QStringLiteral("compareTable"));
    m_table->setItemDelegate(new ToneDelegate(m_table));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setFrameShape(QFrame::NoFrame);
    styleTable(m_table);
    m_table->installEventFilter(this);
    m_emptyLabel = new QLabel(this);
    m_emptyLabel->setObjectName(QStringLiteral("compareNothing"));
    makeEmptyState(m_emptyLabel);
    column->addWidget(m_title);
    column->addLayout(row);
    column->addWidget(m_emptyLabel, 1);
    column->addWidget(m_table, 1);
}

void SnapshotPane::show(const QString& title, std::vector<CompareColumn> tables,
                        std::optional<jobs::RestorePlan> plan, const QString& emptyText,
                        const QStringList& ages)
{
    m_ages = ages;
    m_title->setText(title);
    m_emptyLabel->setText(emptyText);
    m_model.show(std::move(tables), std::move(plan));
    showCounts();
}

void SnapshotPane::showCounts()
{
    const snapshot::SnapshotComparison& found = m_model.comparison();
    const bool some = !m_model.tables().empty();
    const bool several = m_model.tables().size() > 1;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_different, m_same, m_otherRows, m_all})
        widget->setVisible(some && several);
    m_filter.setAll(m_all->isChecked() || !several);
    const QStringList never = m_model.unrestorableRows();
    const int different = found.different - int(never.size());
    const bool current = m_ages.isEmpty();
    const Tone good = current ? Tone::Good : Tone::Quiet;
    m_age->setVisible(some && !current);
    m_age->setState(Tone::Warn, current ? QString() : m_ages.front(), {},
                    m_ages.mid(1).join(QLatin1Char('\n')));
    m_different->setState(different > 0 ? Tone::Accent : good,
                          different > 0 ? tr("≠ %1 different").arg(different)
                          : current     ? tr("= no differences")
                                        : tr("= no differences at that time"));
    m_excluded->setVisible(some && several && !never.isEmpty());
    m_excluded->setState(Tone::Quiet, tr("≠ %1 never restored").arg(never.size()), {},
                         never.join(QLatin1Char('\n')));
    m_same->setState(good, tr("= %1 identical").arg(found.identical));
    m_otherRows->setState(
        Tone::Quiet,
        tr("%1 read-only, %2 missing, %3 unknown")
            .arg(found.readOnly)
            .arg(found.missing)
            .arg(found.unknown),
        tr("%n other(s)", nullptr, int(found.readOnly + found.missing + found.unknown)));
    const bool empty = m_filter.rowCount() == 0;
    if (some && empty)
        m_emptyLabel->setText(current ? tr("No writable setting differs.")
                                      : tr("No writable setting differed when the servo was last "
                                           "read."));
    m_emptyLabel->setVisible(empty);
    m_table->setVisible(!empty);
}

void SnapshotPane::toggleCheck()
{
    const QModelIndex current = m_table->currentIndex();
    if (!current.isValid())
        return;
    const QModelIndex cell = m_filter.mapToSource(current).siblingAtColumn(CompareModel::Name);
    const bool on = m_model.data(cell, Qt::CheckStateRole).toInt() == Qt::Checked;
    m_model.setData(cell, on ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
}

/// The space bar ticks the row in any column.
bool SnapshotPane::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_table && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
        toggleCheck();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void SnapshotPane::retranslate()
{
    m_all->setText(tr("All rows"));
    m_all->setAccessibleName(m_all->text());
    m_all->setToolTip(tr("Shows identical and read-only rows too"));
    m_columns->setText(tr("Columns"));
    m_columns->setAccessibleName(m_columns->text());
    m_columns->setToolTip(tr("Adds the factory defaults or other servos to the comparison; "
                             "Ctrl+click snapshots to add them too"));
    m_table->setAccessibleName(tr("Memory tables side by side"));
    m_table->setToolTip(tr("The space bar selects a row for writing"));
    m_model.retranslate();
    m_fit->fit();
    showCounts();
}
} // namespace ui
