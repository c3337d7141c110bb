// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/search/diagnosis_dialog.h"

#include "text/diagnosis_text.h"
#include "text/error_text.h"
#include "text/language.h"
#include "text/progress_text.h"
#include "ui/common/dialog_sizes.h"
#include "ui/common/theme.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/search/remedy_drawing.h"
#include "ui/widgets/rate_text.h"
#include "ui/widgets/thin_progress.h"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
namespace {
using base::Cause;
using base::Evidence;
using base::EvidenceKind;

constexpr int diagnosisWidth = 820;
constexpr int diagnosisHeight = 470;
constexpr int permille = 1000;
constexpr double causeSize = 1.25; ///< of the text below it

/// Something that is not as it should be.
bool isTrouble(const Evidence& evidence)
{
    switch (evidence.kind) {
    case EvidenceKind::PortOpened:
    case EvidenceKind::Echo:
    case EvidenceKind::NoEcho:
    case EvidenceKind::BytesReceived:
    case EvidenceKind::RatesRefused:
    case EvidenceKind::RateFixed:
    case EvidenceKind::ServosFound:
    case EvidenceKind::AllReplied:
    case EvidenceKind::ReplyTime:
    case EvidenceKind::LatencyTimer:
        return false;
    default:
        return true;
    }
}

QLabel* wrappedLabel(QWidget* parent, const char* name)
{
    auto* label = new QLabel(parent);
    label->setObjectName(QLatin1String(name));
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    return label;
}

/// The rate at which servos were found, other than the one the port was opened at.
std::optional<int> rateToConnectAt(const base::Diagnosis& diagnosis)
{
    const int portRate = diagnosis.evidence.empty() ? 0 : diagnosis.evidence.front().baud;
    const auto found = std::find_if(
        diagnosis.evidence.begin(), diagnosis.evidence.end(), [&](const Evidence& evidence) {
            return evidence.kind == EvidenceKind::ServosFound && evidence.baud != portRate;
        });
    return found == diagnosis.evidence.end() ? std::nullopt : std::optional(found->baud);
}
} // namespace

