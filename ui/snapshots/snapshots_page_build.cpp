// SPDX-License-Identifier: GPL-3.0-or-later
// What the snapshots page consists of, and its words.
#include "ui/snapshots/snapshot_browser.h"
#include "ui/snapshots/snapshot_pane.h"
#include "ui/snapshots/snapshots_page.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/floating_overlay.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/press_guard.h"

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>

namespace ui {
namespace {
constexpr int minBrowserWidth = 230;
constexpr int browserWidth = 280;
constexpr auto refreshAfter = std::chrono::milliseconds(150);
constexpr auto ageStep = std::chrono::seconds(1);
} // namespace

void SnapshotsPage::build()
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 6, 0, 0);
    m_banner = new Banner(this);
    m_banner->setObjectName(QStringLiteral("snapshotsBanner"));
    m_banner->hideMessage();
    auto* split = new QSplitter(Qt::Horizontal, this);
    split->setObjectName(QStringLiteral("snapshotsSplit"));
    split->setChildrenCollapsible(false);
    split->addWidget(buildBrowser());
    auto* right = new QWidget(split);
    auto* rows = new QVBoxLayout(right);
    rows->setContentsMargins(6, 0, 0, 0);
    m_pane = new SnapshotPane(right);
    rows->addWidget(m_pane, 1);
    rows->addWidget(buildActions());
    split->addWidget(right);
    split->setStretchFactor(0, 0);
    split->setStretchFactor(1, 1);
    split->setSizes({browserWidth, 3 * browserWidth});
    column->addWidget(split, 1);
    new FloatingOverlay(m_banner, m_pane, FloatingOverlay::Corner::BottomRight);
    m_columns = new QMenu(this);
    m_columns->setObjectName(QStringLiteral("compareColumnsMenu"));
    m_pane->columns()->setMenu(m_columns);
    m_saveResult = new QAction(this);
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(refreshAfter);
    m_age.setInterval(ageStep);
}

QWidget* SnapshotsPage::buildBrowser()
{
    auto* box = new QWidget(this);
    box->setMinimumWidth(minBrowserWidth);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 6, 0);
    m_browser = new SnapshotBrowser(m_desk, m_historyService, m_selection, box);
    auto* buttons = new FlowLayout(nullptr, 6);
    m_take = new QPushButton(box);
    m_take->setObjectName(QStringLiteral("snapshotTake"));
    m_take->setProperty("mainAction", true);
    m_open = new QPushButton(box);
    m_open->setObjectName(QStringLiteral("snapshotOpen"));
    m_more = new QToolButton(box);
    m_more->setObjectName(QStringLiteral("snapshotMore"));
    m_more->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(m_more);
    const auto action = [menu](const char* name) {
        QAction* made = menu->addAction(QString());
        made->setObjectName(QString::fromLatin1(name));
        return made;
    };
    m_saveCopy = action("snapshotSaveCopy");
    m_note = action("snapshotNote");
    m_bundle = action("snapshotBundle");
    menu->addSeparator();
    m_remove = action("snapshotRemove");
    m_more->setMenu(menu);
    buttons->addWidget(m_take);
    buttons->addWidget(m_open);
    buttons->addWidget(m_more);
    column->addWidget(m_browser, 1);
    column->addLayout(buttons);
    return box;
}

QWidget* SnapshotsPage::buildActions()
{
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins({});
    auto* ticks = new FlowLayout(nullptr, 14);
    const auto check = [&](const char* name) {
        auto* made = new QCheckBox(box);
        made->setObjectName(QString::fromLatin1(name));
        ticks->addWidget(made);
        return made;
    };
    m_identity = check("restoreIdentity");
    m_rollBack = check("restoreRollBack");
    auto* row = new FlowLayout(nullptr, 6);
    const auto button = [&](const char* name) {
        auto* made = new QPushButton(box);
        made->setObjectName(QString::fromLatin1(name));
        row->addWidget(made);
        return made;
    };
    m_write = button("restoreWrite");
    m_write->setProperty("mainAction", true);
    m_dryRun = button("restoreDryRun");
    m_applyToSeveral = button("restoreSeveral");
    m_template = button("restoreTemplate");
    m_order = new QLabel(box);
    m_order->setObjectName(QStringLiteral("restoreOrder"));
    m_order->setWordWrap(true);
    // The buttons stand last: the words above them must not move them.
    column->addLayout(ticks);
    column->addWidget(m_order);
    column->addLayout(row);
    for (QWidget* writer : {m_write, m_applyToSeveral})
        new PressGuard(writer);
    return box;
}

