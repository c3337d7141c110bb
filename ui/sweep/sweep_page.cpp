// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/sweep_page.h"

#include "device/motion/move_limits.h"
#include "text/error_text.h"
#include "ui/sweep/sweep_form.h"
#include "ui/sweep/sweep_preview_text.h"
#include "ui/sweep/sweep_results.h"
#include "ui/sweep/sweep_servos.h"
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
using namespace std::chrono_literals;

namespace {
constexpr auto previewDelay = 250ms; ///< after the last letter
constexpr auto retryAfter = 1s;      ///< of a servo that is heard again
constexpr auto retryPeriod = 3s;     ///< of one that nothing else reads
constexpr int minSetupWidth = 300;
constexpr int maxSetupWidth = 360;
constexpr int setupPercent = 28;

QString settingsOf(const session::ServoEntry* entry)
{
    if (entry == nullptr || !entry->servo.profile)
        return {};
    const catalog::Mode* mode = entry->servo.mode();
    const auto span = device::goalSliderRange(entry->servo);
    return QStringLiteral("%1 %2 %3 %4")
        .arg(mode != nullptr ? mode->key : QString())
        .arg(span ? span->min : 0)
        .arg(span ? span->max : 0)
        .arg(int(entry->stopped) + 2 * int(entry->silent));
}

bool isNoAnswer(const session::SweepPreview& preview)
{
    using base::ErrorCode;
    return preview.error && (preview.error->code == ErrorCode::NoReply ||
                             preview.error->code == ErrorCode::Garbled ||
                             preview.error->code == ErrorCode::UnexpectedReply ||
                             preview.error->code == ErrorCode::LineBusy);
}

bool isWrongMode(const session::SweepPreview& preview)
{
    return preview.error && preview.error->code == base::ErrorCode::NotSupported &&
           preview.error->detail == QLatin1StringView("not-position");
}
} // namespace

