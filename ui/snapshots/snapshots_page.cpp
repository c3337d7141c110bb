// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/snapshots_page.h"

#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/snapshots/compare_tables.h"
#include "ui/snapshots/restore_panel.h"
#include "ui/snapshots/restore_text.h"
#include "ui/snapshots/snapshot_actions.h"
#include "ui/snapshots/snapshot_browser.h"
#include "ui/snapshots/snapshot_pane.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/floating_overlay.h"
#include "ui/widgets/task_text.h"

#include <QDir>
#include <QDragEnterEvent>
#include <QMenu>
#include <QMimeData>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

#include <utility>

namespace ui {
namespace {
constexpr int minBrowserWidth = 230;
constexpr int browserWidth = 280;
constexpr auto refreshDelay = std::chrono::milliseconds(150);
constexpr auto ageStep = std::chrono::seconds(1);
} // namespace

SnapshotsPage::SnapshotsPage(AppContext& appContext, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_context(appContext)
    , m_workbench(appContext.workbench)
    , m_workbenchGuard(&appContext.workbench)
    , m_settings(settings)
    , m_snapshots(appContext.workbench.snapshots())
    , m_selection(appContext.selection)
    , m_tables(new CompareTables(appContext, this))
{
    setObjectName(QStringLiteral("snapshotsPage"));
    setAcceptDrops(true);
    build();
    connectParts();
    connectSession();
    onServoSelected();
    followLanguage(this, [this] {
        setAccessibleName(tr("Snapshots"));
        refresh();
    });
}

void SnapshotsPage::build()
{
    auto* column = new QVBoxLayout(this);
    m_banner = new Banner(this);
    m_banner->setObjectName(QStringLiteral("snapshotsBanner"));
    m_banner->hideMessage();
    auto* split = new QSplitter(Qt::Horizontal, this);
    split->setObjectName(QStringLiteral("snapshotsSplit"));
    split->setChildrenCollapsible(false);
    split->setHandleWidth(cardMargin);
    split->addWidget(buildBrowser());
    split->addWidget(buildCompare());
    split->setStretchFactor(0, 0);
    split->setStretchFactor(1, 1);
    split->setSizes({browserWidth, 3 * browserWidth});
    column->addWidget(split, 1);
    new FloatingOverlay(m_banner, m_pane, FloatingOverlay::Corner::BottomRight);
    m_columns = new QMenu(this);
    m_columns->setObjectName(QStringLiteral("compareColumnsMenu"));
    m_pane->columns()->setMenu(m_columns);
    m_refreshTimer.setSingleShot(true);
    m_refreshTimer.setInterval(refreshDelay);
    m_ageTimer.setInterval(ageStep);
}

QWidget* SnapshotsPage::buildBrowser()
{
    auto* box = new QWidget(this);
    box->setMinimumWidth(minBrowserWidth);
    auto* column = new QVBoxLayout(box);
    m_browser = new SnapshotBrowser(m_workbench, m_workbench.history(), m_selection, box);
    m_actions = new SnapshotActions(m_context, m_settings, *m_browser, box);
    column->addWidget(m_browser, 1);
    column->addWidget(m_actions);
    makeCard(box);
    return box;
}

QWidget* SnapshotsPage::buildCompare()
{
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    m_pane = new SnapshotPane(box);
    m_restore = new RestorePanel(m_context, m_settings, *m_browser, m_pane->model(), box);
    column->addWidget(m_pane, 1);
    column->addWidget(m_restore);
    makeCard(box);
    return box;
}

void SnapshotsPage::connectParts()
{
    connect(&m_refreshTimer, &QTimer::timeout, this, &SnapshotsPage::refresh);
    connect(&m_ageTimer, &QTimer::timeout, this, &SnapshotsPage::scheduleRefresh);
    connect(m_browser, &SnapshotBrowser::snapshotSelectionChanged, this, &SnapshotsPage::refresh);
    connect(m_browser, &SnapshotBrowser::failed, this, &SnapshotsPage::showError);
    connect(m_actions, &SnapshotActions::started, m_banner, &Banner::hideMessage);
    connect(m_actions, &SnapshotActions::failed, this, &SnapshotsPage::showError);
    connect(m_restore, &RestorePanel::started, m_banner, &Banner::hideMessage);
    connect(m_restore, &RestorePanel::finished, this, &SnapshotsPage::onRestored);
    connect(m_restore, &RestorePanel::failed, this, &SnapshotsPage::showError);
    connect(m_restore, &RestorePanel::templateRequested, m_actions, &SnapshotActions::saveTemplate);
    connect(m_columns, &QMenu::aboutToShow, this, [this] { m_tables->fillMenu(*m_columns); });
    connect(m_tables, &CompareTables::selectionChanged, this, &SnapshotsPage::refresh);
    connect(m_tables, &CompareTables::servoChanged, this, &SnapshotsPage::scheduleRefresh);
}

void SnapshotsPage::connectSession()
{
    connect(&m_snapshots, &session::Snapshots::failed, this, &SnapshotsPage::showError);
    connect(&m_snapshots, &session::Snapshots::saved, this, &SnapshotsPage::showSaved);
    connect(&m_snapshots, &session::Snapshots::snapshotTaken, this, &SnapshotsPage::showTaken);
    connect(&m_snapshots, &session::Snapshots::fileOpened, this,
            [this](const session::OpenedFile& file) { m_browser->add(file); });
    connect(&m_snapshots, &session::Snapshots::bundleTaken, this,
            [this](const session::SharedBundle& bundle, const QString& path) {
                m_browser->add({path, {}, bundle});
                showSaved(path);
            });
    // After undo, the result of the restore no longer applies.
    connect(&m_workbench, &session::Workbench::eventOccurred, this,
            [this](const session::Event& event) {
                if ((event.isUndo || event.isRedo) && std::exchange(m_bannerShowsRestore, false))
                    m_banner->hideMessage();
            });
    connect(&m_selection, &Selection::changed, this, &SnapshotsPage::onServoSelected);
    connect(&m_workbench, &session::Workbench::stateChanged, this, &SnapshotsPage::scheduleRefresh);
}

/// The servo is compared as it is now: its table is read anew when it is selected.
void SnapshotsPage::onServoSelected()
{
    if (!m_workbenchGuard)
        return;
    if (isVisible() && m_tables->servo() != nullptr && !m_restore->isWriting())
        m_workbench.writes().readTable(m_selection.current());
    scheduleRefresh();
}

void SnapshotsPage::scheduleRefresh()
{
    if (isVisible() && !m_refreshTimer.isActive())
        m_refreshTimer.start();
}

void SnapshotsPage::refresh()
{
    if (!m_workbenchGuard)
        return;
    m_pane->show(titleText(), m_tables->columns(m_browser->selectedSnapshots()),
                 m_restore->makePlan(m_tables->servo()), emptyText(), m_tables->ages());
    updateControls();
    m_tables->setActive(isVisible());
}

void SnapshotsPage::updateControls()
{
    m_actions->updateControls();
    m_restore->updateControls();
}

QString SnapshotsPage::emptyText() const
{
    const session::ServoEntry* servo = m_tables->servo();
    if (servo == nullptr)
        return tr("Select a servo in the list or a snapshot on the left.");
    if (!servo->hasFullTable)
        return tr("Reading the servo's memory table…");
    return tr("Select a snapshot on the left to compare the servo with it, or open a file.");
}

bool SnapshotsPage::isOfOtherModel(const snapshot::Snapshot& table) const
{
    if (m_tables->servo() == nullptr)
        return false;
    const catalog::Profile& profile = *m_tables->servo()->servo.profile;
    return table.servo.map != profile.mapKey || table.servo.modelId != profile.identity.modelId();
}

QString SnapshotsPage::titleText() const
{
    if (const session::SharedBundle bundle = m_browser->bundle())
        return tr("Bundle (servos: %1); select a servo to compare it").arg(bundle->servos.size());
    const session::ServoEntry* entry = m_tables->servo();
    const QString servo = entry != nullptr ? servoTitle(*entry) : QString();
    const std::vector<SnapshotSelection> selected = m_browser->selectedSnapshots();
    if (selected.empty())
        return servo;
    const snapshot::Snapshot& table = *selected.front().snapshot;
    const QDateTime at = table.at.toLocalTime();
    QStringList parts{selected.front().title,
                      QStringLiteral("%1 · ID %2").arg(table.servo.model).arg(table.servo.id)};
    if (at.isValid())
        parts << at.toString(QStringLiteral("yyyy-MM-dd HH:mm"));
    if (isOfOtherModel(table))
        parts << tr("another model");
    const QString snapshot = parts.join(QStringLiteral(" · "));
    return servo.isEmpty() ? snapshot : tr("%1 vs. %2").arg(servo, snapshot);
}

void SnapshotsPage::takeSnapshot()
{
    m_actions->take();
}

void SnapshotsPage::showHistorySnapshot(std::int64_t number)
{
    m_browser->selectNumber(number);
}

void SnapshotsPage::showTable(session::SharedSnapshot table, const QString& title)
{
    m_browser->add(std::move(table), title);
}

void SnapshotsPage::onRestored(const session::RestoreCompletion& end)
{
    if (end.error) {
        showError(*end.error);
    } else if (end.outcome) {
        m_bannerShowsRestore = true;
        m_banner->showMessage(
            [&model = m_pane->model(), outcome = *end.outcome] {
                const RegisterNames names{
                    [&model](const QString& key) { return model.nameOf(key); },
                    [&model](const QString& key, std::int64_t raw) {
                        return model.formatted(key, raw);
                    }};
                return restoreOutcomeText(outcome, names);
            },
            {m_restore->saveResultAction()});
    }
    scheduleRefresh();
}

void SnapshotsPage::showTaken(const session::SharedSnapshot& snapshot)
{
    m_bannerShowsRestore = false;
    m_banner->showMessage([snapshot] {
        return BannerText{Tone::Good, tr("Snapshot of ID %1 · %2 saved: %3 registers.")
                                          .arg(snapshot->servo.id)
                                          .arg(snapshot->servo.model)
                                          .arg(snapshot->registers.size())};
    });
}

void SnapshotsPage::showSaved(const QString& path)
{
    m_bannerShowsRestore = false;
    m_banner->showMessage([path] {
        return BannerText{Tone::Good, tr("Saved: %1").arg(QDir::toNativeSeparators(path))};
    });
}

void SnapshotsPage::showError(const base::Error& error)
{
    m_bannerShowsRestore = false;
    if (error.code != base::ErrorCode::Stopped)
        m_banner->showMessage(error);
    updateControls();
}

void SnapshotsPage::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void SnapshotsPage::dropEvent(QDropEvent* event)
{
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile())
            m_snapshots.open(url.toLocalFile());
    }
}

void SnapshotsPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    m_ageTimer.start();
    onServoSelected();
}

void SnapshotsPage::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    m_ageTimer.stop();
    m_tables->setActive(false);
}
} // namespace ui
