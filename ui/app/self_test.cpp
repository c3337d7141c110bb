// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/self_test.h"

#include "results/sweep_limits.h"
#include "text/error_text.h"
#include "ui/app/main_window.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QTabWidget>

#include <array>
#include <cstdio>

namespace ui {
namespace {
using namespace std::chrono_literals;

constexpr int pollInterval = 20;       // ms
constexpr qint64 maxStepTime = 60'000; // ms: a loaded machine
constexpr qint64 pageTime = 200;       // ms, in which a page is laid out and painted
constexpr qint64 minReportSize = 1000; // bytes
const QString gainKey = QStringLiteral("position_p");

constexpr std::array pages{Command::PageOperate, Command::PageMemory,    Command::PageSweep,
                           Command::PageStep,    Command::PageSnapshots, Command::PageCommission,
                           Command::PageArm,     Command::PageFirmware,  Command::PageHistory};

void printLine(const QString& text)
{
    std::fputs((text + QLatin1Char('\n')).toLocal8Bit().constData(), stdout);
    std::fflush(stdout);
}
} // namespace

SelfTest::SelfTest(AppContext& context, MainWindow& window, const QString& folder)
    : m_context(context)
    , m_workbench(context.workbench)
    , m_window(window)
    , m_reportPath(QDir(folder).filePath(QStringLiteral("sweep.html")))
{
    m_timer.setInterval(pollInterval);
    connect(&m_timer, &QTimer::timeout, this, &SelfTest::check);
    const session::SweepTest& sweep = m_workbench.sweepTest();
    const auto keepError = [this](const base::Error& error) {
        m_sweepError = text::describe(error).message;
    };
    connect(&sweep, &session::SweepTest::failed, this, keepError);
    connect(&sweep, &session::SweepTest::saveFailed, this, keepError);
    connect(&sweep, &session::SweepTest::saved, this, [this] { m_isReportSaved = true; });
    addSteps();
}

void SelfTest::addSteps()
{
    m_steps.push_back(
        {tr("Search the simulated bus"),
         [this] { m_workbench.link().connectTo({.name = QStringLiteral("sim:demo")}); },
         [this] { return m_workbench.search().lastReport() && isIdle(); },
         [this] { return firstServo() != 0 ? QString() : tr("no servos were found"); }});
    addPages();
    addWrite();
    addSweep();
}

void SelfTest::addPages()
{
    for (std::size_t i = 0; i < pages.size(); ++i) {
        const QAction* action = m_context.commands.action(pages[i]);
        m_steps.push_back({tr("Open the page %1").arg(action->iconText()),
                           [this, i] { m_context.commands.action(pages[i])->trigger(); },
                           [this] { return m_stepTime.elapsed() >= pageTime && isIdle(); },
                           [this, i] {
                               return isPageShown(static_cast<int>(i))
                                          ? QString()
                                          : tr("the page is not shown");
                           }});
    }
}

bool SelfTest::isPageShown(int index) const
{
    const auto* tabs = m_window.findChild<QTabWidget*>(QStringLiteral("pages"));
    return tabs != nullptr && tabs->currentIndex() == index && tabs->currentWidget()->isVisible() &&
           !tabs->currentWidget()->findChildren<QWidget*>().isEmpty();
}

void SelfTest::addWrite()
{
    m_steps.push_back(
        {tr("Read the memory table"),
         [this] {
             m_readAt = m_workbench.now();
             m_workbench.writes().readTable(firstServo());
         },
         [this] { return isIdle(); },
         [this] {
             const session::ServoEntry* entry = m_workbench.registry().servo(firstServo());
             const int offset = entry->servo.profile->find(gainKey)->offset;
             const auto readAt = entry->servo.image.readAt(offset);
             return readAt && *readAt >= m_readAt ? QString() : tr("it could not be read");
         }});
    m_steps.push_back(
        {tr("Write a register"),
         [this] {
             m_oldGain = gain().value_or(0);
             m_workbench.writes().write(firstServo(), {.items = {{gainKey, m_oldGain + 1}}});
         },
         [this] { return isIdle(); },
         [this] {
             return gain() == m_oldGain + 1 ? QString() : tr("the servo has another value");
         }});
    m_steps.push_back(
        {tr("Undo the write"), [this] { m_workbench.writes().undo(); }, [this] { return isIdle(); },
         [this] { return gain() == m_oldGain ? QString() : tr("the servo has another value"); }});
}

void SelfTest::addSweep()
{
    const auto sweepProblem = [this] {
        const results::SweepRun* run = m_workbench.sweepTest().run();
        if (run == nullptr || run->end != results::SweepEnd::Finished)
            return m_sweepError.isEmpty() ? tr("it did not finish") : m_sweepError;
        return QString();
    };
    m_steps.push_back({tr("Run a sweep test"),
                       [this] {
                           session::SweepTestRequest request;
                           request.spec.range = {QStringLiteral("1500"), QStringLiteral("2500")};
                           request.spec.pause = 1s;
                           request.spec.cycles = 1;
                           request.spec.releaseAtEnd = true;
                           request.servos = {firstServo()};
                           request.limits = {results::SweepLimits()};
                           if (!m_workbench.sweepTest().start(request))
                               m_sweepError = tr("it did not start");
                       },
                       [this] {
                           return (!m_workbench.sweepTest().isRunning() && isIdle()) ||
                                  !m_sweepError.isEmpty();
                       },
                       sweepProblem});
    m_steps.push_back({tr("Save the report"),
                       [this] { m_workbench.sweepTest().save(m_reportPath, false); },
                       [this] { return m_isReportSaved || !m_sweepError.isEmpty(); },
                       [this] {
                           return QFileInfo(m_reportPath).size() >= minReportSize
                                      ? m_sweepError
                                      : tr("the report is not complete");
                       }});
}

session::ServoRef SelfTest::firstServo() const
{
    for (const session::ServoRef ref : m_workbench.registry().order()) {
        const session::ServoEntry* entry = m_workbench.registry().servo(ref);
        if (entry->servo.profile && entry->servo.profile->find(gainKey) != nullptr)
            return ref;
    }
    return 0;
}

std::optional<std::int64_t> SelfTest::gain() const
{
    const session::ServoEntry* entry = m_workbench.registry().servo(firstServo());
    return entry != nullptr ? entry->servo.raw(*entry->servo.profile->find(gainKey)) : std::nullopt;
}

bool SelfTest::isIdle() const
{
    return !m_workbench.tasks().isBusy() && !m_workbench.search().isSearching();
}

void SelfTest::start()
{
    m_time.start();
    m_timer.start();
    beginNext();
}

void SelfTest::beginNext()
{
    m_stepTime.start();
    m_steps[m_at].begin();
}

void SelfTest::check()
{
    const Step& step = m_steps[m_at];
    if (m_stepTime.elapsed() < pollInterval || !step.isDone()) {
        if (m_stepTime.elapsed() > maxStepTime)
            end(tr("it did not end"));
        return;
    }
    if (const QString problem = step.problem(); !problem.isEmpty())
        return end(problem);
    printLine(QStringLiteral("✓ ") + step.name);
    if (++m_at == m_steps.size())
        return end({});
    beginNext();
}

void SelfTest::end(const QString& problem)
{
    m_timer.stop();
    if (problem.isEmpty()) {
        const int count = static_cast<int>(m_steps.size());
        printLine(tr("ServoDesk works: %n step(s) in %1 s.", nullptr, count)
                      .arg(double(m_time.elapsed()) / 1000, 0, 'f', 1));
    } else {
        printLine(QStringLiteral("✗ %1: %2").arg(m_steps[m_at].name, problem));
    }
    QCoreApplication::exit(problem.isEmpty() ? 0 : 1);
}
} // namespace ui
