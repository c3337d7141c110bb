// SPDX-License-Identifier: GPL-3.0-or-later
// What the history page consists of, and its words.
#include "ui/history/history_page.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/fit_columns.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/tone_delegate.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

namespace ui {
using record::HistoryKind;

namespace {
constexpr int rowPadding = 8;
constexpr int comboWidth = 24; ///< letters
constexpr auto queryDelay = std::chrono::milliseconds(150);
constexpr HistoryKind kinds[] = {HistoryKind::Writes, HistoryKind::Snapshots,  HistoryKind::Runs,
                                 HistoryKind::Alarms, HistoryKind::Recordings, HistoryKind::Servos};
} // namespace

void HistoryPage::build()
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 6, 0, 0);
    m_banner = new Banner(this);
    m_banner->setObjectName(QStringLiteral("historyBanner"));
    m_banner->hideMessage();
    m_identityHint = new QLabel(this);
    m_identityHint->setObjectName(QStringLiteral("historyHonest"));
    m_identityHint->setWordWrap(true);
    m_view = new QTableView(this);
    m_view->setObjectName(QStringLiteral("historyTable"));
    m_view->setModel(&m_table);
    m_view->setItemDelegate(new ToneDelegate(m_view));
    m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_view->setSelectionMode(QAbstractItemView::SingleSelection);
    m_view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_view->setTabKeyNavigation(false);
    m_view->setWordWrap(false);
    m_view->verticalHeader()->hide();
    m_view->verticalHeader()->setDefaultSectionSize(m_view->fontMetrics().height() + rowPadding);
    m_columns = new FitColumns(m_view);
    m_view->horizontalHeader()->setHighlightSections(false);
    column->addWidget(m_banner);
    column->addWidget(buildFilters());
    column->addWidget(m_view, 1);
    column->addWidget(m_identityHint);
    column->addWidget(buildActions());
    m_serverState = new QLabel(this);
    m_serverState->setObjectName(QStringLiteral("historyServerState"));
    m_serverState->setTextFormat(Qt::PlainText);
    m_serverState->setWordWrap(true);
    m_serverState->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_serverState);
    m_queryTimer.setSingleShot(true);
    m_queryTimer.setInterval(queryDelay);
}

QWidget* HistoryPage::buildFilters()
{
    auto* box = new QWidget(this);
    auto* row = new FlowLayout(box, 8);
    const auto choice = [&](const char* name) {
        auto* made = new QComboBox(box);
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
    m_servo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_servo->setMinimumContentsLength(comboWidth);
    m_register = choice("historyRegister");
    m_register->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_register->setMinimumContentsLength(comboWidth);
    m_period = choice("historyPeriod");
    for (const int days : {0, 1, 7, 30, 365, -1})
        m_period->addItem(QString(), days);
    const auto date = [&](const char* name) {
        auto* made = new QDateEdit(QDate::currentDate(), box);
        made->setObjectName(QString::fromLatin1(name));
        made->setCalendarPopup(true);
        made->setDisplayFormat(QStringLiteral("yyyy-MM-dd"));
        row->addWidget(made);
        return made;
    };
    m_from = date("historyFrom");
    m_until = date("historyUntil");
    m_onlyErrors = new QCheckBox(box);
    m_onlyErrors->setObjectName(QStringLiteral("historyTrouble"));
    row->addWidget(m_onlyErrors);
    return box;
}

QWidget* HistoryPage::buildActions()
{
    auto* box = new QWidget(this);
    auto* row = new FlowLayout(box, 6);
    const auto button = [&](const char* name) {
        auto* made = new QPushButton(box);
        made->setObjectName(QString::fromLatin1(name));
        row->addWidget(made);
        return made;
    };
    m_open = button("historyOpen");
    m_label = button("historyLabel");
    m_export = button("historyExport");
    m_serverSet = button("historyServer");
    m_count = new QLabel(box);
    m_count->setObjectName(QStringLiteral("historyCount"));
    row->addWidget(m_count);
    return box;
}

void HistoryPage::connectAll()
{
    connect(&m_queryTimer, &QTimer::timeout, this, &HistoryPage::query);
    connect(&m_local, &session::HistoryService::changed, this, [this] {
        if (!isRemote())
            scheduleQuery();
    });
    // Writes and the snapshots before them come there without the archive's help.
    connect(&m_desk, &session::Desk::eventOccurred, this, [this](const session::Event& event) {
        using Kind = session::Event::Kind;
        if (!isRemote() && (event.kind == Kind::Written || event.kind == Kind::Task ||
                            event.kind == Kind::TableSaved))
            scheduleQuery();
    });
    connect(&m_local, &session::HistoryService::failed, this, &HistoryPage::showError);
    connect(&m_table, &HistoryTableModel::changed, this, &HistoryPage::showState);
    connect(&m_table, &HistoryTableModel::rowsAboutToBeInserted, this,
            [this](const QModelIndex&, int first) { saveTopRow(first); });
    connect(&m_table, &HistoryTableModel::rowsAboutToBeRemoved, this,
            [this](const QModelIndex&, int first) { saveTopRow(first); });
    connect(&m_table, &HistoryTableModel::failed, this, &HistoryPage::showError);
    connect(m_source, &QComboBox::activated, this, &HistoryPage::onSourceChanged);
    for (QComboBox* one : {m_kind, m_servo, m_register, m_period})
        connect(one, &QComboBox::activated, this, &HistoryPage::scheduleQuery);
    for (QDateEdit* one : {m_from, m_until})
        connect(one, &QDateEdit::dateChanged, this, &HistoryPage::scheduleQuery);
    connect(m_onlyErrors, &QCheckBox::toggled, this, &HistoryPage::scheduleQuery);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &HistoryPage::showState);
    connect(m_view, &QTableView::activated, this, &HistoryPage::openTable);
    connect(m_open, &QPushButton::clicked, this, &HistoryPage::openTable);
    connect(m_label, &QPushButton::clicked, this, &HistoryPage::editLabel);
    connect(m_export, &QPushButton::clicked, this, &HistoryPage::exportList);
    connect(m_serverSet, &QPushButton::clicked, this, &HistoryPage::setServer);
    connect(&m_sender, &session::HistorySender::stateChanged, this, &HistoryPage::showServer);
}

