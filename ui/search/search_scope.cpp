// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/search/search_scope.h"

#include "session/session.h"
#include "text/bus_text.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/rate_chooser.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

#include <algorithm>

namespace ui {
namespace {
constexpr int maxSearchId = 253;
enum Rates { ThisRate, ChosenRates, AllRates };
enum Protocols { AsConnected, AllProtocols, FirstProtocol }; ///< then those of base, in order

const QString firstKey = QStringLiteral("search/first_id");
const QString lastKey = QStringLiteral("search/last_id");
const QString ratesKey = QStringLiteral("search/rates");
const QString chosenKey = QStringLiteral("search/chosen_rates");
const QString protocolKey = QStringLiteral("search/protocol");
const QString slowKey = QStringLiteral("search/slow");
} // namespace

SearchScope::SearchScope(session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_idLabel(new QLabel(this))
    , m_first(new QSpinBox(this))
    , m_last(new QSpinBox(this))
    , m_rates(new QComboBox(this))
    , m_choose(new QToolButton(this))
    , m_chooser(new RateChooser(this))
    , m_protocol(new QComboBox(this))
    , m_slow(new QCheckBox(this))
{
    build();
    load();
    const auto edited = [this] {
        updateFields();
        save();
        Q_EMIT changed();
    };
    for (QSpinBox* box : {m_first, m_last})
        connect(box, &QSpinBox::valueChanged, this, edited);
    for (QComboBox* box : {m_rates, m_protocol})
        connect(box, &QComboBox::currentIndexChanged, this, edited);
    connect(m_chooser, &RateChooser::changed, this, edited);
    connect(m_slow, &QCheckBox::toggled, this, edited);
    connect(m_choose, &QToolButton::clicked, this, [this] { m_chooser->popUpBelow(*m_choose); });
    // Choosing rates begins with showing them.
    connect(m_rates, &QComboBox::activated, this, [this](int index) {
        if (index == ChosenRates)
            m_chooser->popUpBelow(*m_choose);
    });
    followLanguage(this, [this] { retranslate(); });
}

void SearchScope::build()
{
    setObjectName(QStringLiteral("searchScope"));
    m_first->setObjectName(QStringLiteral("firstId"));
    m_last->setObjectName(QStringLiteral("lastId"));
    m_rates->setObjectName(QStringLiteral("searchRates"));
    m_choose->setObjectName(QStringLiteral("chooseRates"));
    m_protocol->setObjectName(QStringLiteral("searchProtocol"));
    m_slow->setObjectName(QStringLiteral("searchSlowly"));
    for (QSpinBox* box : {m_first, m_last}) {
        box->setRange(0, maxSearchId);
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    }
    for (int i = 0; i < 3; ++i)
        m_rates->addItem(QString());
    for (int i = 0; i < FirstProtocol + int(base::allProtocols.size()); ++i)
        m_protocol->addItem(QString());
    m_choose->setText(QStringLiteral("…"));
    m_choose->setFocusPolicy(Qt::StrongFocus);
    auto* ids = new QHBoxLayout;
    ids->addWidget(m_idLabel);
    ids->addWidget(m_first);
    ids->addWidget(new QLabel(QStringLiteral("–"), this));
    ids->addWidget(m_last);
    ids->addWidget(m_rates, 1);
    ids->addWidget(m_choose);
    auto* more = new QHBoxLayout;
    more->addWidget(m_protocol, 1);
    more->addWidget(m_slow);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(ids);
    column->addLayout(more);
}

void SearchScope::load()
{
    m_first->setValue(m_settings.pageValue(firstKey, 0).toInt());
    m_last->setValue(m_settings.pageValue(lastKey, maxSearchId).toInt());
    m_rates->setCurrentIndex(qBound(0, m_settings.pageValue(ratesKey, 0).toInt(), int(AllRates)));
    m_protocol->setCurrentIndex(
        qBound(0, m_settings.pageValue(protocolKey, 0).toInt(), m_protocol->count() - 1));
    m_slow->setChecked(m_settings.pageValue(slowKey, false).toBool());
    std::vector<int> chosen;
    const QStringList defaultRates{QStringLiteral("1000000"), QStringLiteral("115200")};
    for (const QString& rate : m_settings.pageValue(chosenKey, defaultRates).toStringList())
        chosen.push_back(rate.toInt());
    m_chooser->setRates(chosen);
    updateFields();
}

void SearchScope::save()
{
    m_settings.setPageValue(firstKey, m_first->value());
    m_settings.setPageValue(lastKey, m_last->value());
    m_settings.setPageValue(ratesKey, m_rates->currentIndex());
    m_settings.setPageValue(protocolKey, m_protocol->currentIndex());
    m_settings.setPageValue(slowKey, m_slow->isChecked());
    QStringList chosen;
    for (const int rate : m_chooser->rates())
        chosen << QString::number(rate);
    m_settings.setPageValue(chosenKey, chosen);
}

void SearchScope::updateFields()
{
    m_choose->setVisible(m_hasBaud && m_rates->currentIndex() == ChosenRates);
    m_rates->setEnabled(m_hasBaud);
}

void SearchScope::setHasBaud(bool canSetBaud)
{
    if (m_hasBaud == canSetBaud)
        return;
    m_hasBaud = canSetBaud;
    updateFields();
    retranslate();
}

jobs::ScanSpec SearchScope::spec() const
{
    jobs::ScanSpec spec;
    spec.firstId = std::min(m_first->value(), m_last->value());
    spec.lastId = std::max(m_first->value(), m_last->value());
    if (m_hasBaud && m_rates->currentIndex() == ChosenRates)
        spec.bauds = m_chooser->rates();
    if (m_hasBaud && m_rates->currentIndex() == AllRates)
        spec.bauds = session::standardBaudRates();
    const int protocol = m_protocol->currentIndex();
    if (protocol == AllProtocols)
        spec.protocols.assign(base::allProtocols.begin(), base::allProtocols.end());
    else if (protocol >= FirstProtocol)
        spec.protocols = {base::allProtocols[std::size_t(protocol - FirstProtocol)]};
    spec.slowPass = m_slow->isChecked();
    return spec;
}

void SearchScope::retranslate()
{
    const QSignalBlocker ratesBlocker(m_rates);
    const QSignalBlocker protocolBlocker(m_protocol);
    m_idLabel->setText(tr("ID"));
    setAccessText(m_first, tr("First ID"), tr("First ID to search"));
    setAccessText(m_last, tr("Last ID"), tr("Last ID to search"));
    m_rates->setItemText(ThisRate, tr("Current baud rate"));
    m_rates->setItemText(ChosenRates, tr("Selected baud rates"));
    m_rates->setItemText(AllRates, tr("All baud rates"));
    setAccessText(m_rates, tr("Baud rates"),
                  m_hasBaud
                      ? tr("Baud rates to search; the port's own baud rate is restored afterwards")
                      : tr("The other end of the TCP connection sets the baud rate"));
    setAccessText(m_choose, tr("Select baud rates"), tr("Select the baud rates to search"));
    m_protocol->setItemText(AsConnected, tr("Current protocol"));
    m_protocol->setItemText(AllProtocols, tr("All protocols"));
    for (std::size_t i = 0; i < base::allProtocols.size(); ++i)
        m_protocol->setItemText(FirstProtocol + int(i), text::protocolText(base::allProtocols[i]));
    setAccessText(m_protocol, tr("Protocol"), tr("Protocols to search with"));
    m_slow->setText(tr("Wait longer"));
    setAccessText(
        m_slow, tr("Wait longer"),
        tr("Queries silent IDs again with a longer timeout, for adapters that reply late"));
}
} // namespace ui
