// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/firmware/firmware_page.h"

#include "files/csv_text.h"
#include "files/file_error.h"
#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/banner.h"

#include <QAction>
#include <QDir>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSaveFile>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

namespace ui {
namespace {
const QString firmwareSaveOperation = QStringLiteral("export");

enum Column {
    IdColumn,
    ModelColumn,
    NumberColumn,
    VersionColumn,
    NewerColumn,
    NoteColumn,
    columns
};

QString orDash(const QString& text)
{
    return text.isEmpty() ? QStringLiteral("–") : text;
}
} // namespace

struct FirmwarePage::Row {
    session::ServoRef ref = 0;
    int id = 0;
    QString model;   ///< empty: not identified
    QString number;  ///< of the model
    QString version; ///< empty: the servo reports none
    std::optional<catalog::KnownFirmware> newer;
    bool differs = false; ///< from most servos of its model
};

FirmwarePage::FirmwarePage(AppContext& context, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_workbench(context.workbench)
    , m_settings(settings)
    , m_selection(context.selection)
    , m_commands(context.commands)
    , m_title(new QLabel(this))
    , m_summary(new QLabel(this))
    , m_banner(new Banner(this))
    , m_table(new QTableWidget(0, columns, this))
    , m_emptyLabel(new QLabel(this))
    , m_source(new QLabel(this))
    , m_rescue(new QPushButton(this))
    , m_update(new QPushButton(this))
    , m_save(new QPushButton(this))
{
    setObjectName(QStringLiteral("firmwarePage"));
    build();
    const session::ServoRegistry& registry = m_workbench.registry();
    for (const auto signal :
         {&session::ServoRegistry::servoAdded, &session::ServoRegistry::servoChanged,
          &session::ServoRegistry::servoRemoved})
        connect(&registry, signal, this, &FirmwarePage::update);
    connect(&registry, &session::ServoRegistry::servosCleared, this, &FirmwarePage::update);
    connect(&registry, &session::ServoRegistry::orderChanged, this, &FirmwarePage::update);
    connect(m_save, &QPushButton::clicked, this, &FirmwarePage::save);
    for (const auto& [button, command] : {std::pair{m_rescue, Command::RescueFirmware},
                                          std::pair{m_update, Command::UpdateFirmware}}) {
        QAction* action = m_commands.action(command);
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
        connect(action, &QAction::changed, this, [button = button, action] {
            button->setEnabled(action->isEnabled());
            button->setToolTip(action->toolTip());
        });
        button->setEnabled(action->isEnabled());
    }
    connect(&m_selection, &Selection::selectedServosChanged, this, &FirmwarePage::update);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &FirmwarePage::selectServos);
    followLanguage(this, [this] { retranslate(); });
}

void FirmwarePage::build()
{
    auto* card = new QWidget(this);
    makeHeading(m_title);
    m_summary->setObjectName(QStringLiteral("firmwareSummary"));
    m_summary->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("firmwareTable"));
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setFrameShape(QFrame::NoFrame);
    styleTable(m_table);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_emptyLabel->setObjectName(QStringLiteral("firmwareEmpty"));
    makeEmptyState(m_emptyLabel);
    m_source->setObjectName(QStringLiteral("firmwareSource"));
    m_source->setWordWrap(true);
    m_source->setForegroundRole(QPalette::PlaceholderText);
    m_save->setObjectName(QStringLiteral("firmwareSave"));
    m_update->setObjectName(QStringLiteral("firmwareUpdate"));
    m_rescue->setObjectName(QStringLiteral("firmwareRescue"));
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_rescue);
    head->addWidget(m_update);
    head->addWidget(m_save);
    auto* inCard = new QVBoxLayout(card);
    inCard->addLayout(head);
    inCard->addWidget(m_summary);
    inCard->addWidget(m_table, 1);
    inCard->addWidget(m_emptyLabel, 1);
    inCard->addWidget(m_source);
    makeCard(card);
    m_banner->hideMessage();
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_banner);
    column->addWidget(card, 1);
}

void FirmwarePage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    update();
}

std::vector<FirmwarePage::Row> FirmwarePage::rows() const
{
    std::vector<Row> rows;
    std::vector<catalog::ProfilePtr> profiles;
    for (const session::ServoRef ref : m_workbench.registry().order()) {
        const device::Servo& servo = m_workbench.registry().servo(ref)->servo;
        Row row;
        row.ref = ref;
        row.id = servo.id;
        if (const catalog::Profile* profile = servo.profile.get()) {
            row.model = profile->modelName;
            row.number = profile->identity.modelId();
            if (profile->identity.firmwareMajor >= 0)
                row.version = profile->identity.firmware();
            row.newer = m_workbench.catalog().newerFirmware(*profile);
        }
        rows.push_back(std::move(row));
        profiles.push_back(servo.profile);
    }
    const std::vector<bool> differs = catalog::differingFirmware(profiles);
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].differs = differs[i];
    return rows;
}

void FirmwarePage::update()
{
    if (!isVisible())
        return; // the list changes all the time
    const std::vector<Row> all = rows();
    const bool isEmpty = all.empty();
    m_table->setVisible(!isEmpty);
    m_emptyLabel->setVisible(isEmpty);
    m_save->setEnabled(!isEmpty);
    m_summary->setText(summary(all));
    m_summary->setVisible(!m_summary->text().isEmpty());
    m_source->setVisible(
        std::any_of(all.begin(), all.end(), [](const Row& row) { return row.newer.has_value(); }));
    showRows(all);
}

