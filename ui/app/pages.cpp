// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/pages.h"

#include "session/snapshot/snapshots.h"
#include "ui/arm/arm_page.h"
#include "ui/commissioning/commission_page.h"
#include "ui/common/widget_style.h"
#include "ui/firmware/firmware_page.h"
#include "ui/history/history_page.h"
#include "ui/memory/memory_page.h"
#include "ui/operate/operate_page.h"
#include "ui/snapshots/snapshots_page.h"
#include "ui/step/step_page.h"
#include "ui/sweep/sweep_page.h"
#include "ui/trends/trend_panel.h"

#include <QFile>
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
    Page{"arm", Command::PageArm, QT_TRANSLATE_NOOP("ui::Pages", "Arm"),
         QT_TRANSLATE_NOOP("ui::Pages", "Calibrate a robot arm by moving its joints")},
    Page{"firmware", Command::PageFirmware, QT_TRANSLATE_NOOP("ui::Pages", "Firmware"),
         QT_TRANSLATE_NOOP("ui::Pages", "Compare the firmware versions of the servos")},
    Page{"history", Command::PageHistory, QT_TRANSLATE_NOOP("ui::Pages", "History"),
         QT_TRANSLATE_NOOP("ui::Pages", "All writes, snapshots, tests and alarms")}};

/// By what it begins with; a table without that is named as no recording.
bool isRecording(const QString& path)
{
    constexpr qint64 headSize = 4096;
    QFile file(path);
    const QByteArray head = file.open(QIODevice::ReadOnly) ? file.read(headSize) : QByteArray();
    return head.contains("# ServoDesk recording ") || head.contains("\"servodesk-recording\"") ||
           path.endsWith(QLatin1String(".csv"), Qt::CaseInsensitive) ||
           path.endsWith(QLatin1String(".jsonl"), Qt::CaseInsensitive);
}

template <typename Page>
Page* makePage(AppContext& context, session::Settings& settings, QWidget* parent)
{
    return new Page(context, settings, parent);
}

template <>
MemoryPage* makePage(AppContext& context, session::Settings& settings, QWidget* parent)
{
    return new MemoryPage(context.workbench, context.commands, context.selection, settings, parent);
}
} // namespace

Pages::Pages(AppContext& appContext, session::Settings& settings, QWidget* parent)
    : QTabWidget(parent)
    , m_context(appContext)
    , m_settings(settings)
{
    setObjectName(QStringLiteral("pages"));
    setDocumentMode(true);
    tabBar()->setDrawBase(false);
    m_operate = add<OperatePage>(&Pages::connectOperate);
    m_memory = add<MemoryPage>();
    add<SweepPage>(&Pages::connectSweep);
    m_step = add<StepPage>();
    m_snapshots = add<SnapshotsPage>();
    add<CommissionPage>();
    add<ArmPage>();
    add<FirmwarePage>();
    m_history = add<HistoryPage>(&Pages::connectHistory);
    connectCommands();
}

/// As a child of the stack that will hold it, a page is laid out and styled once; as a child of the
/// tabs, all its widgets would get their style a second time when it moves into the stack.
template <typename Page>
LazyPage<Page>* Pages::add(void (Pages::*connectPage)(Page&))
{
    auto* tab = new LazyPage<Page>(
        [this, connectPage](QWidget* parent) {
            auto* page = makePage<Page>(m_context, m_settings, parent);
            if (connectPage != nullptr)
                (this->*connectPage)(*page);
            return page;
        },
        findChild<QStackedWidget*>());
    addTab(tab, QString());
    return tab;
}

template <typename Page>
Page& Pages::open(LazyPage<Page>* page)
{
    setCurrentWidget(page);
    return page->page();
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

void Pages::openFile(const QString& path)
{
    if (isRecording(path)) {
        openWithoutServo(m_operate);
        openTrend().load(path);
    } else {
        openWithoutServo(m_snapshots);
        (void)m_snapshots->page(); // shows what becomes of it
        m_context.workbench.snapshots().open(path);
    }
}

bool Pages::isUsableWithoutServo() const
{
    return m_openedWithoutServo ||
           (m_operate->isMade() && m_operate->page().trend()->isReplaying());
}

void Pages::openWithoutServo(QWidget* page)
{
    setCurrentWidget(page);
    m_openedWithoutServo = true;
    Q_EMIT usableWithoutServo();
}

TrendPanel& Pages::openTrend()
{
    return *open(m_operate).trend();
}

void Pages::connectCommands()
{
    const Commands& commands = m_context.commands;
    for (const Page& page : allPages) {
        connect(commands.action(page.command), &QAction::triggered, this,
                [this, name = QString::fromLatin1(page.name)] { open(name); });
    }
    const auto on = [&](Command command, auto slot) {
        connect(commands.action(command), &QAction::triggered, this, slot);
    };
    on(Command::UseSimulatedArm, [this] { open(QStringLiteral("arm")); });
    on(Command::TakeSnapshot, [this] { open(m_snapshots).takeSnapshot(); });
    on(Command::PauseTrend, [this] { openTrend().toggleFollowing(); });
    on(Command::Record, [this] { openTrend().toggleRecording(); });
    on(Command::OpenRecording, [this] { openTrend().openRecording(); });
}

void Pages::connectOperate(OperatePage& page)
{
    connect(page.trend(), &TrendPanel::replayShown, this, &Pages::usableWithoutServo);
}

void Pages::connectSweep(SweepPage& page)
{
    connect(&page, &SweepPage::previousTestsRequested,
            m_context.commands.action(Command::PreviousTests), &QAction::trigger);
}

/// What is found in the history is opened where it can be used.
void Pages::connectHistory(HistoryPage& page)
{
    connect(&page, &HistoryPage::snapshotRequested, this,
            [this](std::int64_t number) { open(m_snapshots).showHistorySnapshot(number); });
    connect(&page, &HistoryPage::tableRequested, this,
            [this](const session::SharedSnapshot& table, const QString& title) {
                open(m_snapshots).showTable(table, title);
            });
    connect(&page, &HistoryPage::stepResponseRequested, this,
            [this](std::int64_t number) { open(m_step).openStored({number}); });
    connect(&page, &HistoryPage::previousTestsRequested,
            m_context.commands.action(Command::PreviousTests), &QAction::trigger);
}

void Pages::showEvent(QShowEvent* event)
{
    m_operate->page();
    m_memory->page();
    QTabWidget::showEvent(event);
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
