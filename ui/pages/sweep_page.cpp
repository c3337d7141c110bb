// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/sweep_page.h"

#include "device/move_limits.h"
#include "text/error_words.h"
#include "ui/models/sweep_cells.h"
#include "ui/pages/sweep_form.h"
#include "ui/pages/sweep_outlook.h"
#include "ui/pages/sweep_results.h"
#include "ui/pages/sweep_servos.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/float_over.h"
#include "ui/widgets/press_guard.h"
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
constexpr auto lookDelay = 250ms; ///< after the last letter
constexpr auto retryAfter = 1s;   ///< of a servo that is heard again
constexpr auto retryPeriod = 3s;  ///< of one that nothing else reads
constexpr int leastSetup = 300;
constexpr int mostSetup = 360;
constexpr int setupPercent = 28;

QString settingsOf(const session::ServoEntry* entry)
{
    if (entry == nullptr || !entry->servo.profile)
        return {};
    const catalog::Mode* mode = entry->servo.mode();
    const auto span = device::goalSpan(entry->servo);
    return QStringLiteral("%1 %2 %3 %4")
        .arg(mode != nullptr ? mode->key : QString())
        .arg(span ? span->min : 0)
        .arg(span ? span->max : 0)
        .arg(int(entry->stopped) + 2 * int(entry->silent));
}

bool gotNoAnswer(const session::SweepLook& look)
{
    using base::ErrorCode;
    return look.error &&
           (look.error->code == ErrorCode::NoAnswer || look.error->code == ErrorCode::Garbled ||
            look.error->code == ErrorCode::WrongAnswer || look.error->code == ErrorCode::LineBusy);
}

bool wrongMode(const session::SweepLook& look)
{
    return look.error && look.error->code == base::ErrorCode::NotSupported &&
           look.error->detail == QLatin1StringView("not-position");
}
} // namespace

SweepPage::SweepPage(Bench& bench, session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_desk(bench.desk)
    , m_deskLives(&bench.desk)
    , m_selection(bench.selection)
    , m_test(bench.sweep)
    , m_archive(bench.archive)
{
    setObjectName(QStringLiteral("sweepPage"));
    build(settings);
    connectAll();
    retranslate();
    servoChosen();
    showState();
}

SweepPage::~SweepPage() = default;

void SweepPage::build(session::Settings& settings)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 6, 0, 0);
    m_banner = new Banner(this);
    m_banner->setObjectName(QStringLiteral("sweepBanner"));
    m_banner->clear();
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
    m_form->insert(m_servos);
    setup->addStretch();
    m_scroll->setWidget(body);
    left->addWidget(m_scroll, 1);
    left->addWidget(buildRun());
    m_results = new SweepResults(m_desk, m_test, settings, this);
    row->addLayout(left);
    row->addWidget(m_results, 1);
    column->addLayout(row, 1);
    new FloatOver(m_banner, m_results->chart(), FloatOver::Corner::BottomRight);
}

/// Always in sight, however long the fields above are.
QWidget* SweepPage::buildRun()
{
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins({});
    column->setSpacing(4);
    m_outlook = new QLabel(box);
    m_outlook->setObjectName(QStringLiteral("sweepOutlook"));
    m_outlook->setWordWrap(true);
    m_outlook->setTextFormat(Qt::RichText);
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
    m_progressWords = new QLabel(box);
    m_progressWords->setObjectName(QStringLiteral("sweepProgressWords"));
    m_progressWords->setWordWrap(true);
    // The buttons stand last: what comes and goes above them must not move them.
    column->addWidget(m_progress);
    column->addWidget(m_progressWords);
    column->addWidget(m_outlook);
    column->addWidget(m_switchMode);
    column->addLayout(buttons);
    new PressGuard(m_run);
    return box;
}

