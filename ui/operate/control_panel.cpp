// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/operate/control_panel.h"

#include "ui/common/follow_language.h"
#include "ui/common/widget_style.h"
#include "ui/operate/control_fields.h"
#include "ui/operate/control_goal.h"
#include "ui/operate/control_header.h"
#include "ui/operate/control_limit.h"
#include "ui/operate/control_messages.h"
#include "ui/operate/control_mode.h"
#include "ui/operate/control_send.h"
#include "ui/operate/control_text.h"
#include "ui/operate/control_torque.h"
#include "ui/operate/goal_sender.h"
#include "ui/operate/move_result.h"
#include "ui/operate/torque_confirmation.h"
#include "ui/operate/torque_hint.h"
#include "ui/widgets/press_guard.h"
#include "ui/widgets/question_dialog.h"
#include "ui/widgets/servo_obstacle.h"

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QShowEvent>
#include <QVBoxLayout>

namespace ui {
using device::GoalKind;

namespace {
using namespace std::chrono_literals;
constexpr auto refreshDelay = 25ms;
constexpr int minWidth = 340;
constexpr int maxWidth = 420;
constexpr int dialMargin = 24;

/// Always takes its space, so that the controls keep their width; empty while all of them fit.
class QuietScrollBar final : public QScrollBar {
public:
    using QScrollBar::QScrollBar;

protected:
    void paintEvent(QPaintEvent* event) override
    {
        if (minimum() < maximum())
            QScrollBar::paintEvent(event);
    }
};

QScrollArea* newScrollArea(QWidget* parent)
{
    auto* scroll = new QScrollArea(parent);
    scroll->setObjectName(QStringLiteral("controlScroll"));
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setVerticalScrollBar(new QuietScrollBar(Qt::Vertical, scroll));
    scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    return scroll;
}
} // namespace

ControlPanel::ControlPanel(session::Workbench& workbench, Commands& commands, Selection& selection,
                           session::Settings& settings, session::MotionController& motion,
                           QWidget* parent)
    : QWidget(parent)
    , m_workbench(workbench)
    , m_commands(commands)
    , m_selection(selection)
    , m_motion(motion)
{
    setObjectName(QStringLiteral("controlPanel"));
    setMinimumWidth(minWidth);
    setMaximumWidth(maxWidth);
    build(settings);
    connectControls();
    connectWorkbench();
    connectMotion();
    followLanguage(this, [this] { retranslate(); });
    onSelectionChanged();
}

ControlPanel::~ControlPanel()
{
    delete m_sender; // a drag in progress ends when its slider is destroyed
    m_goal->disconnect(this);
}

void ControlPanel::build(session::Settings& settings)
{
    m_scroll = newScrollArea(this);
    m_messages = new ControlMessages(settings, this);
    auto* outer = new QVBoxLayout(this);
    outer->setSpacing(8);
    m_header = new ControlHeader(m_commands, this);
    outer->addWidget(m_header);
    outer->addWidget(m_scroll, 1);
    outer->addWidget(m_messages);
    makeCard(this);
    auto* body = new QWidget(m_scroll);
    m_scroll->setWidget(body);
    makeTransparent(m_scroll);
    m_scroll->viewport()->installEventFilter(this);
    m_empty = new ServoObstacle(m_commands, QStringLiteral("controlEmpty"), body);
    m_content = new QWidget(body);
    buildContent(settings);
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins({});
    column->addWidget(m_empty);
    column->addWidget(m_content);
    column->addStretch(1);
}

void ControlPanel::buildContent(session::Settings& settings)
{
    m_dialLayout = new QVBoxLayout;
    m_goal = new ControlGoal(m_content);
    m_fields = new ControlFields(m_content);
    m_send = new ControlSend(m_content);
    m_limit = new ControlLimit(settings, m_content);
    m_result = new MoveResult(m_content);
    auto* column = new QVBoxLayout(m_content);
    column->setContentsMargins({});
    column->setSpacing(8);
    column->addLayout(m_dialLayout);
    // The result is last: its lines come and go.
    for (QWidget* control :
         std::initializer_list<QWidget*>{m_goal, m_fields, m_send, m_limit, m_result})
        column->addWidget(control);
}

void ControlPanel::connectControls()
{
    m_torqueConfirmation = std::make_unique<TorqueConfirmation>(
        m_workbench.link(), m_workbench.registry(), m_motion, *m_messages->hint());
    m_sender = new GoalSender(
        m_workbench.registry(), m_selection, m_motion,
        {*m_goal, *m_fields, *m_send, *m_messages, *m_result, *m_torqueConfirmation}, this);
    connect(m_sender, &GoalSender::controlsChanged, this, &ControlPanel::scheduleRefresh);
    connect(m_header->torque(), &ControlTorque::requested, this, &ControlPanel::requestTorque);
    connect(m_header->mode(), &ControlMode::requested, &m_motion,
            &session::MotionController::previewMode);
    connect(m_goal, &ControlGoal::stopRequested, this, &ControlPanel::stopMove);
    connect(m_goal, &ControlGoal::goalShown, this, &ControlPanel::goalShown);
    connect(m_limit, &ControlLimit::limitRequested, &m_motion,
            &session::MotionController::setTorqueLimit);
}

void ControlPanel::connectWorkbench()
{
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(refreshDelay);
    connect(&m_refresh, &QTimer::timeout, this, &ControlPanel::refresh);
    const auto servoChanged = [this](session::ServoRef ref) {
        if (ref == m_selection.current())
            scheduleRefresh();
    };
    connect(&m_workbench.registry(), &session::ServoRegistry::servoChanged, this, servoChanged);
    connect(&m_workbench.registry(), &session::ServoRegistry::tableChanged, this, servoChanged);
    connect(&m_workbench.link(), &session::LinkController::linkChanged, this, [this] {
        m_torqueConfirmation->dismiss();
        scheduleRefresh();
    });
    connect(&m_workbench, &session::Workbench::eventOccurred, this, &ControlPanel::onEvent);
    connect(&m_selection, &Selection::selectedServosChanged, this,
            &ControlPanel::onSelectionChanged);
}

void ControlPanel::connectMotion()
{
    using session::MotionController;
    connect(&m_motion, &MotionController::changed, this, &ControlPanel::scheduleRefresh);
    connect(&m_motion, &MotionController::modeSwitched, m_messages->hint(), &TorqueHint::dismiss);
    connect(&m_motion, &MotionController::modePreviewed, this, &ControlPanel::confirmModeSwitch);
    connect(&m_motion, &MotionController::failed, this, &ControlPanel::showError);
    connect(&m_motion, &MotionController::noticesReported, this, &ControlPanel::showNotices);
}

void ControlPanel::setDial(QWidget* dial)
{
    m_dial = dial;
    m_dialLayout->addWidget(dial, 0, Qt::AlignHCenter);
    new PressGuard(dial);
    fitDial();
    scheduleRefresh();
}

QWidget* ControlPanel::messages() const
{
    return m_messages;
}

const session::ServoEntry* ControlPanel::entry() const
{
    return m_workbench.registry().servo(m_selection.current());
}

std::size_t ControlPanel::otherCount() const
{
    return m_motion.servos().empty() ? 0 : m_motion.servos().size() - 1;
}

bool ControlPanel::isPortOpen() const
{
    return m_workbench.link().state() == session::LinkState::Open;
}

void ControlPanel::onSelectionChanged()
{
    m_motion.setServos(m_selection.selected());
    m_messages->hideMessage();
    m_result->clearNotices();
    m_result->setMinimumHeight(0);
    m_torqueConfirmation->dismiss();
    if (isVisible())
        readUnreadTables();
    m_send->resetMethod();
    refresh();
}

/// The panel shows limits and modes; they are not needed while it is hidden.
void ControlPanel::readUnreadTables()
{
    for (const session::ServoRef ref : m_motion.servos()) {
        const session::ServoEntry* known = m_workbench.registry().servo(ref);
        const bool unread = known != nullptr && known->servo.profile && !known->hasFullTable;
        if (unread && isPortOpen())
            m_workbench.writes().readTable(ref);
    }
}

void ControlPanel::scheduleRefresh()
{
    if (!m_refresh.isActive())
        m_refresh.start();
}

void ControlPanel::refresh()
{
    const session::ServoEntry* known = entry();
    const QString obstacle = controlObstacle(known);
    m_empty->showObstacle(obstacle, known);
    m_empty->setVisible(!obstacle.isEmpty());
    m_content->setVisible(obstacle.isEmpty());
    m_header->showServo(known, otherCount());
    m_header->torque()->showServo(obstacle.isEmpty() ? known : nullptr, isPortOpen());
    m_header->mode()->showServo(obstacle.isEmpty() ? known : nullptr, isPortOpen());
    m_header->showStopped(known, m_motion.isStopped());
    m_torqueConfirmation->dismissIfOutdated();
    if (obstacle.isEmpty())
        showControls(*known);
    Q_EMIT goalStateChanged();
}

void ControlPanel::showControls(const session::ServoEntry& known)
{
    const bool several = otherCount() > 0;
    const bool canMove = isPortOpen() && !m_motion.isStopped();
    if (!m_motion.isBusy())
        m_goal->clearPending();
    m_goal->showServo(known, {m_motion.totalSteps(known.ref), m_motion.canRepeatStep()});
    m_fields->showServo(known, several);
    m_limit->showServo(&known, isPortOpen());
    m_goal->setEnabled(canMove);
    m_fields->setEnabled(canMove);
    if (m_dial != nullptr)
        m_dial->setVisible(device::goalRegister(known.servo) != nullptr);
    m_send->showServo(known, {several, canMove, m_motion.heldCount()});
    fitDial();
}

std::optional<std::int64_t> ControlPanel::positionGoal() const
{
    const session::ServoEntry* known = entry();
    const auto kind =
        known != nullptr && known->servo.profile ? device::goalKind(known->servo) : std::nullopt;
    const bool isPosition = kind == GoalKind::Position || kind == GoalKind::Turns;
    return isPosition ? m_goal->shownGoal() : std::nullopt;
}

bool ControlPanel::isGoalMovable() const
{
    return positionGoal() && m_goal->isEnabled() && controlObstacle(entry()).isEmpty();
}

void ControlPanel::setGoalFromDial(std::int64_t raw)
{
    if (isGoalMovable())
        m_sender->dragDialTo(raw);
}

void ControlPanel::requestTorque(device::Torque torque)
{
    const auto action = [this, torque] {
        m_result->clearNotices();
        m_motion.setTorque(torque);
    };
    m_messages->hideMessage();
    if (torque != device::Torque::On || m_torqueConfirmation->confirm(action))
        action();
}

void ControlPanel::stopMove()
{
    m_torqueConfirmation->dismiss();
    m_result->clearNotices();
    m_motion.halt();
}

void ControlPanel::confirmModeSwitch(const device::ModePlan& plan)
{
    const session::ServoEntry* known = entry();
    if (known == nullptr || !known->servo.profile || plan.writes.empty())
        return;
    const catalog::Mode* mode = known->servo.profile->mode(plan.to);
    if (mode == nullptr)
        return;
    Question question;
    question.title = tr("Switch ID %1 to \"%2\"?").arg(known->servo.id).arg(modeTitle(*mode));
    question.text = modePlanText(plan, *known->servo.profile, static_cast<int>(otherCount()));
    question.acceptText = tr("Switch");
    question.guard = this;
    ask(this, question, [this, ref = known->ref, to = plan.to] {
        if (m_selection.current() != ref)
            return;
        m_torqueConfirmation->dismiss();
        m_result->clearNotices();
        m_motion.switchMode(to);
    });
}

void ControlPanel::onEvent(const session::Event& event)
{
    if (event.kind == session::Event::Kind::Started)
        m_result->clearNotices();
    if (event.kind != session::Event::Kind::Stopped)
        return;
    m_torqueConfirmation->dismiss();
    m_result->clearNotices();
    m_goal->discardEdit();
    m_fields->discardEdits();
    m_limit->discardEdit();
    scheduleRefresh();
}

void ControlPanel::showError(const base::Error& error)
{
    m_goal->cancelDrag();
    m_goal->clearSent();
    const session::ServoEntry* known = entry();
    m_messages->showError(error, known != nullptr ? known->servo.profile : nullptr);
    scheduleRefresh();
}

void ControlPanel::showNotices(const device::Notices& notices)
{
    const session::ServoEntry* known = entry();
    const auto profile = known != nullptr ? known->servo.profile : nullptr;
    m_messages->showWarnings(notices, profile);
    m_result->showNotices(notices, profile);
}

void ControlPanel::retranslate()
{
    setAccessibleName(tr("Control"));
    m_header->torque()->retranslate();
    m_header->mode()->retranslate();
    m_goal->retranslate();
    m_fields->retranslate();
    m_send->retranslate();
    m_limit->retranslate();
    m_messages->hint()->retranslate();
    m_result->retranslate();
    refresh();
}

void ControlPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    fitDial();
    if (!event->spontaneous())
        readUnreadTables();
}

bool ControlPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_scroll->viewport() && event->type() == QEvent::Resize)
        fitDial();
    return QWidget::eventFilter(watched, event);
}

/// As large as the controls leave it room. What comes and goes below them does not count, because
/// they would move.
void ControlPanel::fitDial()
{
    if (m_dial == nullptr || !isVisible())
        return;
    const int width = m_scroll->viewport()->width(); // the content follows after this
    const int spacing = m_content->layout()->spacing();
    int others = 2 * spacing + m_result->fontMetrics().lineSpacing(); // a result of one line
    for (const QWidget* control :
         std::initializer_list<QWidget*>{m_goal, m_fields, m_send, m_limit}) {
        const QLayout* inside = control->layout();
        if (!control->isHidden())
            others += spacing + (inside->hasHeightForWidth() ? inside->totalHeightForWidth(width)
                                                             : inside->totalSizeHint().height());
    }
    others -= m_limit->isHidden() ? 0 : m_limit->detailsHeight();
    const int side = std::clamp(m_scroll->viewport()->height() - others,
                                m_dial->minimumSizeHint().height(), m_dial->sizeHint().height());
    m_dial->setFixedSize(side + dialMargin, side);
}
} // namespace ui
