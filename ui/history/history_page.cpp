// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked and shown. The parts are made in history_page_build.cpp, the actions are in
// history_page_actions.cpp.
#include "ui/history/history_page.h"

#include "session/history/history_server_choice.h"
#include "session/history/history_server_source.h"
#include "text/error_text.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/fit_columns.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTableView>

#include <algorithm>
#include <utility>

namespace ui {
using record::HistoryKind;

namespace {
constexpr int maxServos = 2000;
constexpr int allBenches = -1;

/// One servo under two IDs: its label went with it.
bool isSameLabel(const record::HistoryServo& one, const record::HistoryServo& other)
{
    return !one.label.isEmpty() && one.label == other.label &&
           one.identity.isSameKind(other.identity);
}

bool hasItems(const QComboBox* box, const std::vector<std::pair<QString, QVariant>>& items)
{
    bool same = box->count() == int(items.size());
    for (int i = 0; same && i < box->count(); ++i)
        same = box->itemText(i) == items[std::size_t(i)].first &&
               box->itemData(i) == items[std::size_t(i)].second;
    return same;
}

/// Fills a list of choices and keeps what was chosen, where it is still there. One that is open is
/// disturbed only by a change.
void setItems(QComboBox* box, const std::vector<std::pair<QString, QVariant>>& items)
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

HistoryPage::HistoryPage(AppContext& appContext, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_desk(appContext.desk)
    , m_local(appContext.history)
    , m_localGuard(&appContext.history)
    , m_sender(appContext.historySender)
    , m_settings(settings)
    , m_catalog(appContext.desk.catalog())
    , m_table(appContext.desk.catalog())
{
    setObjectName(QStringLiteral("historyPage"));
    build();
    connectAll();
    retranslate();
}

HistoryPage::~HistoryPage() = default;

bool HistoryPage::isRemote() const
{
    return m_server != nullptr;
}

session::HistoryService& HistoryPage::historyService() const
{
    return m_server ? *m_server : m_local;
}

/// The first entry is this computer, the others are the server's benches.
void HistoryPage::onSourceChanged()
{
    m_banner->hideMessage();
    const QVariant chosen = m_source->currentData();
    m_table.query(nullptr, m_table.kind(), {});
    if (!chosen.isValid()) {
        m_server.reset();
    } else {
        if (!m_server) {
            m_server = std::make_unique<session::HistoryService>(
                std::make_unique<session::HistoryServerSource>(
                    session::historyServerChoice(m_settings).address));
        }
        const auto appContext = chosen.toLongLong();
        m_server->selectBench(appContext == allBenches ? std::nullopt
                                                       : std::optional<std::int64_t>(appContext));
    }
    setViewing(isVisible());
    loadFilterValues();
    query();
}

void HistoryPage::setViewing(bool viewing)
{
    if (m_localGuard)
        m_local.setWatched(this, viewing && !isRemote());
}

/// A hidden page asks when it is shown.
void HistoryPage::scheduleQuery()
{
    if (isVisible())
        m_queryTimer.start();
}

record::HistoryFilter HistoryPage::filter() const
{
    record::HistoryFilter result;
    const auto kind = HistoryKind(m_kind->currentData().toInt());
    if (m_servo->currentData().isValid()) {
        const QVariantList identity = m_servo->currentData().toList();
        result.servo = identity.value(0).toLongLong();
        if (kind == HistoryKind::Runs) { // tests name their servos, they have no number
            result.servo.reset();
            result.id = identity.value(1).toInt();
            result.model = identity.value(2).toString();
        }
    }
    if (kind == HistoryKind::Writes)
        result.key = m_register->currentData().toString();
    if (kind == HistoryKind::Writes || kind == HistoryKind::Alarms)
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

void HistoryPage::query()
{
    m_queryTimer.stop();
    const auto kind = HistoryKind(m_kind->currentData().toInt());
    m_register->setVisible(kind == HistoryKind::Writes);
    m_onlyErrors->setVisible(kind == HistoryKind::Writes || kind == HistoryKind::Alarms);
    m_servo->setEnabled(kind != HistoryKind::Servos);
    const bool dates = m_period->currentData().toInt() < 0;
    m_from->setVisible(dates);
    m_until->setVisible(dates);
    m_table.query(&historyService(), kind, filter());
    loadFilterValues();
}

/// Servos, registers and benches there are.
void HistoryPage::loadFilterValues()
{
    std::vector<std::pair<QString, QVariant>> sources{{tr("This computer"), QVariant()}};
    if (!session::historyServerChoice(m_settings).address.isEmpty())
        sources.push_back({tr("Server: all benches"), QVariant::fromValue(allBenches)});
    if (m_source->count() != int(sources.size()) || !isRemote())
        setItems(m_source, sources);
    m_source->setItemText(0, tr("This computer"));
    m_source->setVisible(sources.size() > 1);
    record::HistoryFilter all;
    all.limit = maxServos;
    historyService().servos(
        all, this, [this](const base::Result<std::vector<record::HistoryServo>>& servos) {
            std::vector<std::pair<QString, QVariant>> items{{tr("All servos"), QVariant()}};
            std::vector<record::HistoryServo> listed;
            for (const record::HistoryServo& one :
                 servos ? *servos : std::vector<record::HistoryServo>{}) {
                const auto same = [&](const record::HistoryServo& other) {
                    return isSameLabel(one, other);
                };
                // Its earlier IDs belong to the entry with its latest one.
                if (!isRemote() && std::any_of(listed.begin(), listed.end(), same))
                    continue;
                listed.push_back(one);
                items.push_back(
                    {HistoryFormatter::servoTitle(one),
                     QVariantList{qlonglong(one.number), one.identity.id, one.identity.model}});
            }
            setItems(m_servo, items);
        });
    historyService().writtenKeys(std::nullopt, this, [this](const base::Result<QStringList>& keys) {
        std::vector<std::pair<QString, QVariant>> items{{tr("All registers"), QVariant()}};
        for (const QString& key : keys ? *keys : QStringList{})
            items.push_back({key, key});
        setItems(m_register, items);
    });
    if (!isRemote())
        return;
    m_server->benches(this, [this](const base::Result<std::vector<record::HistoryBench>>& found) {
        if (!found)
            return; // the list has told it
        std::vector<std::pair<QString, QVariant>> items{
            {tr("This computer"), QVariant()},
            {tr("Server: all benches"), QVariant::fromValue(allBenches)}};
        for (const record::HistoryBench& one : *found)
            items.push_back({tr("Server: %1").arg(one.name), qlonglong(one.number)});
        setItems(m_source, items);
    });
}

std::optional<int> HistoryPage::current() const
{
    const QModelIndexList rows = m_view->selectionModel()->selectedRows();
    return rows.size() == 1 ? std::optional<int>(rows.front().row()) : std::nullopt;
}

/// New rows come in at the top; who has scrolled goes on reading where they were.
void HistoryPage::saveTopRow(int changedFrom)
{
    const QModelIndex top = m_view->indexAt(QPoint(0, 0));
    if (!m_topRow.isValid() && m_view->verticalScrollBar()->value() > 0 && changedFrom <= top.row())
        m_topRow = top;
}

void HistoryPage::restoreTopRow()
{
    if (!m_topRow.isValid())
        return;
    const int across = m_view->horizontalScrollBar()->value();
    m_view->doItemsLayout();
    m_view->scrollTo(m_topRow, QAbstractItemView::PositionAtTop);
    m_view->horizontalScrollBar()->setValue(across);
    m_topRow = QPersistentModelIndex();
}

void HistoryPage::showState()
{
    restoreTopRow();
    if (std::exchange(m_columnsUnsized, m_table.rowCount() == 0) && m_table.rowCount() > 0)
        m_columns->fit();
    const HistoryKind kind = m_table.kind();
    const bool one = current().has_value();
    const bool writes = kind == HistoryKind::Writes;
    m_open->setText(writes                      ? tr("Table at this moment")
                    : kind == HistoryKind::Runs ? tr("Earlier tests…")
                                                : tr("Open snapshot"));
    m_open->setAccessibleName(m_open->text());
    m_open->setToolTip(
        writes ? tr("The servo's table as it was just before this write, to compare and restore")
        : kind == HistoryKind::Runs ? tr("Reports and comparisons of kept tests")
                                    : tr("Compare it and restore from it"));
    m_open->setVisible(writes || kind == HistoryKind::Snapshots ||
                       (kind == HistoryKind::Runs && !isRemote()));
    m_open->setEnabled(one || kind == HistoryKind::Runs);
    m_label->setVisible(!isRemote() &&
                        (kind == HistoryKind::Servos || kind == HistoryKind::Snapshots));
    m_label->setEnabled(one);
    const int rows = m_table.rowCount();
    m_export->setEnabled(rows > 0);
    m_count->setText(m_table.isLoading() && rows == 0 ? tr("Asking…")
                     : rows == 0                      ? tr("Nothing")
                     : m_table.isComplete()           ? tr("%1 rows").arg(rows)
                                                      : tr("%1 rows and more").arg(rows));
}

/// What is wrong with the server, why, and what to do.
QString HistoryPage::sendErrorText(const session::SendState& state)
{
    const QString first = tr("⚠ %1: what is written now is sent later.")
                              .arg(state.server.isEmpty() ? tr("History server") : state.server);
    if (!state.error)
        return first;
    const text::Description words = text::describe(*state.error);
    QStringList lines{first, words.message, words.cause, words.remedy};
    lines.removeAll(QString());
    return lines.join(u'\n');
}

/// How far the copies are; nothing without a server.
void HistoryPage::showServer()
{
    using Phase = session::SendState::Phase;
    const session::SendState& state = m_sender.state();
    QString words;
    switch (state.phase) {
    case Phase::Off:
        break;
    case Phase::Waiting:
    case Phase::Sending:
        words = state.pending ? tr("%1: sending %2 rows").arg(state.server).arg(*state.pending)
                              : tr("%1: sending").arg(state.server);
        break;
    case Phase::UpToDate:
        words = tr("✔ %1 is up to date").arg(state.server);
        break;
    case Phase::Failed:
        words = sendErrorText(state);
        break;
    }
    m_serverState->setText(words);
    m_serverState->setVisible(!words.isEmpty());
}

void HistoryPage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_serverState != nullptr)
        retranslate();
}

void HistoryPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    setViewing(true); // first, so that nothing comes unseen in between
    query();
}

void HistoryPage::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    setViewing(false);
}
} // namespace ui
