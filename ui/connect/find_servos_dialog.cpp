// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/connect/find_servos_dialog.h"

#include "text/bus_text.h"
#include "text/error_text.h"
#include "text/language.h"
#include "text/progress_text.h"
#include "ui/common/dialog_sizes.h"
#include "ui/common/theme.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/rate_text.h"
#include "ui/widgets/thin_progress.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
namespace {
using session::PortResult;
using State = PortResult::State;

constexpr int findWidth = 620;
constexpr int findHeight = 380;
constexpr int findSteps = 1000; ///< of the progress bar

enum Column { PortColumn, ResultColumn, findColumns };

QString foundText(const std::vector<jobs::FoundServo>& found)
{
    QStringList groups;
    for (const auto& [protocol, ids] : session::idsByProtocol(found))
        groups << FindServosDialog::tr("ID %1 (%2)")
                      .arg(text::idRangesText(ids), text::protocolText(protocol));
    QString text =
        FindServosDialog::tr("%n servo(s) · %1 · %2 baud", nullptr, static_cast<int>(found.size()))
            .arg(text::joinItems(groups), rateText(found.front().servo.baud));
    if (std::any_of(found.begin(), found.end(),
                    [](const jobs::FoundServo& one) { return one.duplicateSuspected; }))
        text += QLatin1Char('\n') + FindServosDialog::tr("Possibly several servos with one ID.");
    return text;
}

QString resultText(const PortResult& result)
{
    if (result.error)
        return text::describe(*result.error).message;
    if (!result.found.empty()) {
        const QString text = foundText(result.found);
        return result.state == State::Stopped
                   ? text + QLatin1Char('\n') + FindServosDialog::tr("Search not finished")
                   : text;
    }
    switch (result.state) {
    case State::Waiting:
        return FindServosDialog::tr("Waiting");
    case State::Searching:
        return FindServosDialog::tr("Searching…");
    case State::Stopped:
        return FindServosDialog::tr("Search not finished");
    case State::Searched:
        break;
    }
    return FindServosDialog::tr("No servo replied.");
}

QString resultTip(const PortResult& result)
{
    if (!result.error)
        return resultText(result);
    const text::Description words = text::describe(*result.error);
    return text::joinSentences({words.message, words.cause, words.remedy});
}

Tone resultTone(const PortResult& result)
{
    if (result.error)
        return Tone::Warn;
    return result.found.empty() ? Tone::Quiet : Tone::Good;
}
} // namespace

FindServosDialog::FindServosDialog(session::Session& session, const session::PortWatcher& ports,
                                   QWidget* parent)
    : QDialog(parent)
    , m_session(session)
    , m_ports(ports)
    , m_finder(session)
    , m_intro(new QLabel(this))
    , m_table(new QTableWidget(0, findColumns, this))
    , m_emptyLabel(new QLabel(this))
    , m_progress(new ThinProgress(this))
    , m_state(new QLabel(this))
    , m_again(new QPushButton(this))
    , m_connect(new QPushButton(this))
    , m_close(new QPushButton(this))
{
    setObjectName(QStringLiteral("findServosDialog"));
    setWindowModality(Qt::WindowModal); // the ports are in use
    rememberSize(*this);
    build();
    connect(&m_finder, &session::PortFinder::changed, this, [this] {
        m_progress->setValue(0); // another port
        m_state->clear();
        update();
        if (m_isShown)
            deleteWhenEnded();
    });
    connect(&m_finder, &session::PortFinder::progressed, this, &FindServosDialog::showProgress);
    retranslate();
    start();
}

void FindServosDialog::build()
{
    m_intro->setObjectName(QStringLiteral("findIntro"));
    m_intro->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("findResults"));
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setFrameShape(QFrame::NoFrame);
    styleTable(m_table);
    m_table->setWordWrap(true);
    m_table->horizontalHeader()->setSectionResizeMode(PortColumn, QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_emptyLabel->setObjectName(QStringLiteral("findEmpty"));
    makeEmptyState(m_emptyLabel);
    m_progress->setObjectName(QStringLiteral("findProgress"));
    m_progress->setRange(0, findSteps);
    m_state->setObjectName(QStringLiteral("findState"));
    m_state->setForegroundRole(QPalette::PlaceholderText);
    m_again->setObjectName(QStringLiteral("findAgain"));
    m_connect->setObjectName(QStringLiteral("findConnect"));
    m_close->setObjectName(QStringLiteral("findClose"));
    makeMainAction(m_connect);
    for (QPushButton* button : {m_again, m_close})
        button->setAutoDefault(false);
    auto* card = new QWidget(this);
    auto* inCard = new QVBoxLayout(card);
    inCard->addWidget(m_table);
    inCard->addWidget(m_emptyLabel);
    makeTableCard(card);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_again);
    buttons->addStretch(1);
    buttons->addWidget(m_connect);
    buttons->addWidget(m_close);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(dialogMargin, dialogMargin, dialogMargin, dialogMargin);
    column->addWidget(m_intro);
    column->addWidget(card, 1);
    column->addWidget(m_progress);
    column->addWidget(m_state);
    column->addLayout(buttons);
    resize(findWidth, findHeight);
    connect(m_table, &QTableWidget::itemSelectionChanged, this,
            [this] { m_connect->setEnabled(selected() != nullptr); });
    connect(m_table, &QTableWidget::cellDoubleClicked, this, &FindServosDialog::connectToSelected);
    connect(m_connect, &QPushButton::clicked, this, &FindServosDialog::connectToSelected);
    connect(m_again, &QPushButton::clicked, this, [this] {
        if (m_finder.isRunning())
            m_finder.stop();
        else
            start();
    });
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(this, &QDialog::finished, this, [this] {
        m_finder.stop();
        deleteWhenEnded();
    });
}

