// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/rate_chooser.h"

#include "session/session.h"
#include "ui/common/follow_language.h"
#include "ui/widgets/rate_text.h"

#include <QListWidget>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
RateChooser::RateChooser(QWidget* parent)
    : PopupFrame("rateChooser", parent)
    , m_list(new QListWidget(this))
{
    setFocusProxy(m_list);
    m_list->setObjectName(QStringLiteral("rateList"));
    for (const int rate : session::standardBaudRates()) {
        auto* item = new QListWidgetItem(rateText(rate), m_list);
        item->setData(Qt::UserRole, rate);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsUserCheckable | Qt::ItemIsSelectable);
        item->setCheckState(Qt::Unchecked);
    }
    m_list->setMinimumHeight(m_list->sizeHintForRow(0) * (m_list->count() + 1));
    m_list->setMinimumWidth(m_list->sizeHintForColumn(0) + 40);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(2, 2, 2, 2);
    column->addWidget(m_list);
    connect(m_list, &QListWidget::itemChanged, this, &RateChooser::changed);
    followLanguage(this, [this] { retranslate(); });
}

std::vector<int> RateChooser::rates() const
{
    std::vector<int> rates;
    for (int row = 0; row < m_list->count(); ++row) {
        if (m_list->item(row)->checkState() == Qt::Checked)
            rates.push_back(m_list->item(row)->data(Qt::UserRole).toInt());
    }
    return rates;
}

void RateChooser::setRates(const std::vector<int>& rates)
{
    const QSignalBlocker quiet(m_list);
    for (int row = 0; row < m_list->count(); ++row) {
        QListWidgetItem* item = m_list->item(row);
        const bool on =
            std::find(rates.begin(), rates.end(), item->data(Qt::UserRole).toInt()) != rates.end();
        item->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    }
}

void RateChooser::retranslate()
{
    m_list->setAccessibleName(tr("Baud rates to search"));
    m_list->setToolTip(tr("Select the baud rates to search; you can also use the space bar"));
}
} // namespace ui