void SnapshotsPage::connectAll()
{
    connect(&m_refresh, &QTimer::timeout, this, &SnapshotsPage::refresh);
    connect(&m_age, &QTimer::timeout, this, &SnapshotsPage::scheduleRefresh);
    connect(m_browser, &SnapshotBrowser::snapshotSelectionChanged, this, &SnapshotsPage::refresh);
    connect(m_browser, &SnapshotBrowser::failed, this, &SnapshotsPage::showError);
    connect(&m_pane->model(), &CompareModel::selectedRowsChanged, this, [this] {
        rememberChecks();
        if (!m_showing)
            showState();
    });
    connect(m_columns, &QMenu::aboutToShow, this, &SnapshotsPage::fillColumns);
    connect(m_identity, &QCheckBox::toggled, this,
            [this](bool on) { m_pane->model().setAllSelected(jobs::RestoreReason::Identity, on); });
    connect(m_take, &QPushButton::clicked, this, &SnapshotsPage::takeSnapshot);
    connect(m_open, &QPushButton::clicked, this, &SnapshotsPage::openFiles);
    connect(m_saveCopy, &QAction::triggered, this, &SnapshotsPage::saveCopy);
    connect(m_note, &QAction::triggered, this, &SnapshotsPage::editNote);
    connect(m_bundle, &QAction::triggered, this, &SnapshotsPage::saveBundle);
    connect(m_remove, &QAction::triggered, this, &SnapshotsPage::deleteSnapshots);
    connect(m_write, &QPushButton::clicked, this, &SnapshotsPage::confirmWrite);
    connect(m_dryRun, &QPushButton::clicked, this, &SnapshotsPage::dryRun);
    connect(m_applyToSeveral, &QPushButton::clicked, this, &SnapshotsPage::applyToSeveral);
    connect(m_template, &QPushButton::clicked, this, &SnapshotsPage::saveTemplate);
    connect(m_saveResult, &QAction::triggered, this, &SnapshotsPage::askResultFile);

    connect(&m_snapshots, &session::Snapshots::failed, this, &SnapshotsPage::showError);
    connect(&m_snapshots, &session::Snapshots::saved, this, &SnapshotsPage::showSaved);
    connect(&m_snapshots, &session::Snapshots::takingChanged, this, &SnapshotsPage::showState);
    connect(&m_snapshots, &session::Snapshots::fileOpened, this,
            [this](const session::OpenedFile& file) { m_browser->add(file); });
    connect(&m_snapshots, &session::Snapshots::bundleTaken, this,
            [this](const session::SharedBundle& bundle, const QString& path) {
                m_browser->add({path, {}, bundle});
                showSaved(path);
            });

    // A restore that has been taken back is no result any more.
    connect(&m_desk, &session::Desk::eventOccurred, this, [this](const session::Event& event) {
        if ((event.isUndo || event.isRedo) && std::exchange(m_bannerShowsRestore, false))
            m_banner->hideMessage();
    });
    connect(&m_selection, &Selection::changed, this, &SnapshotsPage::onServoSelected);
    for (const auto signal : {&session::Desk::linkChanged, &session::Desk::searchChanged,
                              &session::Desk::servosCleared, &session::Desk::taskChanged})
        connect(&m_desk, signal, this, &SnapshotsPage::scheduleRefresh);
    const auto changed = [this](session::ServoRef ref) {
        if (ref == m_selection.current() || m_others.count(ref) > 0)
            scheduleRefresh();
    };
    connect(&m_desk, &session::Desk::servoChanged, this, changed);
    connect(&m_desk, &session::Desk::tableChanged, this, changed);
    connect(&m_desk, &session::Desk::servoRemoved, this,
            [this](session::ServoRef ref) { m_others.erase(ref); });
}

void SnapshotsPage::retranslate()
{
    setAccessibleName(tr("Snapshots"));
    const auto setTexts = [](QAbstractButton* button, const QString& name, const QString& tip) {
        button->setText(name);
        button->setAccessibleName(name);
        button->setToolTip(tip);
    };
    setTexts(m_take, tr("Take snapshot"),
             tr("Read the whole table of the selected servo and keep it in the history"));
    setTexts(m_open, tr("Open file…"),
             tr("Open snapshots, templates or bundles; or drop them here"));
    setTexts(m_more, tr("More"), tr("Save, label or delete a snapshot; save all servos"));
    m_saveCopy->setText(tr("Save as file…"));
    m_note->setText(tr("Label and note…"));
    m_bundle->setText(tr("Save all servos as a bundle…"));
    m_remove->setText(tr("Delete from the history…"));
    setTexts(
        m_identity, tr("ID and rate too"),
        tr("Tick ID and baud rate as well: the servo then answers there. They are written at the "
           "very end"));
    setTexts(m_rollBack, tr("If a row fails, put all back"),
             tr("Otherwise writing ends at the row that fails, and what is written stays"));
    setTexts(m_write, m_write->text(), tr("Write the ticked rows that differ, and only those"));
    setTexts(m_dryRun, tr("Dry run…"), tr("Show exactly what would be written, in which order"));
    setTexts(m_applyToSeveral, m_applyToSeveral->text(),
             tr("Write the ticked rows to more than one servo"));
    setTexts(m_template, tr("Save template…"),
             tr("Choose rows of this snapshot and save them as a file, for setting other servos"));
    m_saveResult->setText(tr("Save result…"));
}
} // namespace ui