void FirmwarePage::showRows(const std::vector<Row>& rows)
{
    const QSignalBlocker blocker(m_table); // the user has selected nothing here
    m_table->setRowCount(static_cast<int>(rows.size()));
    m_table->clearSelection();
    for (int i = 0; i < m_table->rowCount(); ++i) {
        const Row& row = rows[static_cast<std::size_t>(i)];
        const QString newer =
            row.newer ? tr("%1 (%2)").arg(row.newer->version(),
                                          row.newer->date.toString(QStringLiteral("yyyy-MM")))
                      : QString();
        const QStringList cells{
            QString::number(row.id),
            orDash(row.model),
            orDash(row.number),
            orDash(row.version),
            orDash(newer),
            row.differs ? tr("Differs from the others of its model") : QString()};
        for (int column = 0; column < columns; ++column) {
            auto* item = new QTableWidgetItem(cells[column]);
            item->setToolTip(cells[column]);
            m_table->setItem(i, column, item);
        }
        using Flag = QItemSelectionModel;
        const auto& selected = m_selection.selected();
        if (row.ref == m_selection.current())
            m_table->setCurrentCell(i, IdColumn, Flag::NoUpdate);
        if (std::find(selected.begin(), selected.end(), row.ref) != selected.end())
            m_table->selectionModel()->select(m_table->model()->index(i, IdColumn),
                                              Flag::Select | Flag::Rows);
        if (row.differs)
            m_table->item(i, NoteColumn)->setForeground(tone(Tone::Warn, palette()));
    }
}

/// The servos of the window are those of the selected rows.
void FirmwarePage::selectServos()
{
    const auto& order = m_workbench.registry().order();
    const auto refAt = [&](int row) {
        return row >= 0 && row < static_cast<int>(order.size())
                   ? order[static_cast<std::size_t>(row)]
                   : session::ServoRef(0);
    };
    std::vector<session::ServoRef> rows;
    for (const QModelIndex& index : m_table->selectionModel()->selectedRows()) {
        if (const session::ServoRef ref = refAt(index.row()); ref != 0)
            rows.push_back(ref);
    }
    if (!rows.empty())
        m_selection.setSelectedRows(std::move(rows), refAt(m_table->currentRow()));
}

/// What it means for the robot's own software: LeRobot compares all servos, whatever their model.
QString FirmwarePage::summary(const std::vector<Row>& rows) const
{
    std::set<QString> versions;
    for (const Row& row : rows) {
        if (!row.version.isEmpty())
            versions.insert(row.version);
    }
    if (versions.size() > 1)
        return tr("The firmware versions differ. LeRobot refuses a bus whose servos do not all "
                  "have the same version.");
    if (versions.size() == 1 && rows.size() > 1 &&
        std::none_of(rows.begin(), rows.end(),
                     [](const Row& row) { return row.version.isEmpty(); }))
        return tr("All %n servo(s) run firmware %1.", nullptr, static_cast<int>(rows.size()))
            .arg(*versions.begin());
    return {};
}

void FirmwarePage::save()
{
    const std::vector<Row> all = rows();
    askForSavePath(
        this,
        {.objectName = QStringLiteral("firmwareSaveDialog"),
         .title = tr("Save the list"),
         .filters = {tr("Table for spreadsheets (*.csv)")},
         .fileName =
             QStringLiteral("firmware-%1.csv")
                 .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmm"))),
         .settings = &m_settings,
         .folderKey = reportFolderKey()},
        [this, all](const QString& path) {
            // With a letter, or a spreadsheet takes 3.10 for 3.1.
            const auto version = [](const QString& text) {
                return text.isEmpty() ? QString() : QLatin1Char('v') + text;
            };
            QByteArray csv = files::csvStart(files::CsvReader::Spreadsheet);
            csv += files::csvLine({tr("ID"), tr("Model"), tr("Model number"), tr("Firmware"),
                                   tr("Newer version known"), tr("Note")});
            for (const Row& row : all)
                csv += files::csvLine(
                    {QString::number(row.id), row.model, row.number, version(row.version),
                     row.newer ? version(row.newer->version()) : QString(),
                     row.differs ? tr("Differs from the others of its model") : QString()});
            QSaveFile file(path);
            if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) ||
                !files::writeAll(file, csv) || !file.commit())
                m_banner->showMessage(files::fileError(firmwareSaveOperation, file));
            else
                m_banner->showMessage([path] {
                    return BannerText{Tone::Good,
                                      tr("Saved: %1").arg(QDir::toNativeSeparators(path))};
                });
        });
}

void FirmwarePage::retranslate()
{
    m_title->setText(tr("Firmware"));
    m_emptyLabel->setText(tr("No servos in the list yet. Search the bus."));
    m_source->setText(tr("Newer versions are listed in the vendor's firmware catalog; they may not "
                         "be the latest."));
    m_table->setHorizontalHeaderLabels({tr("ID"), tr("Model"), tr("Model number"), tr("Firmware"),
                                        tr("Newer version known"), tr("Note")});
    setAccessText(m_table, tr("Firmware versions"), tr("One row per servo of the list"));
    for (const auto& [button, command] : {std::pair{m_rescue, Command::RescueFirmware},
                                          std::pair{m_update, Command::UpdateFirmware}}) {
        const QAction* action = m_commands.action(command);
        setButtonText(button, action->iconText(), action->toolTip());
    }
    setButtonText(m_save, tr("Save list…"), tr("Saves the versions as a table for spreadsheets"));
    update();
}
} // namespace ui