DiagnosisDialog::DiagnosisDialog(session::SearchService& search, session::LinkController& link,
                                 Commands& commands, QWidget* parent)
    : QDialog(parent)
    , m_search(search)
    , m_link(link)
    , m_commands(commands)
    , m_evidenceTitle(new QLabel(this))
    , m_evidence(new QTextBrowser(this))
    , m_progress(new ThinProgress(this))
    , m_state(wrappedLabel(this, "diagnosisState"))
    , m_causeTitle(new QLabel(this))
    , m_cause(wrappedLabel(this, "diagnosisCause"))
    , m_remedy(wrappedLabel(this, "diagnosisRemedy"))
    , m_drawing(new RemedyDrawing(this))
    , m_also(wrappedLabel(this, "diagnosisAlso"))
    , m_action(new QPushButton(this))
    , m_again(new QPushButton(this))
    , m_copy(new QPushButton(this))
    , m_close(new QPushButton(this))
{
    setObjectName(QStringLiteral("diagnosisDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    rememberSize(*this);
    build();
    connect(&search, &session::SearchService::evidenceFound, this, &DiagnosisDialog::update);
    connect(&search, &session::SearchService::searchChanged, this, &DiagnosisDialog::update);
    connect(&search, &session::SearchService::searchProgress, this, &DiagnosisDialog::showProgress);
    connect(&m_link, &session::LinkController::linkChanged, this, &DiagnosisDialog::update);
    start();
    retranslate();
}

void DiagnosisDialog::build()
{
    auto* cards = new QHBoxLayout;
    cards->setSpacing(cardMargin);
    cards->addWidget(buildEvidence(), 1);
    cards->addWidget(buildCause(), 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_copy);
    buttons->addWidget(m_again);
    buttons->addStretch(1);
    buttons->addWidget(m_close);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(dialogMargin, dialogMargin, dialogMargin, dialogMargin);
    column->addLayout(cards, 1);
    column->addLayout(buttons);
    m_again->setObjectName(QStringLiteral("diagnosisAgain"));
    m_copy->setObjectName(QStringLiteral("diagnosisCopy"));
    m_close->setObjectName(QStringLiteral("diagnosisClose"));
    for (QPushButton* button : {m_action, m_again, m_copy, m_close})
        button->setAutoDefault(false);
    connect(m_action, &QPushButton::clicked, this, &DiagnosisDialog::act);
    connect(m_again, &QPushButton::clicked, this, [this] {
        if (m_search.isDiagnosing())
            m_search.stop();
        else
            start();
    });
    connect(m_copy, &QPushButton::clicked, this,
            [this] { QApplication::clipboard()->setText(report()); });
    connect(m_close, &QPushButton::clicked, this, &QDialog::reject);
    connect(this, &QDialog::finished, this, [this] {
        if (m_search.isDiagnosing())
            m_search.stop();
    });
    resize(diagnosisWidth, diagnosisHeight);
}

QWidget* DiagnosisDialog::buildEvidence()
{
    auto* card = new QWidget(this);
    m_evidence->setObjectName(QStringLiteral("diagnosisEvidence"));
    m_evidence->setFrameShape(QFrame::NoFrame);
    m_evidence->document()->setDocumentMargin(0);
    m_progress->setObjectName(QStringLiteral("diagnosisProgress"));
    m_progress->setRange(0, permille);
    m_state->setForegroundRole(QPalette::PlaceholderText);
    makeHeading(m_evidenceTitle);
    auto* column = new QVBoxLayout(card);
    column->addWidget(m_evidenceTitle);
    column->addWidget(m_evidence, 1);
    column->addWidget(m_progress);
    column->addWidget(m_state);
    makeCard(card);
    return card;
}

QWidget* DiagnosisDialog::buildCause()
{
    auto* card = new QWidget(this);
    m_causeTitle->setForegroundRole(QPalette::PlaceholderText);
    QFont large = font();
    large.setBold(true);
    large.setPointSizeF(large.pointSizeF() * causeSize);
    m_cause->setFont(large);
    m_action->setObjectName(QStringLiteral("diagnosisAction"));
    makeMainAction(m_action);
    m_also->setForegroundRole(QPalette::PlaceholderText);
    auto* column = new QVBoxLayout(card);
    column->setSpacing(10);
    column->addWidget(m_causeTitle);
    column->addWidget(m_cause);
    column->addWidget(m_remedy);
    column->addWidget(m_action, 0, Qt::AlignLeft);
    column->addWidget(m_drawing);
    column->addWidget(m_also);
    column->addStretch(1);
    makeCard(card);
    return card;
}

void DiagnosisDialog::start()
{
    m_port = m_link.lastRequest().name;
    m_search.diagnose();
    update();
}

void DiagnosisDialog::showProgress(const jobs::Progress& progress)
{
    if (!m_search.isDiagnosing())
        return;
    m_progress->setValue(int(progress.fraction * permille));
    m_state->setText(
        text::joinSentences({tr("Searching at %1 baud…").arg(rateText(progress.baud)),
                             text::progressText(progress.fraction, progress.remaining)}));
}

void DiagnosisDialog::update()
{
    showEvidence();
    showState();
    showAction();
}

void DiagnosisDialog::showEvidence()
{
    QString html;
    for (const Evidence& one : m_search.diagnosis().evidence) {
        const bool trouble = isTrouble(one);
        const QColor color =
            trouble ? tone(Tone::Warn, palette()) : palette().color(QPalette::Text);
        html += QStringLiteral("<p style=\"margin:0 0 7px 18px; text-indent:-18px; color:%1\">"
                               "%2&nbsp;&nbsp;%3</p>")
                    .arg(color.name(), trouble ? QStringLiteral("!") : QStringLiteral("✓"),
                         text::evidenceText(one).toHtmlEscaped());
    }
    m_evidence->setHtml(html);
    m_evidence->verticalScrollBar()->setValue(m_evidence->verticalScrollBar()->maximum());
}

void DiagnosisDialog::showState()
{
    const base::Diagnosis& diagnosis = m_search.diagnosis();
    const bool isRunning = m_search.isDiagnosing();
    const bool isOpen = m_link.state() == session::LinkState::Open;
    m_progress->setVisible(isRunning);
    m_again->setEnabled(isRunning || isOpen);
    setButtonText(m_again, isRunning ? tr("Stop") : tr("Run again"),
                  isRunning ? tr("Ends the diagnosis")
                            : tr("Runs all checks again; writes nothing"));
    m_copy->setEnabled(!diagnosis.evidence.empty());
    m_remedy->clear();
    m_also->clear();
    m_drawing->clear();
    const bool isFine = !isRunning && !diagnosis.stopped && diagnosis.cause == Cause::Found;
    m_causeTitle->setText(isFine ? tr("Result") : tr("Cause"));
    if (isRunning) {
        m_cause->setText(tr("Looking for the cause…"));
        return;
    }
    m_state->clear();
    if (const auto& error = m_search.diagnosisError()) {
        const text::Description words = text::describe(*error);
        m_cause->setText(words.message);
        m_remedy->setText(words.remedy);
    } else if (diagnosis.stopped || diagnosis.evidence.empty()) {
        m_cause->setText(tr("The diagnosis was stopped."));
    } else {
        m_cause->setText(text::causeText(diagnosis.cause));
        m_remedy->setText(text::causeRemedy(diagnosis.cause));
        m_drawing->setCause(diagnosis.cause);
        QStringList others;
        for (const Cause cause : diagnosis.also)
            others << tr("Also possible: %1").arg(text::causeText(cause));
        m_also->setText(others.join(QLatin1Char('\n')));
    }
}

/// The button does what the remedy says, where this program can do it.
void DiagnosisDialog::showAction()
{
    const Cause cause = m_search.diagnosis().cause;
    const bool isDone = !m_search.isDiagnosing() && !m_search.diagnosisError() &&
                        !m_search.diagnosis().stopped && m_link.state() == session::LinkState::Open;
    const auto rate = rateToConnectAt(m_search.diagnosis());
    QString words;
    QString tip;
    if (cause == Cause::TwoServosOneId) {
        words = tr("Set up servos one at a time");
        tip = tr("Shows the Commissioning page");
    } else if (cause == Cause::WrongBaudRate && rate) {
        words = tr("Connect at %1 baud").arg(rateText(*rate));
        tip = tr("Opens the port again at this baud rate");
    } else if (cause == Cause::OtherProtocol) {
        words = tr("Connect and detect the protocol");
        tip = tr("Opens the port again and detects the protocol");
    }
    if (cause == Cause::Bootloader) {
        words = tr("Rescue firmware…");
        tip = tr("Writes the vendor's firmware file to this servo");
    }
    if (!words.isEmpty())
        setButtonText(m_action, words, tip);
    m_action->setVisible(isDone && !words.isEmpty());
}

void DiagnosisDialog::act()
{
    const base::Diagnosis& diagnosis = m_search.diagnosis();
    session::PortRequest request = m_link.lastRequest();
    switch (diagnosis.cause) {
    case Cause::TwoServosOneId:
        m_commands.action(Command::PageCommission)->trigger();
        break;
    case Cause::Bootloader:
        m_commands.action(Command::RescueFirmware)->trigger();
        break;
    case Cause::WrongBaudRate:
        request.baud = rateToConnectAt(diagnosis);
        request.protocol.reset();
        m_link.connectTo(request);
        break;
    case Cause::OtherProtocol:
        request.protocol.reset();
        m_link.connectTo(request);
        break;
    default:
        return;
    }
    close();
}

QString DiagnosisDialog::report() const
{
    const base::Diagnosis& diagnosis = m_search.diagnosis();
    QStringList lines{windowTitle(), m_port, QString()};
    for (const Evidence& one : diagnosis.evidence)
        lines << QStringLiteral("- ") + text::evidenceText(one);
    lines << QString() << m_cause->text();
    for (const QLabel* label : {m_also, m_remedy}) {
        if (!label->text().isEmpty())
            lines << label->text();
    }
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void DiagnosisDialog::retranslate()
{
    setWindowTitle(tr("Why is a servo not replying?"));
    setAccessibleName(windowTitle());
    m_evidenceTitle->setText(tr("Checks"));
    setAccessText(m_evidence, tr("Checks"), tr("What was found; nothing is written to a servo"));
    setAccessText(m_progress, tr("Progress"), tr("Progress of the diagnosis"));
    setButtonText(m_copy, tr("Copy report"), tr("Copies the checks and the cause as text"));
    setButtonText(m_close, tr("Close"), tr("Closes this window"));
    update();
}

void DiagnosisDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange)
        showEvidence();
}
} // namespace ui