/// Closing the port that is being searched may take as long as its adapter likes.
void FindServosDialog::deleteWhenEnded()
{
    if (!isVisible() && !m_finder.isRunning())
        deleteLater();
}

void FindServosDialog::start()
{
    QStringList ports;
    for (const session::PortInfo& port : m_ports.ports())
        ports << port.path;
    m_table->setRowCount(0);
    m_finder.start(ports);
}

void FindServosDialog::update()
{
    const bool isRunning = m_finder.isRunning();
    const bool isEmpty = m_finder.results().empty();
    m_table->setVisible(!isEmpty);
    m_emptyLabel->setVisible(isEmpty);
    m_progress->setVisible(isRunning);
    m_state->setVisible(isRunning);
    setButtonText(m_again, isRunning ? tr("Stop") : tr("Search again"),
                  isRunning ? tr("Ends the search; what was found stays in the list")
                            : tr("Searches all ports again; writes nothing"));
    showResults();
}

/// The first port with servos is selected by itself.
void FindServosDialog::showResults()
{
    const auto& results = m_finder.results();
    m_table->setRowCount(static_cast<int>(results.size()));
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const PortResult& result = results[static_cast<std::size_t>(row)];
        for (const auto& [column, text] :
             {std::pair{PortColumn, result.port}, std::pair{ResultColumn, resultText(result)}}) {
            QTableWidgetItem* item = m_table->item(row, column);
            if (item == nullptr) {
                item = new QTableWidgetItem;
                m_table->setItem(row, column, item);
            }
            item->setText(text);
            item->setToolTip(column == ResultColumn ? resultTip(result) : text);
        }
        m_table->item(row, ResultColumn)->setForeground(tone(resultTone(result), palette()));
        if (!result.found.empty() && m_table->selectedItems().isEmpty())
            m_table->setCurrentCell(row, ResultColumn);
    }
    m_table->resizeRowsToContents();
    m_connect->setEnabled(selected() != nullptr);
}

void FindServosDialog::showProgress(const jobs::Progress& progress)
{
    if (!m_finder.isRunning())
        return;
    m_progress->setValue(int(progress.fraction * findSteps));
    m_state->setText(
        text::joinSentences({tr("Searching at %1 baud…").arg(rateText(progress.baud)),
                             text::progressText(progress.fraction, progress.remaining)}));
}

const session::PortResult* FindServosDialog::selected() const
{
    const int row = m_table->selectedItems().isEmpty() ? -1 : m_table->currentRow();
    const auto& results = m_finder.results();
    if (row < 0 || row >= static_cast<int>(results.size()))
        return nullptr;
    const PortResult& result = results[static_cast<std::size_t>(row)];
    return result.found.empty() ? nullptr : &result;
}

void FindServosDialog::connectToSelected()
{
    const PortResult* result = selected();
    if (result == nullptr)
        return;
    session::PortRequest request;
    request.name = result->port;
    const device::Servo& servo = result->found.front().servo;
    request.baud = servo.baud;
    const auto expected = m_session.catalog().protocolsAt(servo.baud);
    if (std::find(expected.begin(), expected.end(), servo.protocol) == expected.end())
        request.protocol = servo.protocol; // a search after connecting would leave it out
    m_finder.stop();
    Q_EMIT connectRequested(request);
    close();
}

void FindServosDialog::retranslate()
{
    setWindowTitle(tr("Find servos on all ports"));
    setAccessibleName(windowTitle());
    m_intro->setText(tr("Searches each serial port at every baud rate until a servo replies. "
                        "Nothing is written. Devices that are not servo adapters receive the "
                        "queries too: unplug them first."));
    m_emptyLabel->setText(tr("This computer has no serial port. Plug in the adapter, then search "
                             "again."));
    m_table->setHorizontalHeaderLabels({tr("Port"), tr("Result")});
    setAccessText(m_table, tr("Ports"), tr("What replied on each port"));
    setAccessText(m_progress, tr("Progress"), tr("Progress of the search on this port"));
    setButtonText(m_connect, tr("Connect"),
                  tr("Opens the selected port at the rate of its servos"));
    setButtonText(m_close, tr("Close"), tr("Closes this window and ends the search"));
    update();
}

void FindServosDialog::showEvent(QShowEvent* event)
{
    QDialog::showEvent(event);
    m_isShown = true;
}

void FindServosDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange)
        showResults();
}
} // namespace ui
