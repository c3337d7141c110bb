// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/history/history_filter_bar.h"

#include "session/history/history_server_choice.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_text.h"
#include "ui/history/history_formatter.h"
#include "ui/widgets/flow_layout.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>

#include <algorithm>

namespace ui {
using history::HistoryKind;

namespace {
using Choices = std::vector<std::pair<QString, QVariant>>;

constexpr int comboWidth = 24; ///< letters
constexpr int maxFilterServos = 2000;
constexpr int allBenches = -1;
constexpr HistoryKind kinds[] = {HistoryKind::Writes, HistoryKind::Snapshots,  HistoryKind::Runs,
                                 HistoryKind::Alarms, HistoryKind::Recordings, HistoryKind::Servos};

bool hasErrorFilter(HistoryKind kind)
{
    return kind == HistoryKind::Writes || kind == HistoryKind::Alarms;
}

/// One servo under two IDs: its label went with it.
bool isSameLabel(const history::HistoryServo& one, const history::HistoryServo& other)
{
    return !one.label.isEmpty() && one.label == other.label &&
           one.identity.isSameKind(other.identity);
}

bool hasItems(const QComboBox* box, const Choices& items)
{
    bool same = box->count() == int(items.size());
    for (int i = 0; same && i < box->count(); ++i)
        same = box->itemText(i) == items[std::size_t(i)].first &&
               box->itemData(i) == items[std::size_t(i)].second;
    return same;
}

/// Keeps what was chosen, where it is still there. A list that is open is replaced only when it
/// changes.
void setItems(QComboBox* box, const Choices& items)
{
    if (hasItems(box, items))
        return;
    const QVariant chosen = box->currentData();
    const QSignalBlocker blocker(box);
    box->clear();
    for (const auto& [text, data] : items)
        box->addItem(text, data);
    box->setCurrentIndex(std::max(0, box->findData(chosen)));
}
} // namespace

HistoryFilterBar::HistoryFilterBar(const session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
{
    build();
    connectAll();
    followLanguage(this, [this] { retranslate(); });
}

void HistoryFilterBar::build()
{
    auto* row = new FlowLayout(this, 8);
    const auto choice = [&](const char* name) {
        auto* made = new QComboBox(this);
        made->setObjectName(QString::fromLatin1(name));
        made->setSizeAdjustPolicy(QComboBox::AdjustToContents);
        row->addWidget(made);
        return made;
    };
    m_source = choice("historySource");
    m_kind = choice("historyKind");
    for (const HistoryKind kind : kinds)
        m_kind->addItem(QString(), int(kind));
    m_servo = choice("historyServo");
    m_register = choice("historyRegister");
    for (QComboBox* wide : {m_servo, m_register}) {
        wide->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        wide->setMinimumContentsLength(comboWidth);
    }
    m_period = choice("historyPeriod");
    for (const int days : {0, 1, 7, 30, 365, -1})
        m_period->addItem(QString(), days);
    const auto date = [&](const char* name) {
        auto* made = new QDateEdit(QDate::currentDate(), this);
        made->setObjectName(QString::fromLatin1(name));
        made->setCalendarPopup(true);
        made->setDisplayFormat(QStringLiteral("yyyy-MM-dd"));
        row->addWidget(made);
        return made;
    };
    m_from = date("historyFrom");
    m_until = date("historyUntil");
    m_onlyErrors = new QCheckBox(this);
    m_onlyErrors->setObjectName(QStringLiteral("historyTrouble"));
    row->addWidget(m_onlyErrors);
}

void HistoryFilterBar::connectAll()
{
    connect(m_source, &QComboBox::activated, this, &HistoryFilterBar::sourceChanged);
    for (QComboBox* one : {m_kind, m_servo, m_register, m_period})
        connect(one, &QComboBox::activated, this, &HistoryFilterBar::filterChanged);
    for (QDateEdit* one : {m_from, m_until})
        connect(one, &QDateEdit::dateChanged, this, &HistoryFilterBar::filterChanged);
    connect(m_onlyErrors, &QCheckBox::toggled, this, &HistoryFilterBar::filterChanged);
}

HistorySourceChoice HistoryFilterBar::source() const
{
    const QVariant chosen = m_source->currentData();
    if (!chosen.isValid())
        return {};
    const auto bench = chosen.toLongLong();
    return {true, bench == allBenches ? std::nullopt : std::optional<std::int64_t>(bench)};
}

HistoryKind HistoryFilterBar::kind() const
{
    return HistoryKind(m_kind->currentData().toInt());
}

history::HistoryFilter HistoryFilterBar::filter() const
{
    history::HistoryFilter result;
    if (m_servo->currentData().isValid()) {
        const QVariantList identity = m_servo->currentData().toList();
        result.servo = identity.value(0).toLongLong();
        if (kind() == HistoryKind::Runs) { // tests name their servos, they have no number
            result.servo.reset();
            result.id = identity.value(1).toInt();
            result.model = identity.value(2).toString();
        }
    }
    if (kind() == HistoryKind::Writes)
        result.key = m_register->currentData().toString();
    if (hasErrorFilter(kind()))
        result.onlyProblems = m_onlyErrors->isChecked();
    const int days = m_period->currentData().toInt();
    if (days > 0)
        result.from = QDate::currentDate().addDays(1 - days).startOfDay().toUTC();
    if (days < 0) {
        result.from = m_from->date().startOfDay().toUTC();
        result.until = m_until->date().addDays(1).startOfDay().toUTC();
    }
    return result;
}

void HistoryFilterBar::showFiltersOfKind()
{
    m_register->setVisible(kind() == HistoryKind::Writes);
    m_onlyErrors->setVisible(hasErrorFilter(kind()));
    m_servo->setEnabled(kind() != HistoryKind::Servos);
    const bool dates = m_period->currentData().toInt() < 0;
    m_from->setVisible(dates);
    m_until->setVisible(dates);
}

void HistoryFilterBar::loadChoices(session::HistoryService& service, bool isServer)
{
    showSources();
    history::HistoryFilter all;
    all.limit = maxFilterServos;
    service.servos(all, this,
                   [this, isServer](const base::Result<std::vector<history::HistoryServo>>& found) {
                       showServos(found.value_or(std::vector<history::HistoryServo>{}), isServer);
                   });
    service.writtenKeys(std::nullopt, this, [this](const base::Result<QStringList>& keys) {
        Choices items{{tr("All registers"), QVariant()}};
        for (const QString& key : keys.value_or(QStringList{}))
            items.push_back({key, key});
        setItems(m_register, items);
    });
    if (!isServer)
        return;
    service.benches(this, [this](const base::Result<std::vector<history::HistoryBench>>& found) {
        if (found) // the list shows the error
            setBenches(*found);
    });
}

void HistoryFilterBar::setBenches(std::vector<history::HistoryBench> benches)
{
    m_benches = std::move(benches);
    showSources();
}

void HistoryFilterBar::showSources()
{
    Choices items{{tr("This computer"), QVariant()}};
    if (!session::historyServerChoice(m_settings).address.isEmpty()) {
        items.push_back({tr("Server: all benches"), QVariant::fromValue(allBenches)});
        for (const history::HistoryBench& one : m_benches)
            items.push_back({tr("Server: %1").arg(one.name), qlonglong(one.number)});
    }
    setItems(m_source, items);
    m_source->setVisible(items.size() > 1);
}

void HistoryFilterBar::showServos(const std::vector<history::HistoryServo>& servos, bool isServer)
{
    Choices items{{tr("All servos"), QVariant()}};
    std::vector<history::HistoryServo> listed;
    for (const history::HistoryServo& one : servos) {
        const auto same = [&](const history::HistoryServo& other) {
            return isSameLabel(one, other);
        };
        // Its earlier IDs belong to the entry with its latest one.
        if (!isServer && std::any_of(listed.begin(), listed.end(), same))
            continue;
        listed.push_back(one);
        items.push_back({HistoryFormatter::servoTitle(one),
                         QVariantList{qlonglong(one.number), one.identity.id, one.identity.model}});
    }
    setItems(m_servo, items);
}

void HistoryFilterBar::selectServo(std::int64_t number)
{
    for (int i = 0; i < m_servo->count(); ++i) {
        if (m_servo->itemData(i).isValid() &&
            m_servo->itemData(i).toList().value(0).toLongLong() == number) {
            m_servo->setCurrentIndex(i);
            Q_EMIT filterChanged();
        }
    }
}

void HistoryFilterBar::retranslate()
{
    setAccessText(m_source, tr("Source"),
                  tr("The history of this computer, or the copies on the server"));
    setAccessText(m_kind, tr("List"), tr("Kind of entries to list"));
    for (int i = 0; i < m_kind->count(); ++i)
        m_kind->setItemText(i,
                            HistoryFormatter::kindName(HistoryKind(m_kind->itemData(i).toInt())));
    setAccessText(m_servo, tr("Servo"), tr("Shows only entries for this servo"));
    setAccessText(m_register, tr("Register"), tr("Shows only writes to this register"));
    const QString periods[] = {tr("Any time"),     tr("Today"),         tr("Last 7 days"),
                               tr("Last 30 days"), tr("Last 365 days"), tr("Custom range…")};
    for (int i = 0; i < m_period->count(); ++i)
        m_period->setItemText(i, periods[i]);
    setAccessText(m_period, tr("Time"), tr("Shows only entries from this period"));
    setAccessText(m_from, tr("From"), tr("Start date"));
    setAccessText(m_until, tr("Until"), tr("End date"));
    setButtonText(m_onlyErrors, tr("Problems only"),
                  tr("Shows only failed writes and alarms that are still active"));
    showSources();
}
} // namespace ui