void HistoryPage::retranslate()
{
    setAccessibleName(tr("History"));
    const auto setTexts = [](QWidget* widget, const QString& name, const QString& tip) {
        widget->setAccessibleName(name);
        widget->setToolTip(tip);
    };
    const auto word = [&](QAbstractButton* button, const QString& text, const QString& tip) {
        button->setText(text);
        setTexts(button, text, tip);
    };
    setTexts(m_source, tr("Source"),
             tr("The history of this computer, or the copies on the server"));
    m_kind->setToolTip(tr("What is listed"));
    m_kind->setAccessibleName(tr("List"));
    for (int i = 0; i < m_kind->count(); ++i)
        m_kind->setItemText(i,
                            HistoryFormatter::kindName(HistoryKind(m_kind->itemData(i).toInt())));
    setTexts(m_servo, tr("Servo"), tr("Only what concerns this servo"));
    setTexts(m_register, tr("Register"), tr("Only writes to this register"));
    const QString periods[] = {tr("Any time"),     tr("Today"),     tr("Last 7 days"),
                               tr("Last 30 days"), tr("Last year"), tr("From … until …")};
    for (int i = 0; i < m_period->count(); ++i)
        m_period->setItemText(i, periods[i]);
    setTexts(m_period, tr("Time"), tr("Only what happened in this time"));
    setTexts(m_from, tr("From"), tr("The first day"));
    setTexts(m_until, tr("Until"), tr("The last day"));
    word(m_onlyErrors, tr("Only trouble"),
         tr("Writes that did not end well, alarms that are not "
            "over"));
    m_identityHint->setText(
        tr("Servos carry no serial number. What belongs together is told by model, "
           "firmware, ID and the label you give: two alike without a label cannot "
           "be told apart."));
    setTexts(m_view, tr("History"), tr("Newest first; each row's own hint has all of it"));
    word(m_label, tr("Label…"), tr("Give the servo or the snapshot a name"));
    word(m_export, tr("Export…"), tr("Save the list, as it is filtered, as CSV or JSON"));
    word(m_serverSet, tr("Server…"),
         tr("Send copies of the history to a PostgreSQL server, and look at those of all benches"));
    showServer();
    loadFilterValues();
    m_table.retranslate();
    showState();
}
} // namespace ui
