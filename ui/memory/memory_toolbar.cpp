// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/memory_toolbar.h"

#include "text/notice_text.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_text.h"
#include "ui/memory/lock_badge.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/segmented_control.h"

#include <QActionGroup>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

#include <algorithm>
#include <array>

namespace ui {
using catalog::Area;

namespace {
const QString orderKey = QStringLiteral("memory/physical_first");
const QString liveRateKey = QStringLiteral("memory/live_hz");

constexpr std::array groups{Area::Eprom, Area::Sram, Area::Feedback, Area::Factory};

// As stored: readings a second; 0 is off, -1 as fast as the wire allows.
constexpr int liveOff = 0;
constexpr int liveMax = -1;
constexpr std::array liveRates{liveOff, 1, 5, 20, liveMax};
constexpr int defaultLiveRate = 5;
} // namespace

MemoryToolbar::MemoryToolbar(Commands& commands, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_commands(commands)
    , m_settings(settings)
    , m_layout(new FlowLayout(this))
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    addFind();
    addChoices();
    addOrder();
    m_lock = new LockBadge(commands.action(Command::CloseLock), this);
    m_layout->addWidget(m_lock);
    addReadAll();
    addMenu();
    followLanguage(this, [this] { retranslate(); });
}

void MemoryToolbar::addFind()
{
    m_find = new QLineEdit(this);
    m_find->setObjectName(QStringLiteral("registerFind"));
    m_find->setClearButtonEnabled(true);
    m_find->setMinimumWidth(m_find->fontMetrics().averageCharWidth() * 20);
    m_layout->addWidget(m_find);
    connect(m_find, &QLineEdit::textChanged, this, &MemoryToolbar::textChanged);
}

void MemoryToolbar::addChoices()
{
    m_rowFilters = new SegmentedControl(this);
    for (const char* name : {"rowsAll", "rowsChanged", "rowsDifferent"})
        m_rowFilters->addSegment(QString::fromLatin1(name));
    m_rowFilters->select(0);
    m_layout->addWidget(m_rowFilters);
    connect(m_rowFilters, &SegmentedControl::chosen, this,
            [this](int index) { Q_EMIT rowFilterChanged(static_cast<RowFilter>(index)); });
    m_groups = new QComboBox(this);
    m_groups->setObjectName(QStringLiteral("groupFilter"));
    m_groups->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_layout->addWidget(m_groups);
    connect(m_groups, &QComboBox::currentIndexChanged, this, [this](int index) {
        Q_EMIT groupChanged(
            index <= 0 ? std::nullopt : std::optional(groups[static_cast<std::size_t>(index - 1)]));
    });
}

void MemoryToolbar::addOrder()
{
    m_order = new SegmentedControl(this);
    m_order->addSegment(QStringLiteral("rawFirst"));
    m_order->addSegment(QStringLiteral("physicalFirst"));
    m_order->select(m_settings.pageValue(orderKey, false).toBool() ? 1 : 0);
    m_layout->addWidget(m_order);
    connect(m_order, &SegmentedControl::chosen, this, [this](int index) {
        m_settings.setPageValue(orderKey, index == 1);
        Q_EMIT physicalFirstChanged(index == 1);
    });
}

void MemoryToolbar::addMenu()
{
    auto* more = new QToolButton(this);
    more->setObjectName(QStringLiteral("memoryMore"));
    more->setIcon(QIcon::fromTheme(QStringLiteral("application-menu")));
    more->setPopupMode(QToolButton::InstantPopup);
    more->setProperty("menuOnly", true);
    more->setFocusPolicy(Qt::StrongFocus);
    m_more = more;
    m_menu = new QMenu(more);
    m_menu->setToolTipsVisible(true);
    more->setMenu(m_menu);
    m_layout->addWidget(more);
    for (const Command command : {Command::CopyRows, Command::ExportTable, Command::PrintTable})
        m_menu->addAction(m_commands.action(command));
    m_menu->addSeparator();
    m_columns = m_menu->addMenu(QString());
    addLive();
    m_help = m_menu->addAction(QString());
    m_help->setObjectName(QStringLiteral("rowHelp"));
    connect(m_help, &QAction::triggered, this, &MemoryToolbar::helpRequested);
}

void MemoryToolbar::addLive()
{
    m_live = m_menu->addMenu(QString());
    auto* group = new QActionGroup(m_live);
    const int stored = m_settings.pageValue(liveRateKey, defaultLiveRate).toInt();
    const bool isKnown = std::find(liveRates.begin(), liveRates.end(), stored) != liveRates.end();
    m_liveRate = isKnown ? stored : defaultLiveRate;
    for (const int rate : liveRates) {
        QAction* one = m_live->addAction(QString());
        one->setObjectName(QStringLiteral("liveRate%1").arg(rate));
        one->setCheckable(true);
        one->setChecked(rate == m_liveRate);
        group->addAction(one);
        connect(one, &QAction::triggered, this, [this, rate] {
            m_liveRate = rate;
            m_settings.setPageValue(liveRateKey, rate);
            showLiveRate();
            Q_EMIT livePeriodChanged();
        });
    }
}

QString MemoryToolbar::liveRateText(int rate)
{
    return rate == liveOff   ? tr("Off")
           : rate == liveMax ? tr("As fast as the bus allows")
                             : tr("%1 Hz").arg(rate);
}

void MemoryToolbar::showLiveRate()
{
    m_live->setTitle(tr("&Live reading: %1").arg(liveRateText(m_liveRate)));
}

void MemoryToolbar::addReadAll()
{
    m_readAll = new QToolButton(this);
    m_readAll->setObjectName(QStringLiteral("readAll"));
    m_readAll->setDefaultAction(m_commands.action(Command::ReadTable));
    m_readAll->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_readAll->setFocusPolicy(Qt::StrongFocus);
    m_layout->addWidget(m_readAll);
}

bool MemoryToolbar::physicalFirst() const
{
    return m_order->selected() == 1;
}

std::optional<base::Duration> MemoryToolbar::livePeriod() const
{
    if (m_liveRate == liveOff)
        return std::nullopt;
    return m_liveRate == liveMax ? base::Duration{}
                                 : base::Duration(std::chrono::seconds(1)) / m_liveRate;
}

void MemoryToolbar::focusSearch()
{
    m_find->setFocus(Qt::ShortcutFocusReason);
    m_find->selectAll();
}

void MemoryToolbar::retranslateLists()
{
    const QSignalBlocker groupsBlocker(m_groups);
    const int group = std::max(m_groups->currentIndex(), 0);
    m_groups->clear();
    m_groups->addItem(tr("All groups"));
    for (const Area area : groups)
        m_groups->addItem(text::areaLabel(area));
    m_groups->setCurrentIndex(group);
    for (std::size_t i = 0; i < liveRates.size(); ++i)
        m_live->actions()[qsizetype(i)]->setText(liveRateText(liveRates[i]));
    showLiveRate();
}

void MemoryToolbar::retranslate()
{
    retranslateLists();
    m_find->setPlaceholderText(tr("Find a register"));
    setAccessText(
        m_find, tr("Find a register"),
        tr("Address, name, key or a word from the help; if several words are entered, all must "
           "match"));
    setButtonText(m_rowFilters->segment(0), tr("All"), tr("Shows all registers"));
    setButtonText(m_rowFilters->segment(1), tr("Changed"),
                  tr("Shows registers that differ from the first reading of this session"));
    setButtonText(m_rowFilters->segment(2), tr("≠ default"),
                  tr("Shows registers that differ from their known factory value"));
    setAccessText(m_groups, tr("Group"), tr("Shows only one group of registers"));
    setButtonText(m_order->segment(0), tr("Raw"),
                  tr("Shows raw values before physical values and uses raw values for input"));
    setButtonText(m_order->segment(1), tr("Physical"),
                  tr("Shows physical values before raw values and uses physical values for input"));
    m_columns->setTitle(tr("&Columns"));
    m_live->menuAction()->setToolTip(tr("How often the visible rows are read; nothing is written"));
    m_help->setText(tr("Explain this &row"));
    m_help->setToolTip(tr("Shows everything that is known about the selected row"));
    setAccessText(
        m_more, tr("More"),
        tr("Copy, export or print the table, choose its columns, and set the live reading rate"));
    m_readAll->setAccessibleName(m_readAll->defaultAction()->iconText());
}
} // namespace ui