void SweepPage::connectAll()
{
    m_lookTimer.setSingleShot(true);
    m_lookTimer.setInterval(lookDelay);
    connect(&m_lookTimer, &QTimer::timeout, this, &SweepPage::look);
    m_retry.setSingleShot(true);
    m_retry.setInterval(retryPeriod);
    connect(&m_retry, &QTimer::timeout, this, &SweepPage::lookSoon);
    connect(m_form, &SweepForm::changed, this, &SweepPage::lookSoon);
    connect(m_servos, &SweepServos::changed, this, &SweepPage::servoChosen);
    connect(m_servos, &SweepServos::limitsWished, this, &SweepPage::editLimits);
    connect(m_servos, &SweepServos::clicked, this, [this](session::ServoRef ref) {
        const auto& tested = m_test.servos();
        const auto place = std::find(tested.begin(), tested.end(), ref);
        if (place != tested.end())
            m_results->showServo(int(place - tested.begin()));
    });
    connect(m_switchMode, &QCheckBox::toggled, this, &SweepPage::showState);
    connect(m_outlook, &QLabel::linkActivated, this, [this] {
        for (const session::SweepLook& one : m_looks) {
            if (one.outlook)
                m_form->setPace(one.outlook->enough);
        }
        lookSoon();
    });
    connect(m_run, &QPushButton::clicked, this, &SweepPage::run);
    connect(m_stop, &QPushButton::clicked, &m_test, &session::SweepTest::stop);
    connect(m_results, &SweepResults::earlierWished, this, &SweepPage::earlierWished);
    connect(m_results, &SweepResults::servoShown, this, [this] {
        showReference();
        if (m_results->shownServo() < m_test.servos().size())
            m_servos->markRow(m_test.servos()[m_results->shownServo()]);
    });
    connect(&m_archive, &session::Archive::keepFailed, this,
            [this](const base::Error& error, const QString& file) {
                m_leftShown = false; // one message at a time
                m_banner->present([error, file] {
                    const text::Description words = text::describe(error);
                    return BannerWords{Tone::Bad, tr("The test is not in the history."), words.what,
                                       file.isEmpty()
                                           ? words.remedy
                                           : tr("It was left in the file %1.").arg(file)};
                });
            });
    connect(&m_test, &session::SweepTest::looked, this, &SweepPage::takeLooks);
    connect(&m_test, &session::SweepTest::began, this, [this] {
        showVerdicts();
        showState();
    });
    connect(&m_test, &session::SweepTest::progressed, this, &SweepPage::showProgress);
    connect(&m_test, &session::SweepTest::ended, this, &SweepPage::ended);
    connect(&m_test, &session::SweepTest::leftChanged, this, &SweepPage::showLess);
    connect(m_banner, &Banner::dismissed, this, [this] { m_leftShown = false; });
    connect(&m_test, &session::SweepTest::failed, this, &SweepPage::failed);
    for (const auto signal : {&session::Desk::linkChanged, &session::Desk::searchChanged,
                              &session::Desk::servosCleared, &session::Desk::taskChanged})
        connect(&m_desk, signal, this, &SweepPage::showState);
    connect(&m_desk, &session::Desk::linkChanged, this, &SweepPage::lookSoon);
    connect(&m_desk, &session::Desk::servoChanged, this, &SweepPage::settingsRead);
    connect(&m_desk, &session::Desk::tableChanged, this, &SweepPage::settingsRead);
    connect(&m_desk, &session::Desk::searchChanged, this, &SweepPage::lookSoon);
}

session::SweepTestOrder SweepPage::order() const
{
    session::SweepTestOrder order;
    order.spec = m_form->spec();
    order.servos = m_servos->ticked();
    order.spec.ranges = m_servos->ranges();
    for (auto& [id, range] : order.spec.ranges) {
        range.from = range.from.isEmpty() ? order.spec.range.from : range.from;
        range.to = range.to.isEmpty() ? order.spec.range.to : range.to;
    }
    for (const session::ServoRef ref : order.servos)
        order.limits.push_back(m_servos->limits(ref));
    order.switchMode = m_switchMode->isVisibleTo(this) && m_switchMode->isChecked();
    return order;
}

void SweepPage::servoChosen()
{
    const auto ticked = m_servos->ticked();
    for (const session::ServoRef ref : ticked) // it may fall silent before it has been read
        m_settingsSeen.try_emplace(ref, settingsOf(m_desk.servo(ref)));
    const session::ServoRef first = ticked.empty() ? 0 : ticked.front();
    if (first != 0 && first != m_shown) {
        if (m_shown != 0)
            m_typed[m_shown] = m_form->typedValues();
        m_shown = first;
        m_form->takeTyped(m_typed[first]);
        m_form->showServo(m_desk.servo(first));
    }
    lookSoon();
}

/// Mode or limits have changed, or a servo that could not be read answers: what was found out may
/// not be so any more.
void SweepPage::settingsRead(session::ServoRef ref)
{
    const auto seen = m_settingsSeen.find(ref);
    if (seen == m_settingsSeen.end())
        return;
    const bool changed = seen->second != settingsOf(m_desk.servo(ref));
    if (changed)
        showState(); // one that answers no more blocks Run before the reading has ended
    // Readings come faster than the timer runs, so they must not start it anew.
    if (m_lookTimer.isActive())
        return;
    if (changed)
        lookSoon();
    else
        lookAgain();
}

/// After a reading that got no answer, once its servos are heard again.
void SweepPage::lookAgain()
{
    const auto heardSince = [this](const session::SweepLook& one) {
        const session::ServoEntry* entry = m_desk.servo(one.servo);
        return gotNoAnswer(one) && entry != nullptr && !entry->silent &&
               entry->lastSeen - m_lookedAt > retryAfter;
    };
    if (std::any_of(m_looks.begin(), m_looks.end(), heardSince))
        lookSoon();
}

void SweepPage::lookSoon()
{
    if (m_test.running() || !isVisible())
        return;
    m_lookTimer.start();
}