SweepPage::SweepPage(AppContext& appContext, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_desk(appContext.desk)
    , m_deskGuard(&appContext.desk)
    , m_selection(appContext.selection)
    , m_test(appContext.sweepTest)
    , m_historyService(appContext.history)
{
    setObjectName(QStringLiteral("sweepPage"));
    build(settings);
    connectAll();
    retranslate();
    onServoSelected();
    showState();
}

SweepPage::~SweepPage() = default;

void SweepPage::build(session::Settings& settings)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 6, 0, 0);
    m_banner = new Banner(this);
    m_banner->setObjectName(QStringLiteral("sweepBanner"));
    m_banner->hideMessage();
    auto* row = new QHBoxLayout;
    row->setSpacing(10);
    auto* left = new QVBoxLayout;
    left->setSpacing(6);
    m_scroll = new QScrollArea(this);
    m_scroll->setFrameShape(QFrame::NoFrame);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* body = new QWidget(m_scroll);
    auto* setup = new QVBoxLayout(body);
    setup->setContentsMargins(0, 0, 4, 0);
    m_form = new SweepForm(settings, body);
    m_servos = new SweepServos(m_desk, m_selection, settings, body);
    setup->addWidget(m_form);
    m_form->insertServoList(m_servos);
    setup->addStretch();
    m_scroll->setWidget(body);
    left->addWidget(m_scroll, 1);
    left->addWidget(buildRun());
    m_results = new SweepResults(m_desk, m_test, settings, this);
    row->addLayout(left);
    row->addWidget(m_results, 1);
    column->addLayout(row, 1);
    new FloatingOverlay(m_banner, m_results->chart(), FloatingOverlay::Corner::BottomRight);
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
    m_run->setProperty("mainAction", true);
    m_stop = new QPushButton(box);
    m_stop->setObjectName(QStringLiteral("sweepStop"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_run, 1);
    buttons->addWidget(m_stop);
    m_progress = new ThinProgress(box);
    m_progress->setObjectName(QStringLiteral("sweepProgress"));
    m_progress->setRange(0, 1000);
    m_progressLabel = new QLabel(box);
    m_progressLabel->setObjectName(QStringLiteral("sweepProgressWords"));
    m_progressLabel->setWordWrap(true);
    // The buttons stand last: what comes and goes above them must not move them.
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
    m_previewTimer.setSingleShot(true);
    m_previewTimer.setInterval(previewDelay);
    connect(&m_previewTimer, &QTimer::timeout, this, &SweepPage::preview);
    m_retryTimer.setSingleShot(true);
    m_retryTimer.setInterval(retryPeriod);
    connect(&m_retryTimer, &QTimer::timeout, this, &SweepPage::schedulePreview);
    connect(m_form, &SweepForm::changed, this, &SweepPage::schedulePreview);
    connect(m_servos, &SweepServos::changed, this, &SweepPage::onServoSelected);
    connect(m_servos, &SweepServos::limitsRequested, this, &SweepPage::editLimits);
    connect(m_servos, &SweepServos::clicked, this, [this](session::ServoRef ref) {
        const auto& tested = m_test.servos();
        const auto place = std::find(tested.begin(), tested.end(), ref);
        if (place != tested.end())
            m_results->showServo(int(place - tested.begin()));
    });
    connect(m_switchMode, &QCheckBox::toggled, this, &SweepPage::showState);
    connect(m_previewLabel, &QLabel::linkActivated, this, [this] {
        for (const session::SweepPreview& one : m_previews) {
            if (one.estimate)
                m_form->setPace(one.estimate->proposedDelay);
        }
        schedulePreview();
    });
    connect(m_run, &QPushButton::clicked, this, &SweepPage::run);
    connect(m_stop, &QPushButton::clicked, &m_test, &session::SweepTest::stop);
    connect(m_results, &SweepResults::previousTestsRequested, this,
            &SweepPage::previousTestsRequested);
    connect(m_results, &SweepResults::servoShown, this, [this] {
        showReference();
        if (m_results->shownServo() < m_test.servos().size())
            m_servos->markRow(m_test.servos()[m_results->shownServo()]);
    });
    connect(&m_historyService, &session::HistoryService::runSaveFailed, this,
            [this](const base::Error& error, const QString& file) {
                m_leftoversShown = false; // one message at a time
                m_banner->showMessage([error, file] {
                    const text::Description words = text::describe(error);
                    return BannerText{Tone::Bad, tr("The test is not in the history."),
                                      words.message,
                                      file.isEmpty() ? words.remedy
                                                     : tr("It was left in the file %1.").arg(file)};
                });
            });
    connect(&m_test, &session::SweepTest::previewReady, this, &SweepPage::setPreviews);
    connect(&m_test, &session::SweepTest::started, this, [this] {
        showVerdicts();
        showState();
    });
    connect(&m_test, &session::SweepTest::progressChanged, this, &SweepPage::showProgress);
    connect(&m_test, &session::SweepTest::finished, this, &SweepPage::onTestFinished);
    connect(&m_test, &session::SweepTest::leftoversChanged, this,
            &SweepPage::showRemainingLeftovers);
    connect(m_banner, &Banner::dismissed, this, [this] { m_leftoversShown = false; });
    connect(&m_test, &session::SweepTest::failed, this, &SweepPage::onTestFailed);
    for (const auto signal : {&session::Desk::linkChanged, &session::Desk::searchChanged,
                              &session::Desk::servosCleared, &session::Desk::taskChanged})
        connect(&m_desk, signal, this, &SweepPage::showState);
    connect(&m_desk, &session::Desk::linkChanged, this, &SweepPage::schedulePreview);
    connect(&m_desk, &session::Desk::servoChanged, this, &SweepPage::onSettingsRead);
    connect(&m_desk, &session::Desk::tableChanged, this, &SweepPage::onSettingsRead);
    connect(&m_desk, &session::Desk::searchChanged, this, &SweepPage::schedulePreview);
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
    for (const session::ServoRef ref : selected) // it may fall silent before it has been read
        m_knownSettings.try_emplace(ref, settingsOf(m_desk.servo(ref)));
    const session::ServoRef first = selected.empty() ? 0 : selected.front();
    if (first != 0 && first != m_shown) {
        if (m_shown != 0)
            m_typed[m_shown] = m_form->userInput();
        m_shown = first;
        m_form->setUserInput(m_typed[first]);
        m_form->showServo(m_desk.servo(first));
    }
    schedulePreview();
}

/// Mode or limits have changed, or a servo that could not be read answers: what was found out may
/// not be so any more.
void SweepPage::onSettingsRead(session::ServoRef ref)
{
    const auto seen = m_knownSettings.find(ref);
    if (seen == m_knownSettings.end())
        return;
    const bool changed = seen->second != settingsOf(m_desk.servo(ref));
    if (changed)
        showState(); // one that answers no more blocks Run before the reading has ended
    // Readings come faster than the timer runs, so they must not start it anew.
    if (m_previewTimer.isActive())
        return;
    if (changed)
        schedulePreview();
    else
        retryPreview();
}

/// After a reading that got no answer, once its servos are heard again.
void SweepPage::retryPreview()
{
    const auto isHeardSince = [this](const session::SweepPreview& one) {
        const session::ServoEntry* entry = m_desk.servo(one.servo);
        return isNoAnswer(one) && entry != nullptr && !entry->silent &&
               entry->lastSeen - m_previewTime > retryAfter;
    };
    if (std::any_of(m_previews.begin(), m_previews.end(), isHeardSince))
        schedulePreview();
}

