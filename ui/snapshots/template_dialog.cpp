// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/template_dialog.h"

#include "catalog/value.h"
#include "device/write_meaning.h"
#include "jobs/restore/restore_rows.h"
#include "text/language.h"
#include "ui/common/dialog_sizes.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr int templateWidth = 520;
constexpr int templateHeight = 560;
constexpr int keyRole = Qt::UserRole;

/// Settings that other servos can have: no identity and no present values.
bool isTransferable(const catalog::Register& reg)
{
    using jobs::RestoreReason;
    const auto nature = jobs::registerReasons(reg);
    return !(nature & (jobs::RestoreReasons(RestoreReason::ReadOnly) | RestoreReason::Factory |
                       RestoreReason::Identity | RestoreReason::Live));
}
} // namespace

TemplateDialog::TemplateDialog(const snapshot::Snapshot& from, catalog::ProfilePtr profile,
                               QWidget* parent)
    : QDialog(parent)
    , m_profile(std::move(profile))
    , m_summary(new QLabel(this))
    , m_table(new QTableWidget(0, 3, this))
    , m_buttons(new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel, this))
{
    setObjectName(QStringLiteral("templateDialog"));
    rememberSize(*this);
    setAttribute(Qt::WA_DeleteOnClose);
    m_summary->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("templateTable"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    styleTable(m_table);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_buttons->button(QDialogButtonBox::Save)->setObjectName(QStringLiteral("templateSave"));
    makeMainAction(m_buttons->button(QDialogButtonBox::Save));
    m_buttons->button(QDialogButtonBox::Cancel)->setObjectName(QStringLiteral("templateCancel"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_summary);
    column->addWidget(m_table, 1);
    column->addWidget(m_buttons);
    connect(m_table, &QTableWidget::itemChanged, this, &TemplateDialog::updateCount);
    connect(m_buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(m_buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    fill(from);
    followLanguage(this, [this] { retranslate(); });
    resize(templateWidth, templateHeight);
}

void TemplateDialog::fill(const snapshot::Snapshot& from)
{
    const QSignalBlocker blocker(m_table);
    const auto lookup = [&](const QString& key) -> std::optional<std::int64_t> {
        const snapshot::SnapshotRegister* other = from.find(key);
        return other != nullptr ? other->raw : std::nullopt;
    };
    for (const catalog::Register& reg : m_profile->registers) {
        const snapshot::SnapshotRegister* has = from.find(reg.key);
        if (has == nullptr || !has->raw || !isTransferable(reg))
            continue;
        const int row = m_table->rowCount();
        m_table->insertRow(row);
        auto* tick = new QTableWidgetItem;
        tick->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        tick->setData(keyRole, reg.key);
        const bool own = reg.defaultRaw && *reg.defaultRaw != *has->raw &&
                         !device::alwaysNeedsConsent(reg) && reg.area == catalog::Area::Eprom;
        tick->setCheckState(own ? Qt::Checked : Qt::Unchecked);
        m_table->setItem(row, 0, tick);
        m_table->setItem(row, 1, new QTableWidgetItem(QString::number(qint64(*has->raw))));
        const QString words = catalog::formatValue(
            *has->raw, reg, catalog::valueFormat(reg, *m_profile, lookup), text::isUiChinese());
        m_table->setItem(row, 2, new QTableWidgetItem(words));
        m_table->item(row, 1)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
}

QStringList TemplateDialog::keys() const
{
    QStringList selected;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        if (m_table->item(row, 0)->checkState() == Qt::Checked)
            selected << m_table->item(row, 0)->data(keyRole).toString();
    }
    return selected;
}

void TemplateDialog::updateCount()
{
    QPushButton* save = m_buttons->button(QDialogButtonBox::Save);
    const auto count = keys().size();
    save->setText(tr("Save %n row(s)…", nullptr, int(count)));
    save->setAccessibleName(save->text());
    save->setEnabled(count > 0);
}

void TemplateDialog::retranslate()
{
    setWindowTitle(tr("Create a template"));
    setAccessibleName(windowTitle());
    m_summary->setText(
        tr("Select the rows to write to other servos. ID and baud rate are never part of a "
           "template. Rows that differ from the factory defaults are preselected."));
    m_table->setAccessibleName(tr("Rows of the template"));
    m_table->setHorizontalHeaderLabels({tr("Register"), tr("Value"), tr("Meaning")});
    m_table->horizontalHeaderItem(1)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const QSignalBlocker blocker(m_table);
    for (int row = 0; row < m_table->rowCount(); ++row) {
        QTableWidgetItem* item = m_table->item(row, 0);
        const QString key = item->data(keyRole).toString();
        item->setText(text::localized(m_profile->find(key)->name));
        item->setToolTip(key);
    }
    m_buttons->button(QDialogButtonBox::Save)->setToolTip(tr("Saves the selected rows to a file"));
    QPushButton* cancel = m_buttons->button(QDialogButtonBox::Cancel);
    cancel->setText(tr("Cancel"));
    cancel->setAccessibleName(cancel->text());
    cancel->setToolTip(tr("Closes without saving"));
    updateCount();
}
} // namespace ui
