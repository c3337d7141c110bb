// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/snapshot_actions.h"

#include "report/report_file.h"
#include "snapshot/factory_snapshot.h"
#include "text/language.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/snapshots/snapshot_browser.h"
#include "ui/snapshots/template_dialog.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/note_dialog.h"
#include "ui/widgets/question_dialog.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <QPushButton>
#include <QToolButton>

namespace ui {
namespace {
const QString snapshotSuffix = QStringLiteral(".servo.json");
const QString bundleSuffix = QStringLiteral(".bundle.json");

/// A double suffix, which a file dialog does not add by itself.
QString withSuffix(const QString& path, const QString& end)
{
    if (path.endsWith(QLatin1StringView(".csv"), Qt::CaseInsensitive) ||
        path.endsWith(end, Qt::CaseInsensitive))
        return path;
    return (path.endsWith(QLatin1StringView(".json"), Qt::CaseInsensitive) ? path.chopped(5)
                                                                           : path) +
           end;
}

QString fileNamePart(QString name)
{
    for (QChar& letter : name) {
        if (!letter.isLetterOrNumber() && letter != QLatin1Char('-'))
            letter = QLatin1Char('_');
    }
    return name;
}
} // namespace

SnapshotActions::SnapshotActions(AppContext& appContext, session::Settings& settings,
                                 SnapshotBrowser& browser, QWidget* parent)
    : QWidget(parent)
    , m_workbench(appContext.workbench)
    , m_workbenchGuard(&appContext.workbench)
    , m_snapshots(appContext.workbench.snapshots())
    , m_selection(appContext.selection)
    , m_settings(settings)
    , m_browser(browser)
{
    build();
    connectAll();
    followLanguage(this, [this] { retranslate(); });
}

void SnapshotActions::build()
{
    auto* row = new FlowLayout(this, 6);
    m_take = new QPushButton(this);
    m_take->setObjectName(QStringLiteral("snapshotTake"));
    makeMainAction(m_take);
    m_open = new QPushButton(this);
    m_open->setObjectName(QStringLiteral("snapshotOpen"));
    m_more = new QToolButton(this);
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
    row->addWidget(m_take);
    row->addWidget(m_open);
    row->addWidget(m_more);
}

void SnapshotActions::connectAll()
{
    connect(m_take, &QPushButton::clicked, this, &SnapshotActions::take);
    connect(m_open, &QPushButton::clicked, this, &SnapshotActions::open);
    connect(m_saveCopy, &QAction::triggered, this, &SnapshotActions::saveCopy);
    connect(m_note, &QAction::triggered, this, &SnapshotActions::editNote);
    connect(m_bundle, &QAction::triggered, this, &SnapshotActions::saveBundle);
    connect(m_remove, &QAction::triggered, this, &SnapshotActions::deleteSnapshots);
    connect(&m_snapshots, &session::Snapshots::takingChanged, this,
            &SnapshotActions::updateControls);
}

void SnapshotActions::updateControls()
{
    if (!m_workbenchGuard)
        return;
    const bool canTake = m_workbench.link().state() == session::LinkState::Open &&
                         !m_workbench.tasks().isTesting() && !m_snapshots.isTaking();
    const session::ServoEntry* entry = m_workbench.registry().servo(m_selection.current());
    m_take->setEnabled(canTake && entry != nullptr && entry->servo.profile);
    m_bundle->setEnabled(canTake && !m_workbench.registry().order().empty());
    m_saveCopy->setEnabled(selected() && !m_browser.bundle());
    m_note->setEnabled(m_browser.selectedHistoryRow().has_value());
    m_remove->setEnabled(!m_browser.selectedNumbers().empty());
}

QString SnapshotActions::folderKey()
{
    return QStringLiteral("snapshots/folder");
}

session::SharedSnapshot SnapshotActions::selected() const
{
    const auto snapshots = m_browser.selectedSnapshots();
    return snapshots.empty() ? nullptr : snapshots.front().snapshot;
}

void SnapshotActions::askForPath(const QString& title, const QString& name,
                                 const QStringList& filters, FileChosen chosen)
{
    askForSavePath(
        this,
        {QStringLiteral("snapshotFileDialog"), title, filters, name, &m_settings, folderKey()},
        std::move(chosen));
}

void SnapshotActions::take()
{
    Q_EMIT started();
    m_snapshots.take(m_selection.current(), {});
}

void SnapshotActions::open()
{
    Q_EMIT started();
    askForFiles(this,
                {QStringLiteral("snapshotOpenDialog"),
                 tr("Open snapshots"),
                 {tr("Snapshots and bundles (*.servo.json *.bundle.json)"), tr("All files (*)")},
                 {},
                 &m_settings,
                 folderKey()},
                [this](const QString& path) { m_snapshots.open(path); });
}

void SnapshotActions::saveCopy()
{
    const session::SharedSnapshot table = selected();
    if (!table)
        return;
    const QString name = QStringLiteral("%1-id%2-%3")
                             .arg(fileNamePart(table->servo.model))
                             .arg(table->servo.id)
                             .arg(table->at.toLocalTime().toString(QStringLiteral("yyyyMMdd")));
    askForPath(tr("Save the snapshot"), name + snapshotSuffix,
               {tr("Snapshot (*.servo.json)"), tr("Table for spreadsheets (*.csv)"),
                tr("Printable page (*.pdf)"), tr("Web page (*.html)")},
               [this, table](const QString& path) {
                   m_snapshots.save(
                       table, report::isReportPath(path) ? path : withSuffix(path, snapshotSuffix),
                       text::isUiChinese());
               });
}

void SnapshotActions::saveBundle()
{
    askForPath(
        tr("Save snapshots of all servos"), QStringLiteral("servos") + bundleSuffix,
        {tr("Bundle (*.bundle.json)")}, [this](const QString& path) {
            Q_EMIT started();
            m_snapshots.takeAll({QFileInfo(path).baseName(), {}, withSuffix(path, bundleSuffix)});
        });
}

void SnapshotActions::saveTemplate()
{
    const session::SharedSnapshot from = selected();
    const auto profile = from ? snapshot::profileOf(*from, m_workbench.catalog()) : nullptr;
    if (!profile)
        return;
    auto* dialog = new TemplateDialog(*from, profile, this);
    connect(dialog, &TemplateDialog::accepted, this,
            [this, dialog, from] { askTemplateFile(from, dialog->keys()); });
    dialog->open();
}

void SnapshotActions::askTemplateFile(const session::SharedSnapshot& from, const QStringList& keys)
{
    askForPath(tr("Save the template"), QStringLiteral("template") + snapshotSuffix,
               {tr("Template (*.servo.json)")}, [this, from, keys](const QString& path) {
                   const auto made =
                       m_snapshots.toTemplate(*from, keys, {QFileInfo(path).baseName()});
                   if (made)
                       m_snapshots.save(*made, withSuffix(path, snapshotSuffix), false);
                   else
                       Q_EMIT failed(made.error());
               });
}

void SnapshotActions::editNote()
{
    const auto row = m_browser.selectedHistoryRow();
    if (!row)
        return;
    auto* dialog = new NoteDialog(row->label, row->note, this);
    connect(dialog, &NoteDialog::accepted, this, [this, dialog, number = row->number] {
        m_browser.invalidate(number);
        m_workbench.history().setSnapshotNote(number, dialog->label(), dialog->note());
    });
    dialog->open();
}

void SnapshotActions::deleteSnapshots()
{
    const auto numbers = m_browser.selectedNumbers();
    if (numbers.empty())
        return;
    Question question;
    question.title = tr("Delete %n snapshot(s)?", nullptr, int(numbers.size()));
    question.text = tr("This affects only the history on this computer. Files are not deleted.");
    question.risk = tr("This cannot be undone.");
    question.acceptText = tr("Delete");
    question.guard = this;
    ask(this, question, [this, numbers] { m_workbench.history().removeSnapshots(numbers); });
}

void SnapshotActions::retranslate()
{
    setButtonText(
        m_take, tr("Take snapshot"),
        tr("Reads the whole memory table of the selected servo and saves it in the history"));
    setButtonText(m_open, tr("Open file…"),
                  tr("Opens snapshots, templates or bundles; they can also be dropped here"));
    setButtonText(m_more, tr("More"), tr("Save, label or delete a snapshot; save all servos"));
    m_saveCopy->setText(tr("Save as file…"));
    m_note->setText(tr("Label and note…"));
    m_bundle->setText(tr("Save all servos as a bundle…"));
    m_remove->setText(tr("Delete from the history…"));
}
} // namespace ui