void SweepPage::schedulePreview()
{
    if (m_test.isRunning() || !isVisible())
        return;
    m_previewTimer.start();
}

void SweepPage::preview()
{
    if (!m_deskGuard || !isVisible())
        return;
    // What changes from now on is looked at anew. What had changed before must not be: a reading of
    // several silent servos takes long and would never come to its end.
    rememberSettings(m_servos->selected());
    if (!blockedReason().isEmpty()) {
        m_previews.clear();
        showState();
        return;
    }
    m_test.preview(testRequest());
}

void SweepPage::rememberSettings(const std::vector<session::ServoRef>& servos)
{
    m_knownSettings.clear();
    for (const session::ServoRef ref : servos)
        m_knownSettings[ref] = settingsOf(m_desk.servo(ref));
}

/// Of those that take part: an emergency stop holds them.
QStringList SweepPage::servosHeldByStop() const
{
    QStringList held;
    for (const session::ServoRef ref : m_servos->selected()) {
        if (const session::ServoEntry* entry = m_desk.servo(ref); entry->stopped)
            held.append(QStringLiteral("ID %1").arg(entry->servo.id));
    }
    return held;
}

/// Of those that take part, the first that does not answer now, whatever was read of it before.
std::optional<session::SweepPreview> SweepPage::silentServo() const
{
    for (const session::ServoRef ref : m_servos->selected()) {
        const session::ServoEntry* entry = m_desk.servo(ref);
        if (entry != nullptr && entry->silent)
            return session::SweepPreview{
                ref,
                {},
                base::Error{base::ErrorCode::NoReply, QStringLiteral("sweep"), {}, entry->servo.id},
                {}};
    }
    return std::nullopt;
}

/// What is proposed changes the test, so that it has to be looked at once more.
void SweepPage::setPreviews(const std::vector<session::SweepPreview>& previews)
{
    m_previews = previews;
    m_previewTime = m_desk.now();
    rememberSettings(m_servos->selected());
    if (std::any_of(previews.begin(), previews.end(), isNoAnswer))
        m_retryTimer.start();
    else
        m_retryTimer.stop();
    if (!previews.empty()) {
        const record::SweepSpec before = m_form->spec();
        const session::SweepPreview& first = previews.front();
        m_form->showServo(m_desk.servo(first.servo));
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
    if (m_desk.state() != session::LinkState::Open)
        return tr("Connect first: there is no open port.");
    if (m_desk.isSearching())
        return tr("The search goes on; the test can be started when it has ended.");
    if (m_servos->selected().empty())
        return tr("Choose a servo in the list, or tick one below.");
    if (const QStringList held = servosHeldByStop(); !held.isEmpty())
        return tr("Held by the emergency stop: %1. Switch torque on first; the Operate page does "
                  "it for all selected servos.")
            .arg(held.join(QStringLiteral(", ")));
    return m_form->inputError();
}

void SweepPage::showState()
{
    if (!m_deskGuard)
        return;
    const bool running = m_test.isRunning();
    const bool mode = std::any_of(m_previews.begin(), m_previews.end(), isWrongMode);
    m_switchMode->setVisible(mode && !running);
    const bool refused = std::any_of(m_previews.begin(), m_previews.end(), [&](const auto& one) {
        return one.error && !(isWrongMode(one) && m_switchMode->isChecked());
    });
    m_form->setLocked(running);
    m_servos->setLocked(running);
    m_run->setEnabled(!running && blockedReason().isEmpty() && !refused && !m_previews.empty() &&
                      !silentServo());
    m_stop->setEnabled(running);
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
        words = previewText(m_previews, m_form->spec(), m_desk, m_switchMode->isChecked());
    if (const auto silent = silentServo();
        silent && words.tone != Tone::Bad && blockedReason().isEmpty())
        words = previewText({*silent}, m_form->spec(), m_desk, false);
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

void SweepPage::retranslate()
{
    setAccessibleName(tr("Sweep test"));
    m_run->setText(tr("Run"));
    m_run->setToolTip(tr("Start the test: the servos will move"));
    m_stop->setText(tr("Stop"));
    m_stop->setToolTip(tr("End the test; the servos hold or are released, as chosen"));
    m_switchMode->setText(tr("Switch to position mode for the test"));
    m_switchMode->setToolTip(tr("Until the test has ended, then back again; nothing is kept in the "
                                "servo for good"));
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
