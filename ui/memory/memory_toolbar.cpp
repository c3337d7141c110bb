// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/memory/memory_toolbar.h"

#include "text/notice_text.h"
#include "ui/common/widget_text.h"
#include "ui/memory/lock_badge.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/segment_button.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

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

QWidget* compactBox(QWidget* parent)
{
    auto* box = new QWidget(parent);
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins({});
    layout->setSpacing(0);
    return box;
}
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
    addLive();
    m_lock = new LockBadge(commands.action(Command::CloseLock), this);
    m_layout->addWidget(m_lock);
    addCommands();
    retranslate();
}

void MemoryToolbar::addFind()
{
    m_find = new QLineEdit(this);
    m_find->setObjectName(QStringLiteral("registerFind"));
    m_find->setClearButtonEnabled(true);
    m_find->setMinimumWidth(m_find->fontMetrics().averageCharWidth() * 24);
    m_layout->addWidget(m_find);
    connect(m_find, &QLineEdit::textChanged, this, &MemoryToolbar::textChanged);
}

QToolButton* MemoryToolbar::segment(const QString& name, QButtonGroup* group, QWidget* box)
{
    auto* button = new SegmentButton(box);
    button->setObjectName(name);
    group->addButton(button, static_cast<int>(group->buttons().size()));
    box->layout()->addWidget(button);
    return button;
}

void MemoryToolbar::addChoices()
{
    QWidget* box = compactBox(this);
    m_rowFilters = new QButtonGroup(this);
    segment(QStringLiteral("rowsAll"), m_rowFilters, box)->setChecked(true);
    segment(QStringLiteral("rowsChanged"), m_rowFilters, box);
    segment(QStringLiteral("rowsDifferent"), m_rowFilters, box);
    m_layout->addWidget(box);
    connect(m_rowFilters, &QButtonGroup::idClicked, this,
            [this](int id) { Q_EMIT rowFilterChanged(static_cast<RowFilter>(id)); });
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
    QWidget* box = compactBox(this);
    m_order = new QButtonGroup(this);
    QToolButton* raw = segment(QStringLiteral("rawFirst"), m_order, box);
    QToolButton* physical = segment(QStringLiteral("physicalFirst"), m_order, box);
    (m_settings.pageValue(orderKey, false).toBool() ? physical : raw)->setChecked(true);
    m_layout->addWidget(box);
    connect(m_order, &QButtonGroup::idClicked, this, [this](int id) {
        m_settings.setPageValue(orderKey, id == 1);
        Q_EMIT physicalFirstChanged(id == 1);
    });
}

void MemoryToolbar::addLive()
{
    auto* box = new QWidget(this);
    auto* layout = new QHBoxLayout(box);
    layout->setContentsMargins({});
    m_liveLabel = new QLabel(box);
    m_live = new QComboBox(box);
    m_live->setObjectName(QStringLiteral("liveRate"));
    m_live->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_liveLabel->setBuddy(m_live);
    layout->addWidget(m_liveLabel);
    layout->addWidget(m_live);
    m_layout->addWidget(box);
    retranslateLists();
    const int stored = m_settings.pageValue(liveRateKey, defaultLiveRate).toInt();
    const int index = m_live->findData(stored);
    m_live->setCurrentIndex(index >= 0 ? index : m_live->findData(defaultLiveRate));
    connect(m_live, &QComboBox::currentIndexChanged, this, [this] {
        m_settings.setPageValue(liveRateKey, m_live->currentData().toInt());
        Q_EMIT livePeriodChanged();
    });
}

QToolButton* MemoryToolbar::commandButton(const QString& name, Command command, bool withText)
{
    auto* button = new QToolButton(this);
    button->setObjectName(name);
    button->setDefaultAction(m_commands.action(command));
    button->setToolButtonStyle(withText ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
    button->setFocusPolicy(Qt::StrongFocus);
    m_commandButtons.push_back(button);
    m_layout->addWidget(button);
    return button;
}

void MemoryToolbar::addCommands()
{
    commandButton(QStringLiteral("readAll"), Command::ReadTable, true);
    commandButton(QStringLiteral("copyRows"), Command::CopyRows, false);
    commandButton(QStringLiteral("exportTable"), Command::ExportTable, false);
    commandButton(QStringLiteral("printTable"), Command::PrintTable, false);
    m_help = new QToolButton(this);
    m_help->setObjectName(QStringLiteral("cellHelp"));
    m_help->setText(QStringLiteral("?"));
    m_help->setFocusPolicy(Qt::StrongFocus);
    m_layout->addWidget(m_help);
    connect(m_help, &QToolButton::clicked, this, &MemoryToolbar::helpRequested);
}

bool MemoryToolbar::physicalFirst() const
{
    return m_order->checkedId() == 1;
}

std::optional<base::Duration> MemoryToolbar::livePeriod() const
{
    const int rate = m_live->currentData().toInt();
    if (rate == liveOff)
        return std::nullopt;
    return rate == liveMax ? base::Duration{} : base::Duration(std::chrono::seconds(1)) / rate;
}

void MemoryToolbar::focusSearch()
{
    m_find->setFocus(Qt::ShortcutFocusReason);
    m_find->selectAll();
}

void MemoryToolbar::retranslateLists()
{
    const QSignalBlocker groupsBlocker(m_groups);
    const QSignalBlocker liveBlocker(m_live);
    const int group = std::max(m_groups->currentIndex(), 0);
    m_groups->clear();
    m_groups->addItem(tr("All groups"));
    for (const Area area : groups)
        m_groups->addItem(text::areaLabel(area));
    m_groups->setCurrentIndex(group);
    const int live = m_live->currentIndex();
    m_live->clear();
    for (const int rate : liveRates) {
        const QString word = rate == liveOff   ? tr("off")
                             : rate == liveMax ? tr("fastest")
                                               : tr("%1 Hz").arg(rate);
        m_live->addItem(word, rate);
    }
    m_live->setCurrentIndex(live);
}

void MemoryToolbar::retranslate()
{
    retranslateLists();
    m_find->setPlaceholderText(tr("Find a register"));
    setAccessText(
        m_find, tr("Find a register"),
        tr("Address, name, key or a word from the help; if several words are entered, all must "
           "match"));
    setButtonText(m_rowFilters->button(0), tr("All"), tr("Shows all registers"));
    setButtonText(m_rowFilters->button(1), tr("Changed"),
                  tr("Shows registers that differ from the first reading of this session"));
    setButtonText(m_rowFilters->button(2), tr("≠ default"),
                  tr("Shows registers that differ from their known factory value"));
    setAccessText(m_groups, tr("Group"), tr("Shows only one group of registers"));
    setButtonText(m_order->button(0), tr("Raw"),
                  tr("Shows raw values first and uses them for input"));
    setButtonText(m_order->button(1), tr("Physical"),
                  tr("Shows values with units first and uses them "
                     "for input"));
    m_liveLabel->setText(tr("Live"));
    setAccessText(m_live, tr("Live reading"),
                  tr("Read rate of the visible rows; nothing is written"));
    setAccessText(m_help, tr("Explain this row"),
                  tr("Shows everything that is known about the selected row"));
    for (QToolButton* button : m_commandButtons)
        button->setAccessibleName(button->defaultAction()->iconText());
}

void MemoryToolbar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}
} // namespace ui
