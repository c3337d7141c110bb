// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/pages.h"

#include "ui/commissioning/commission_page.h"
#include "ui/common/widget_style.h"
#include "ui/history/history_page.h"
#include "ui/memory/memory_page.h"
#include "ui/operate/operate_page.h"
#include "ui/snapshots/snapshots_page.h"
#include "ui/step/step_page.h"
#include "ui/sweep/sweep_page.h"
#include "ui/trends/trend_panel.h"

#include <QLayout>
#include <QPainter>
#include <QStackedWidget>
#include <QTabBar>

#include <array>

namespace ui {
namespace {
struct Page {
    const char* name; ///< on the command line
    Command command;
    const char* title;
    const char* toolTip;
};

/// In the order of the tabs.
constexpr std::array allPages{
    Page{"operate", Command::PageOperate, QT_TRANSLATE_NOOP("ui::Pages", "Operate"),
         QT_TRANSLATE_NOOP("ui::Pages", "Drive and monitor the servo")},
    Page{"memory", Command::PageMemory, QT_TRANSLATE_NOOP("ui::Pages", "Memory"),
         QT_TRANSLATE_NOOP("ui::Pages",
                           "Read and safely write every setting in the servo's memory table")},
    Page{"sweep", Command::PageSweep, QT_TRANSLATE_NOOP("ui::Pages", "Sweep test"),
         QT_TRANSLATE_NOOP("ui::Pages", "Run a sweep test and evaluate the result")},
    Page{"step", Command::PageStep, QT_TRANSLATE_NOOP("ui::Pages", "Step response"),
         QT_TRANSLATE_NOOP("ui::Pages", "See how a servo responds to a step, and try other gains")},
    Page{"snapshots", Command::PageSnapshots, QT_TRANSLATE_NOOP("ui::Pages", "Snapshots"),
         QT_TRANSLATE_NOOP("ui::Pages", "Save, compare and restore servo settings")},
    Page{"commission", Command::PageCommission, QT_TRANSLATE_NOOP("ui::Pages", "Commissioning"),
         QT_TRANSLATE_NOOP("ui::Pages", "Set up servos one at a time")},
    Page{"history", Command::PageHistory, QT_TRANSLATE_NOOP("ui::Pages", "History"),
         QT_TRANSLATE_NOOP("ui::Pages", "All writes, snapshots, tests and alarms")}};
} // namespace

/// A page made as a child of the stack that will hold it is laid out and styled once; as a child of
/// the tabs, all its widgets would get their style a second time when it moves into the stack.
Pages::Pages(AppContext& appContext, session::Settings& settings, QWidget* parent)
    : QTabWidget(parent)
{
    auto* stack = findChild<QStackedWidget*>();
    m_operate = new OperatePage(appContext, settings, stack);
    m_trend = m_operate->trend();
    setObjectName(QStringLiteral("pages"));
    setDocumentMode(true);
    tabBar()->setDrawBase(false);
    auto* memory = new MemoryPage(appContext.workbench, appContext.commands, appContext.selection,
                                  settings, stack);
    auto* sweep = new SweepPage(appContext, settings, stack);
    m_step = new StepPage(appContext, settings, stack);
    m_snapshots = new SnapshotsPage(appContext, settings, stack);
    auto* commission = new CommissionPage(appContext, settings, stack);
    m_history = new HistoryPage(appContext, settings, stack);
    for (QWidget* page : std::initializer_list<QWidget*>{m_operate, memory, sweep, m_step,
                                                         m_snapshots, commission, m_history})
        addTab(page, QString());
    for (int i = 0; i < count(); ++i)
        widget(i)->layout()->setContentsMargins(cardMargin, cardMargin, cardMargin, cardMargin);
    connectCommands(appContext.commands);
    connectHistory(appContext.commands);
    connect(sweep, &SweepPage::previousTestsRequested,
            appContext.commands.action(Command::PreviousTests), &QAction::trigger);
}

void Pages::open(const QString& name)
{
    for (int i = 0; i < count(); ++i) {
        if (name != QLatin1StringView(allPages[static_cast<std::size_t>(i)].name))
            continue;
        if (widget(i) == m_step || widget(i) == m_snapshots || widget(i) == m_history)
            openWithoutServo(widget(i));
        else
            setCurrentIndex(i);
    }
}

bool Pages::isUsableWithoutServo() const
{
    return m_openedWithoutServo || m_trend->isReplaying();
}

void Pages::openWithoutServo(QWidget* page)
{
    setCurrentWidget(page);
    m_openedWithoutServo = true;
    Q_EMIT usableWithoutServo();
}

void Pages::connectCommands(const Commands& commands)
{
    for (const Page& page : allPages) {
        connect(commands.action(page.command), &QAction::triggered, this,
                [this, name = QString::fromLatin1(page.name)] { open(name); });
    }
    const auto on = [&](Command command, QWidget* page, auto slot) {
        connect(commands.action(command), &QAction::triggered, this, [this, page, slot] {
            setCurrentWidget(page);
            slot();
        });
    };
    on(Command::TakeSnapshot, m_snapshots, [this] { m_snapshots->takeSnapshot(); });
    on(Command::PauseTrend, m_operate, [this] { m_trend->toggleFollowing(); });
    on(Command::Record, m_operate, [this] { m_trend->toggleRecording(); });
    on(Command::OpenRecording, m_operate, [this] { m_trend->openRecording(); });
    connect(m_trend, &TrendPanel::replayShown, this, &Pages::usableWithoutServo);
}

/// What is found in the history is opened where it can be used.
void Pages::connectHistory(const Commands& commands)
{
    connect(m_history, &HistoryPage::snapshotRequested, this, [this](std::int64_t number) {
        setCurrentWidget(m_snapshots);
        m_snapshots->showHistorySnapshot(number);
    });
    connect(m_history, &HistoryPage::tableRequested, this,
            [this](const session::SharedSnapshot& table, const QString& title) {
                setCurrentWidget(m_snapshots);
                m_snapshots->showTable(table, title);
            });
    connect(m_history, &HistoryPage::stepResponseRequested, this, [this](std::int64_t number) {
        setCurrentWidget(m_step);
        m_step->openStored({number});
    });
    connect(m_history, &HistoryPage::previousTestsRequested,
            commands.action(Command::PreviousTests), &QAction::trigger);
}

/// The strip of the tabs belongs to the window's bars, not to the ground of the pages.
void Pages::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const QRect strip(0, 0, width(), tabBar()->height());
    painter.fillRect(strip, palette().color(QPalette::AlternateBase));
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(strip.bottomLeft(), strip.bottomRight());
}

void Pages::retranslate()
{
    for (int i = 0; i < count(); ++i) {
        setTabText(i, tr(allPages[static_cast<std::size_t>(i)].title));
        setTabToolTip(i, tr(allPages[static_cast<std::size_t>(i)].toolTip));
    }
    setAccessibleName(tr("Pages"));
}
} // namespace ui
