// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/dry_run_dialog.h"

#include "text/language.h"
#include "text/restore_text.h"
#include "ui/common/dialog_sizes.h"
#include "ui/common/follow_language.h"
#include "ui/common/theme.h"
#include "ui/common/widget_style.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr int dryRunWidth = 640;
constexpr int dryRunHeight = 460;
} // namespace

DryRunDialog::DryRunDialog(const CompareModel& model, const jobs::RestorePlan& plan,
                           QWidget* parent)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("dryRunDialog"));
    rememberSize(*this);
    setAttribute(Qt::WA_DeleteOnClose);
    m_id = plan.id;
    const auto value = [&](const jobs::RestoreStep& step, std::optional<std::int64_t> raw) {
        return raw ? model.formatted(step.key, *raw) : QString();
    };
    for (const jobs::RestoreStep& step : jobs::plannedSteps(plan)) {
        const catalog::Register* reg = model.tables().front().profile->find(step.key);
        m_lines.push_back({step, reg != nullptr ? reg->name : catalog::Text{step.key, step.key},
                           value(step, step.from), value(step, step.to)});
    }
    for (const jobs::RestoreRow* row : jobs::predictedAlarms(plan)) {
        const catalog::Register& reg = *plan.servo.profile->find(row->key);
        m_alarms.push_back({reg.name, row->alarm, model.formatted(row->key, *row->newRaw),
                            readingText(*row), row->selected});
    }
    if (plan.otherModel)
        m_otherModel = plan.sourceModel;
    build();
    followLanguage(this, [this] { retranslate(); });
}

void DryRunDialog::build()
{
    auto* column = new QVBoxLayout(this);
    m_title = new QLabel(this);
    m_title->setWordWrap(true);
    m_warning = new QLabel(this);
    m_warning->setObjectName(QStringLiteral("dryRunWarning"));
    m_warning->setWordWrap(true);
    m_warning->setTextFormat(Qt::PlainText);
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, tone(Tone::Bad, palette()));
    m_warning->setPalette(colors);
    m_table = new QTableWidget(0, 4, this);
    m_table->setObjectName(QStringLiteral("dryRunTable"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    styleTable(m_table);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_copy = new QPushButton(this);
    m_copy->setObjectName(QStringLiteral("dryRunCopy"));
    m_copy->setAutoDefault(false);
    m_close = new QPushButton(this);
    m_close->setObjectName(QStringLiteral("dryRunClose"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_copy);
    row->addStretch();
    row->addWidget(m_close);
    column->addWidget(m_title);
    column->addWidget(m_warning);
    column->addWidget(m_table, 1);
    column->addLayout(row);
    connect(m_copy, &QPushButton::clicked, this,
            [this] { QApplication::clipboard()->setText(text()); });
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    resize(dryRunWidth, dryRunHeight);
    m_close->setFocus();
}

void DryRunDialog::retranslate()
{
    setWindowTitle(tr("What would be written"));
    setAccessibleName(windowTitle());
    m_title->setText(m_lines.empty()
                         ? tr("ID %1: nothing to write. All selected rows already match.").arg(m_id)
                         : tr("ID %1: the rows will be written in this order, and each will be "
                              "read back. Nothing has been written yet.")
                               .arg(m_id));
    const QString warning = alarmsText();
    m_warning->setText(warning);
    m_warning->setVisible(!warning.isEmpty());
    m_table->setAccessibleName(tr("Steps"));
    m_table->setHorizontalHeaderLabels({tr("Step"), tr("Register"), tr("Old"), tr("New")});
    m_table->setRowCount(int(m_lines.size()));
    int row = 0;
    for (const Line& line : m_lines) {
        const QString step = text::restoreStepText(jobs::restoreStepName(line.step.kind));
        const QStringList cells{step,
                                line.step.key.isEmpty() ? QString() : text::localized(line.name),
                                line.from, line.to};
        for (int column = 0; column < int(cells.size()); ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            item->setToolTip(column == 1 ? line.step.key : cells[column]);
            m_table->setItem(row, column, item);
        }
        ++row;
    }
    m_copy->setText(tr("Copy"));
    m_copy->setAccessibleName(m_copy->text());
    m_copy->setToolTip(tr("Copies the steps as text"));
    m_close->setText(tr("Close"));
    m_close->setAccessibleName(m_close->text());
    m_close->setToolTip(tr("Closes the dialog; nothing is written"));
}

/// Which limits the servo's readings are outside of, selected or not.
QString DryRunDialog::alarmsText() const
{
    QStringList lines;
    if (!m_otherModel.isEmpty())
        lines << tr("The snapshot is from a different model: %1.").arg(m_otherModel);
    for (const AlarmLine& alarm : m_alarms) {
        const QString words = text::restoreAlarmText(alarm.fault, alarm.limit, alarm.reading);
        const QString name = text::localized(alarm.name);
        lines << (alarm.selected ? tr("✗ %1: %2").arg(name, words)
                                 : tr("%1, not selected: %2").arg(name, words));
    }
    return lines.join(QLatin1Char('\n'));
}

QString DryRunDialog::text() const
{
    QStringList lines;
    if (const QString warning = alarmsText(); !warning.isEmpty())
        lines << warning;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        QStringList cells{QString::number(row + 1)};
        for (int column = 0; column < m_table->columnCount(); ++column)
            cells << m_table->item(row, column)->text();
        lines << cells.join(QLatin1Char('\t'));
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}
} // namespace ui