void SweepPage::look()
{
    if (!m_deskLives || !isVisible())
        return;
    // What changes from now on is looked at anew. What had changed before must not be: a reading of
    // several silent servos takes long and would never come to its end.
    noteSettings(m_servos->ticked());
    if (!whyNot().isEmpty()) {
        m_looks.clear();
        showState();
        return;
    }
    m_test.look(order());
}

void SweepPage::noteSettings(const std::vector<session::ServoRef>& servos)
{
    m_settingsSeen.clear();
    for (const session::ServoRef ref : servos)
        m_settingsSeen[ref] = settingsOf(m_desk.servo(ref));
}

/// Of those that take part: an emergency stop holds them.
QStringList SweepPage::heldByStop() const
{
    QStringList held;
    for (const session::ServoRef ref : m_servos->ticked()) {
        if (const session::ServoEntry* entry = m_desk.servo(ref); entry->stopped)
            held.append(QStringLiteral("ID %1").arg(entry->servo.id));
    }
    return held;
}

/// Of those that take part, the first that does not answer now, whatever was read of it before.
std::optional<session::SweepLook> SweepPage::silentNow() const
{
    for (const session::ServoRef ref : m_servos->ticked()) {
        const session::ServoEntry* entry = m_desk.servo(ref);
        if (entry != nullptr && entry->silent)
            return session::SweepLook{
                ref,
                {},
                base::Error{
                    base::ErrorCode::NoAnswer, QStringLiteral("sweep"), {}, entry->servo.id},
                {}};
    }
    return std::nullopt;
}

/// What is proposed changes the test, so that it has to be looked at once more.
void SweepPage::takeLooks(const std::vector<session::SweepLook>& looks)
{
    m_looks = looks;
    m_lookedAt = m_desk.now();
    noteSettings(m_servos->ticked());
    if (std::any_of(looks.begin(), looks.end(), gotNoAnswer))
        m_retry.start();
    else
        m_retry.stop();
    if (!looks.empty()) {
        const record::SweepSpec before = m_form->spec();
        const session::SweepLook& first = looks.front();
        m_form->showServo(m_desk.servo(first.servo));
        if (first.proposed)
            m_form->propose(*first.proposed);
        base::Duration enough{};
        for (const session::SweepLook& one : looks)
            enough = std::max(enough, one.outlook ? one.outlook->enough : base::Duration{});
        m_form->propose(enough);
        if (!(m_form->spec() == before))
            lookSoon();
    }
    showState();
}

QString SweepPage::whyNot() const
{
    if (m_desk.state() != session::LinkState::Open)
        return tr("Connect first: there is no open port.");
    if (m_desk.searching())
        return tr("The search goes on; the test can be started when it has ended.");
    if (m_servos->ticked().empty())
        return tr("Choose a servo in the list, or tick one below.");
    if (const QStringList held = heldByStop(); !held.isEmpty())
        return tr("Held by the emergency stop: %1. Switch torque on first; the Operate page does "
                  "it for all selected servos.")
            .arg(held.join(QStringLiteral(", ")));
    return m_form->complaint();
}

void SweepPage::showState()
{
    if (!m_deskLives)
        return;
    const bool running = m_test.running();
    const bool mode = std::any_of(m_looks.begin(), m_looks.end(), wrongMode);
    m_switchMode->setVisible(mode && !running);
    const bool refused = std::any_of(m_looks.begin(), m_looks.end(), [&](const auto& one) {
        return one.error && !(wrongMode(one) && m_switchMode->isChecked());
    });
    m_form->setLocked(running);
    m_servos->setLocked(running);
    m_run->setEnabled(!running && whyNot().isEmpty() && !refused && !m_looks.empty() &&
                      !silentNow());
    m_stop->setEnabled(running);
    m_progress->setVisible(running);
    m_progressWords->setVisible(running);
    m_outlook->setVisible(!running);
    showOutlook();
    showProgress();
}

void SweepPage::showOutlook()
{
    OutlookWords words{Tone::Quiet, whyNot()};
    if (words.text.isEmpty())
        words = outlookWords(m_looks, m_form->spec(), m_desk, m_switchMode->isChecked());
    if (const auto silent = silentNow(); silent && words.tone != Tone::Bad && whyNot().isEmpty())
        words = outlookWords({*silent}, m_form->spec(), m_desk, false);
    m_outlook->setText(words.text);
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, tone(words.tone, palette()));
    m_outlook->setPalette(colours);
}

void SweepPage::showProgress()
{
    if (!m_test.running())
        return;
    const jobs::SweepProgress& now = m_test.progress();
    m_progress->setValue(int(now.fraction * 1000));
    m_progressWords->setText(progressWords(now, m_test.run()));
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
    const int wide = std::clamp(width() * setupPercent / 100, leastSetup, mostSetup);
    m_scroll->setFixedWidth(wide);
    m_outlook->setMaximumWidth(wide);
}

void SweepPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    servoChosen();
    showState();
}
} // namespace ui
