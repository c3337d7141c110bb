// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/sweep_page.h"

#include "report/sweep_text.h"
#include "results/sweep_verdict.h"
#include "text/language.h"
#include "ui/common/widget_style.h"
#include "ui/sweep/limits_dialog.h"
#include "ui/sweep/runs_dialog.h"
#include "ui/sweep/sweep_form.h"
#include "ui/sweep/sweep_leftovers_banner.h"
#include "ui/sweep/sweep_preview_text.h"
#include "ui/sweep/sweep_previews.h"
#include "ui/sweep/sweep_results.h"
#include "ui/sweep/sweep_servos.h"
#include "ui/widgets/allow_movement_button.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/floating_overlay.h"
#include "ui/widgets/press_guard.h"
#include "ui/widgets/test_text.h"
#include "ui/widgets/thin_progress.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace ui {
namespace {
constexpr int minSetupWidth = 300;
constexpr int maxSetupWidth = 360;
constexpr int setupPercent = 28;
} // namespace

SweepPage::SweepPage(AppContext& appContext, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_workbench(appContext.workbench)
    , m_workbenchGuard(&appContext.workbench)
    , m_selection(appContext.selection)
    , m_test(appContext.workbench.sweepTest())
    , m_historyService(appContext.workbench.history())
    , m_settings(settings)
{
    setObjectName(QStringLiteral("sweepPage"));
    m_previews = new SweepPreviews(m_test, m_workbench.registry(), this);
    build();
    connectAll();
    retranslate();
    onServoSelected();
    showState();
}

SweepPage::~SweepPage() = default;

void SweepPage::build()
{
    auto* column = new QVBoxLayout(this);
    m_banner = new Banner(this);
    m_banner->setObjectName(QStringLiteral("sweepBanner"));
    m_banner->hideMessage();
    auto* row = new QHBoxLayout;
    row->setSpacing(cardMargin);
    auto* card = new QWidget(this);
    auto* left = new QVBoxLayout(card);
    left->setSpacing(6);
    makeCard(card);
    m_scroll = new QScrollArea(card);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* body = new QWidget(m_scroll);
    auto* setup = new QVBoxLayout(body);
    setup->setContentsMargins(0, 0, 4, 0);
    m_form = new SweepForm(m_settings, body);
    m_servos = new SweepServos(m_workbench.registry(), m_selection, m_settings, body);
    setup->addWidget(m_form);
    m_form->insertServoList(m_servos);
    setup->addStretch();
    m_scroll->setWidget(body);
    makeTransparent(m_scroll);
    left->addWidget(m_scroll, 1);
    left->addWidget(buildRun());
    m_results = new SweepResults(m_workbench.session().clock(), m_test, m_settings, this);
    row->addWidget(card);
    row->addWidget(m_results, 1);
    column->addLayout(row, 1);
    m_leftovers = new SweepLeftoversBanner(m_test, m_workbench.registry(), m_workbench.history(),
                                           *m_banner, this);
    new FloatingOverlay(m_banner, m_results->chartCard(), FloatingOverlay::Corner::BottomRight);
}

/// Always in sight, however long the fields above are.
QWidget* SweepPage::buildRun()
{
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins({});
    column->setSpacing(4);
    m_previewLabel = new QLabel(box);
    m_previewLabel->setObjectName(QStringLiteral("sweepOutlook"));
    m_previewLabel->setWordWrap(true);
    m_previewLabel->setTextFormat(Qt::RichText);
    m_switchMode = new QCheckBox(box);
    m_switchMode->setObjectName(QStringLiteral("sweepSwitchMode"));
    m_switchMode->hide();
    m_run = new QPushButton(box);
    m_run->setObjectName(QStringLiteral("sweepRun"));
    makeMainAction(m_run);
    m_allow = new AllowMovementButton(m_workbench.emergencyStop(), m_workbench.registry(),
                                      m_workbench.link(), *m_banner, box);
    m_allow->setObjectName(QStringLiteral("sweepAllow"));
    m_stop = new QPushButton(box);
    m_stop->setObjectName(QStringLiteral("sweepStop"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_run, 1);
    buttons->addWidget(m_allow);
    buttons->addWidget(m_stop);
    m_progress = new ThinProgress(box);
    m_progress->setObjectName(QStringLiteral("sweepProgress"));
    m_progress->setRange(0, 1000);
    m_progressLabel = new QLabel(box);
    m_progressLabel->setObjectName(QStringLiteral("sweepProgressWords"));
    m_progressLabel->setWordWrap(true);
    // The buttons are last: widgets that come and go above them must not move them.
    column->addWidget(m_progress);
    column->addWidget(m_progressLabel);
    column->addWidget(m_previewLabel);
    column->addWidget(m_switchMode);
    column->addLayout(buttons);
    new PressGuard(m_run);
    return box;
}

void SweepPage::connectAll()
{
    connect(m_previews, &SweepPreviews::due, this, &SweepPage::preview);
    connect(m_previews, &SweepPreviews::outdated, this, &SweepPage::schedulePreview);
    // A servo that no longer answers blocks Run before the next reading has ended.
    connect(m_previews, &SweepPreviews::settingsChanged, this, &SweepPage::showState);
    connect(m_previews, &SweepPreviews::received, this, &SweepPage::onPreviewsReceived);
    connect(m_form, &SweepForm::changed, this, &SweepPage::schedulePreview);
    connect(m_servos, &SweepServos::changed, this, &SweepPage::onServoSelected);
    connect(m_servos, &SweepServos::limitsRequested, this, &SweepPage::editLimits);
    connect(m_servos, &SweepServos::clicked, this, [this](session::ServoRef ref) {
        const auto& tested = m_test.servos();
        const auto place = std::find(tested.begin(), tested.end(), ref);
        if (place != tested.end())
            m_results->chooseServo(int(place - tested.begin()));
    });
    connect(m_switchMode, &QCheckBox::toggled, this, &SweepPage::showState);
    connect(m_previewLabel, &QLabel::linkActivated, this, [this] {
        for (const session::SweepPreview& one : m_previews->all()) {
            if (one.estimate)
                m_form->setPace(one.estimate->proposedDelay);
        }
        schedulePreview();
    });
    connect(m_run, &QPushButton::clicked, this, &SweepPage::run);
    connect(m_allow, &AllowMovementButton::allowed, this, [this] { m_consent.reset(); });
    connect(m_stop, &QPushButton::clicked, &m_test, &session::SweepTest::stop);
    connect(m_results, &SweepResults::previousTestsRequested, this,
            &SweepPage::previousTestsRequested);
    connect(m_results, &SweepResults::servoShown, this, [this] {
        showReference();
        if (m_results->shownServo() < m_test.servos().size())
            m_servos->markRow(m_test.servos()[m_results->shownServo()]);
    });
    connect(&m_test, &session::SweepTest::started, this, [this] {
        showVerdicts();
        showState();
    });
    connect(&m_test, &session::SweepTest::progressChanged, this, &SweepPage::showProgress);
    connect(&m_test, &session::SweepTest::finished, this, &SweepPage::onTestFinished);
    connect(&m_test, &session::SweepTest::failed, this, &SweepPage::onTestFailed);
    connect(&m_workbench, &session::Workbench::stateChanged, this, &SweepPage::showState);
    connect(&m_workbench.link(), &session::LinkController::linkChanged, this,
            &SweepPage::schedulePreview);
    connect(&m_workbench.search(), &session::SearchService::searchChanged, this,
            &SweepPage::schedulePreview);
}

session::SweepTestRequest SweepPage::testRequest() const
{
    session::SweepTestRequest testRequest;
    testRequest.spec = m_form->spec();
    testRequest.servos = m_servos->selected();
    testRequest.spec.ranges = m_servos->ranges();
    for (auto& [id, range] : testRequest.spec.ranges) {
        range.from = range.from.isEmpty() ? testRequest.spec.range.from : range.from;
        range.to = range.to.isEmpty() ? testRequest.spec.range.to : range.to;
    }
    for (const session::ServoRef ref : testRequest.servos)
        testRequest.limits.push_back(m_servos->limits(ref));
    testRequest.switchMode = m_switchMode->isVisibleTo(this) && m_switchMode->isChecked();
    return testRequest;
}

void SweepPage::onServoSelected()
{
    const auto selected = m_servos->selected();
    m_previews->follow(selected);
    const session::ServoRef first = selected.empty() ? 0 : selected.front();
    if (first != 0 && first != m_shown) {
        if (m_shown != 0)
            m_typed[m_shown] = m_form->userInput();
        m_shown = first;
        m_form->setUserInput(m_typed[first]);
        m_form->showServo(m_workbench.registry().servo(first));
    }
    schedulePreview();
}

void SweepPage::schedulePreview()
{
    if (m_test.isRunning() || !isVisible())
        return;
    m_previews->schedule();
}

void SweepPage::preview()
{
    if (!m_workbenchGuard || !isVisible())
        return;
    if (blockedReason().isEmpty()) {
        m_previews->request(testRequest());
        return;
    }
    m_previews->clear(m_servos->selected());
    showState();
}

/// The first selected servo that does not answer now, even if it was read before.
std::optional<session::SweepPreview> SweepPage::silentServo() const
{
    for (const session::ServoRef ref : m_servos->selected()) {
        const session::ServoEntry* entry = m_workbench.registry().servo(ref);
        if (entry != nullptr && entry->silent)
            return session::SweepPreview{
                ref,
                {},
                base::Error{base::ErrorCode::NoReply, QStringLiteral("sweep"), {}, entry->servo.id},
                {}};
    }
    return std::nullopt;
}

/// The proposals change the test, which then needs another preview.
void SweepPage::onPreviewsReceived()
{
    const auto& previews = m_previews->all();
    if (!previews.empty()) {
        const results::SweepSpec before = m_form->spec();
        const session::SweepPreview& first = previews.front();
        m_form->showServo(m_workbench.registry().servo(first.servo));
        if (first.proposed)
            m_form->propose(*first.proposed);
        base::Duration enough{};
        for (const session::SweepPreview& one : previews)
            enough =
                std::max(enough, one.estimate ? one.estimate->proposedDelay : base::Duration{});
        m_form->propose(enough);
        if (!(m_form->spec() == before))
            schedulePreview();
    }
    showState();
}

QString SweepPage::blockedReason() const
{
    if (m_workbench.link().state() != session::LinkState::Open)
        return tr("Connect first: no port is open.");
    if (m_workbench.search().isSearching())
        return tr("A search is running; the test can start when the search has ended.");
    if (m_servos->selected().empty())
        return tr("Select a servo in the list, or select one below.");
    const QString held = blockedByStopText(m_workbench.registry(), m_servos->selected());
    if (!held.isEmpty())
        return tr("Movement is blocked by the emergency stop, and torque is off: %1. Click Allow "
                  "movement to turn torque on; nothing moves until you click Run.")
            .arg(held);
    return m_form->inputError();
}

void SweepPage::showState()
{
    if (!m_workbenchGuard)
        return;
    const bool running = m_test.isRunning();
    const auto& previews = m_previews->all();
    const bool mode = std::any_of(previews.begin(), previews.end(), &SweepPreviews::isWrongMode);
    m_switchMode->setVisible(mode && !running);
    const bool refused = std::any_of(previews.begin(), previews.end(), [&](const auto& one) {
        return one.error && !(SweepPreviews::isWrongMode(one) && m_switchMode->isChecked());
    });
    m_form->setLocked(running);
    m_servos->setLocked(running);
    m_run->setEnabled(!running && blockedReason().isEmpty() && !refused && !previews.empty() &&
                      !silentServo());
    m_stop->setEnabled(running);
    m_allow->showFor(m_servos->selected());
    m_progress->setVisible(running);
    m_progressLabel->setVisible(running);
    m_previewLabel->setVisible(!running);
    showPreview();
    showProgress();
}

void SweepPage::showPreview()
{
    PreviewText words{Tone::Quiet, blockedReason()};
    if (words.text.isEmpty())
        words = previewText(m_previews->all(), m_form->spec(), m_workbench.registry(),
                            m_switchMode->isChecked());
    if (const auto silent = silentServo();
        silent && words.tone != Tone::Bad && blockedReason().isEmpty())
        words = previewText({*silent}, m_form->spec(), m_workbench.registry(), false);
    m_previewLabel->setText(words.text);
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, tone(words.tone, palette()));
    m_previewLabel->setPalette(colors);
}

void SweepPage::showProgress()
{
    if (!m_test.isRunning())
        return;
    const jobs::SweepProgress& now = m_test.progress();
    m_progress->setValue(int(now.fraction * 1000));
    m_progressLabel->setText(progressText(now, m_test.run()));
}

void SweepPage::run()
{
    const session::SweepTestRequest request = testRequest();
    const SweepConsent consent = consentFor(request);
    if (m_consent == consent)
        start();
    else
        askBeforeSweep(this, m_workbench.registry(), request, m_previews->all(), [this, consent] {
            m_consent = consent;
            start();
        });
}

void SweepPage::start()
{
    m_leftovers->hide();
    m_references.clear();
    m_form->saveSettings();
    m_previews->cancel();
    if (m_test.start(testRequest()))
        m_progressLabel->setText(tr("Moving to the start"));
    else
        m_banner->showMessage([] { return notStartedText(); });
    showState();
}

void SweepPage::onTestFinished()
{
    compareWithReference();
    m_leftovers->show();
    showVerdicts();
    showState();
    schedulePreview(); // the settings of the servo may have changed
}

/// Of the latest test, in the table of servos.
void SweepPage::showVerdicts()
{
    std::map<session::ServoRef, SweepServos::Verdict> verdicts;
    const results::SweepRun* run = m_test.run();
    for (std::size_t i = 0; run != nullptr && !m_test.isRunning() && i < run->servos.size(); ++i) {
        const results::SweepVerdict found = results::sweepVerdict(*run, run->servos[i]);
        const bool bare = found.reason == results::NoVerdictReason::None;
        verdicts[m_test.servos().at(i)] = {
            found.grade, bare ? gradeText(found.grade)
                              : text::localized(report::noVerdictReasonText(found.reason))};
    }
    m_servos->setVerdicts(verdicts);
}

/// Compares the run with the reference of its model.
void SweepPage::compareWithReference()
{
    const auto run = std::make_shared<const results::SweepRun>(*m_test.run());
    m_historyService.compareWithReference(
        run, this, [this](const base::Result<std::vector<session::ReferenceResult>>& found) {
            m_references = found.value_or(std::vector<session::ReferenceResult>{});
            showReference();
        });
}

void SweepPage::showReference()
{
    const results::SweepRun* run = m_test.run();
    const std::size_t shown = m_results->shownServo();
    if (run == nullptr || m_test.isRunning() || shown >= run->servos.size())
        return;
    const int id = run->servos[shown].parameters.servo.id;
    const auto found = std::find_if(m_references.begin(), m_references.end(),
                                    [id](const auto& one) { return one.servo == id; });
    m_results->setComparison(found != m_references.end() ? referenceText(*found) : QString());
}

void SweepPage::onTestFailed(const base::Error& error)
{
    m_leftovers->show(error);
    showState();
    schedulePreview();
}

void SweepPage::editLimits(session::ServoRef ref)
{
    const session::ServoEntry* entry = m_workbench.registry().servo(ref);
    if (entry == nullptr || !entry->servo.profile)
        return;
    const auto& profile = *entry->servo.profile;
    auto* dialog = new LimitsDialog(m_settings, m_servos->limits(ref), profile.modelName,
                                    profile.series, this);
    connect(dialog, &LimitsDialog::limitsAccepted, this,
            [this, model = profile.modelName,
             series = profile.series](const results::SweepLimits& limits) {
                m_servos->setLimits(model, series, limits);
            });
    dialog->open();
}
void SweepPage::retranslate()
{
    setAccessibleName(tr("Sweep test"));
    m_run->setText(tr("Run"));
    m_run->setToolTip(tr("Starts the test: the servos will move"));
    m_stop->setText(tr("Stop"));
    m_stop->setToolTip(tr("Ends the test; the servos hold their position, or torque is turned off, "
                          "as selected under \"After the test\""));
    m_switchMode->setText(tr("Switch to position mode for the test"));
    m_switchMode->setToolTip(tr("Switches back after the test; nothing is stored permanently in "
                                "the servo"));
    m_progress->setAccessibleName(tr("Progress of the test"));
    for (QAbstractButton* button :
         std::initializer_list<QAbstractButton*>{m_run, m_stop, m_switchMode})
        button->setAccessibleName(button->text());
}

void SweepPage::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showVerdicts();
        showReference();
    }
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        showState();
}

void SweepPage::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const int wide = std::clamp(width() * setupPercent / 100, minSetupWidth, maxSetupWidth);
    m_scroll->setFixedWidth(wide);
    m_previewLabel->setMaximumWidth(wide);
}

void SweepPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    onServoSelected();
    showState();
}
} // namespace ui
