// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/commissioning/commission_page.h"

#include "text/language.h"
#include "ui/commissioning/commission_batch_view.h"
#include "ui/commissioning/commission_form.h"
#include "ui/commissioning/commission_status.h"
#include "ui/common/file_dialog.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/common/widget_text.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/floating_overlay.h"
#include "ui/widgets/press_guard.h"
#include "ui/widgets/question_dialog.h"

#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace ui {
namespace {
constexpr int setupWidth = 320;
constexpr auto typingDelay = std::chrono::milliseconds(300);
} // namespace

CommissionPage::CommissionPage(AppContext& appContext, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_workbench(appContext.workbench)
    , m_workbenchGuard(&appContext.workbench)
    , m_settings(settings)
    , m_commissioning(appContext.workbench.commissioning())
{
    setObjectName(QStringLiteral("commissionPage"));
    build();
    connectForm();
    connectAll();
    followLanguage(this, [this] {
        retranslate();
        showState();
    });
    m_fileCheckTimer.start();
}

void CommissionPage::build()
{
    auto* column = new QVBoxLayout(this);
    m_banner = new Banner(this);
    m_banner->setObjectName(QStringLiteral("commissionBanner"));
    m_banner->hideMessage();
    auto* row = new QHBoxLayout;
    row->setSpacing(cardMargin);
    row->addWidget(buildSetup());
    row->addWidget(buildWork(), 1);
    column->addLayout(row, 1);
    new FloatingOverlay(m_banner, this, FloatingOverlay::Corner::BottomRight);
}

QWidget* CommissionPage::buildSetup()
{
    auto* left = new QWidget(this);
    left->setFixedWidth(setupWidth);
    auto* column = new QVBoxLayout(left);
    makeCard(left);
    m_form = new CommissionForm(m_settings, left);
    m_reasonLabel = new QLabel(left);
    m_reasonLabel->setObjectName(QStringLiteral("commissionWhy"));
    m_reasonLabel->setWordWrap(true);
    const auto button = [left](const char* name) {
        auto* made = new QPushButton(left);
        made->setObjectName(QString::fromLatin1(name));
        return made;
    };
    m_start = button("commissionStart");
    makeMainAction(m_start);
    new PressGuard(m_start);
    m_stop = button("commissionStop");
    m_plug = button("commissionPlug");
    m_unplug = button("commissionUnplug");
    auto* run = new QHBoxLayout;
    run->addWidget(m_start, 1);
    run->addWidget(m_stop);
    auto* simButtons = new QHBoxLayout;
    simButtons->addWidget(m_plug, 1);
    simButtons->addWidget(m_unplug);
    column->addWidget(m_form);
    // The reason appears and disappears below the buttons, where it does not move them.
    column->addLayout(run);
    column->addLayout(simButtons);
    column->addWidget(m_reasonLabel);
    column->addStretch();
    return left;
}

QWidget* CommissionPage::buildWork()
{
    auto* right = new QWidget(this);
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins({});
    column->setSpacing(cardMargin);
    m_status = new CommissionStatus(m_workbench.commissioning(), m_workbench.search(), right);
    m_batch = new CommissionBatchView(right);
    column->addWidget(m_status);
    column->addWidget(m_batch, 1);
    return right;
}

void CommissionPage::connectForm()
{
    m_fileCheckTimer.setSingleShot(true);
    m_fileCheckTimer.setInterval(typingDelay);
    connect(&m_fileCheckTimer, &QTimer::timeout, this, [this] {
        if (m_form->arePathsValid())
            m_commissioning.checkFiles(m_form->batchPath(), m_form->templatePath());
    });
    connect(m_form, &CommissionForm::filesChanged, this, [this] {
        m_startPending = false;
        m_batchEnded = false;
        m_fileCheckTimer.start();
    });
    connect(m_form, &CommissionForm::changed, this, &CommissionPage::showState);
}

void CommissionPage::connectAll()
{
    using session::Commissioning;
    connect(m_start, &QPushButton::clicked, this, &CommissionPage::checkFilesAndStart);
    connect(m_stop, &QPushButton::clicked, &m_commissioning, &Commissioning::stop);
    connect(m_plug, &QPushButton::clicked, this, [this] {
        m_commissioning.connectNext();
        showState();
    });
    connect(m_unplug, &QPushButton::clicked, &m_commissioning, &Commissioning::unplug);
    connect(&m_commissioning, &Commissioning::filesChecked, this, &CommissionPage::onFilesChecked);
    connect(&m_commissioning, &Commissioning::started, this, &CommissionPage::showState);
    connect(&m_commissioning, &Commissioning::changed, this,
            [this] { m_status->show(m_batchEnded); });
    connect(&m_commissioning, &Commissioning::batchChanged, this, [this] {
        m_batch->show(m_commissioning.batch());
        m_status->show(m_batchEnded);
    });
    connect(&m_commissioning, &Commissioning::finished, this, &CommissionPage::onFinished);
    connect(m_batch, &CommissionBatchView::reportRequested, this,
            &CommissionPage::askForReportPath);
    connect(&m_commissioning, &Commissioning::reportSaved, this, [this](const QString& path) {
        m_banner->showMessage([path] {
            return BannerText{Tone::Good, tr("Saved: %1").arg(QDir::toNativeSeparators(path))};
        });
    });
    connect(&m_commissioning, &Commissioning::saveFailed, this,
            [this](const base::Error& error) { m_banner->showMessage(error); });
    connect(&m_workbench, &session::Workbench::stateChanged, this, &CommissionPage::showState);
}

/// The files are checked once more: the user confirms what is in them now.
void CommissionPage::checkFilesAndStart()
{
    m_startPending = true;
    m_fileCheckTimer.stop();
    m_commissioning.checkFiles(m_form->batchPath(), m_form->templatePath());
}

void CommissionPage::onFilesChecked()
{
    const session::CommissionFileCheck& files = m_commissioning.files();
    if (const auto& error = files.batchError ? files.batchError : files.templateError)
        m_banner->showMessage(*error);
    else
        m_banner->hideMessage();
    m_form->setDangerousKeys(files.dangerous);
    showState();
    if (!std::exchange(m_startPending, false) || !blockedReason().isEmpty())
        return;
    if (m_form->isDangerousIncluded())
        askForConfirmation();
    else
        start();
}

/// Once for the whole batch.
void CommissionPage::askForConfirmation()
{
    Question question;
    question.title = tr("Write dangerous rows to every servo?");
    question.text =
        tr("The template contains: %1").arg(text::joinItems(m_commissioning.files().dangerous));
    question.risk = tr("A wrong value can make a servo unreachable or dangerous, and these rows "
                       "will be written to every servo in the batch.");
    question.acceptText = tr("Write anyway");
    question.guard = this;
    ask(this, question, [this] {
        if (blockedReason().isEmpty())
            start();
    });
}

void CommissionPage::start()
{
    m_banner->hideMessage();
    m_form->save();
    m_commissioning.start(m_form->spec(), m_form->batchPath(), m_form->templatePath());
    showState();
}

void CommissionPage::onFinished(const std::optional<base::Error>& error)
{
    m_batchEnded = true;
    if (error)
        m_banner->showMessage(*error);
    showState();
}

void CommissionPage::askForReportPath()
{
    askForSavePath(
        this,
        {QStringLiteral("commissionReportDialog"),
         tr("Save the report"),
         {tr("Printable page (*.pdf)"), tr("Web page (*.html)")},
         QFileInfo(m_commissioning.csvPath()).completeBaseName() + QStringLiteral(".pdf"),
         &m_settings,
         reportFolderKey()},
        [this](const QString& path) { m_commissioning.saveReport(path, text::isUiChinese()); });
}

QString CommissionPage::blockedReason() const
{
    if (m_workbench.link().state() != session::LinkState::Open)
        return tr("Connect to a port first.");
    if (const QString problem = m_form->pathProblem(); !problem.isEmpty())
        return problem;
    if (m_commissioning.files().batchError)
        return tr("The batch cannot be resumed.");
    if (m_commissioning.files().templateError)
        return tr("The template cannot be read.");
    if (const QString problem = m_form->idProblem(); !problem.isEmpty())
        return problem;
    if (m_workbench.search().isSearching())
        return tr("A search is running; commissioning can start after the search has ended.");
    if (m_workbench.tasks().isTesting() && !m_commissioning.isRunning())
        return tr("A test is running.");
    return {};
}

void CommissionPage::showState()
{
    if (!m_workbenchGuard)
        return;
    const bool running = m_commissioning.isRunning();
    const QString reason = running ? QString() : blockedReason();
    m_reasonLabel->setText(reason);
    m_reasonLabel->setVisible(!reason.isEmpty());
    m_form->setEnabled(!running);
    m_start->setEnabled(!running && reason.isEmpty());
    m_stop->setEnabled(running);
    const bool isSimulated = m_commissioning.hasHotplugQueue();
    m_plug->setVisible(isSimulated);
    m_unplug->setVisible(isSimulated);
    m_plug->setEnabled(isSimulated && m_commissioning.pendingServoCount() > 0);
    m_status->show(m_batchEnded);
    m_batch->setIds(m_form->idProblem().isEmpty() ? m_form->spec().ids : std::vector<int>());
}

void CommissionPage::retranslate()
{
    setAccessibleName(tr("Commissioning"));
    setButtonText(m_start, tr("Start"), tr("Waits for the first servo, or resumes the batch"));
    setButtonText(m_stop, tr("Stop"),
                  tr("Ends commissioning; the batch can be resumed at any time"));
    setButtonText(m_plug, tr("Connect the next servo"), tr("Connects the next simulated servo"));
    setButtonText(m_unplug, tr("Disconnect"), tr("Disconnects the current simulated servo"));
}

void CommissionPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    showState();
}
} // namespace ui
