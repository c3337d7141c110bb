// SPDX-License-Identifier: GPL-3.0-or-later
// What the control panel is made of, and who tells whom.
#include "ui/operate/control_fields.h"
#include "ui/operate/control_goal.h"
#include "ui/operate/control_limit.h"
#include "ui/operate/control_mode.h"
#include "ui/operate/control_panel.h"
#include "ui/operate/control_torque.h"
#include "ui/operate/torque_hint.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/press_guard.h"
#include "ui/widgets/segment_button.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QShowEvent>
#include <QVBoxLayout>

namespace ui {
namespace {
using namespace std::chrono_literals;
constexpr auto refreshDelay = 25ms;
/// A dial that has not moved for so long has been let go.
constexpr auto dialDragTimeout = 400ms;
constexpr int margin = 12;
constexpr int minWidth = 340;
constexpr int maxWidth = 420;
constexpr int titleLines = 2; ///< as many as a long one has

/// Always there, so that the controls keep their width; empty while everything is in sight.
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
} // namespace

ControlPanel::ControlPanel(session::Desk& desk, Commands& commands, Selection& selection,
                           session::Settings& settings, session::MotionController& drive,
                           QWidget* parent)
    : QWidget(parent)
    , m_desk(desk)
    , m_commands(commands)
    , m_selection(selection)
    , m_motion(drive)
{
    setObjectName(QStringLiteral("controlPanel"));
    setMinimumWidth(minWidth);
    setMaximumWidth(maxWidth);
    build(settings);
    connectParts();
    connectDesk();
    retranslate();
    onSelectionChanged();
}

ControlPanel::~ControlPanel()
{
    m_goal->disconnect(this); // a drag that is under way ends when its slider goes
}

QWidget* ControlPanel::buildHeader(QWidget* body)
{
    auto* head = new QWidget(body);
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins({});
    m_title = new QLabel(head);
    m_title->setObjectName(QStringLiteral("controlTitle"));
    m_title->setWordWrap(true);
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setMinimumHeight(titleLines * m_title->fontMetrics().lineSpacing());
    m_torque = new ControlTorque(m_commands, head);
    row->addWidget(m_title, 1);
    row->addWidget(m_torque);
    return head;
}

QWidget* ControlPanel::buildWrite(QWidget* body)
{
    auto* box = new QWidget(body);
    box->setObjectName(QStringLiteral("controlWrite"));
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    box->setSizePolicy(policy);
    auto* row = new FlowLayout(box, 6); // where words are long, what sends stands below
    const auto group = [&] {
        auto* one = new QWidget(box);
        auto* buttons = new QHBoxLayout(one);
        buttons->setContentsMargins({});
        buttons->setSpacing(2);
        row->addWidget(one);
        return one;
    };
    QWidget* ways = group();
    m_writeMode = new QButtonGroup(this);
    static const char* const names[] = {"howWrite", "howSync", "howAsync"};
    for (int i = 0; i < 3; ++i) {
        auto* button = new SegmentButton(ways);
        button->setObjectName(QString::fromLatin1(names[i]));
        m_writeMode->addButton(button, i);
        ways->layout()->addWidget(button);
    }
    m_writeMode->button(0)->setChecked(true);
    QWidget* actions = group();
    m_execute = new QPushButton(actions);
    m_execute->setObjectName(QStringLiteral("execute"));
    m_set = new QPushButton(actions);
    m_set->setObjectName(QStringLiteral("setGoal"));
    m_set->setProperty("mainAction", true);
    for (QWidget* widget : {m_execute, m_set})
        new PressGuard(widget);
    actions->layout()->addWidget(m_execute);
    actions->layout()->addWidget(m_set);
    return box;
}

QScrollArea* ControlPanel::buildScroll()
{
    auto* scroll = new QScrollArea(this);
    scroll->setObjectName(QStringLiteral("controlScroll"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setVerticalScrollBar(new QuietScrollBar(Qt::Vertical, scroll));
    scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    return scroll;
}

void ControlPanel::buildMessages(session::Settings& settings)
{
    m_messages = new QWidget(this);
    m_messages->setObjectName(QStringLiteral("controlMessages"));
    auto* column = new QVBoxLayout(m_messages);
    column->setContentsMargins({});
    m_hint = new TorqueHint(settings, m_messages);
    m_banner = new Banner(m_messages);
    m_banner->setObjectName(QStringLiteral("controlBanner"));
    m_banner->hideMessage();
    column->addWidget(m_hint);
    column->addWidget(m_banner);
}

void ControlPanel::build(session::Settings& settings)
{
    QScrollArea* scroll = buildScroll();
    buildMessages(settings);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins({});
    outer->setSpacing(0);
    outer->addWidget(scroll, 1);
    outer->addWidget(m_messages);
    auto* body = new QWidget(scroll);
    scroll->setWidget(body);
    scroll->viewport()->setAutoFillBackground(false);
    body->setAutoFillBackground(false);
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(margin, margin, margin, margin);
    column->setSpacing(10);
    auto* top = new QVBoxLayout;
    top->setSpacing(2);
    top->addWidget(buildHeader(body));
    column->addLayout(top);
    m_stopped = new QLabel(body);
    m_stopped->setObjectName(QStringLiteral("controlStopped"));
    QSizePolicy kept = m_stopped->sizePolicy();
    kept.setRetainSizeWhenHidden(true);
    m_stopped->setSizePolicy(kept);
    m_stopped->hide();
    top->addWidget(m_stopped);
    m_empty = new QLabel(body);
    m_empty->setObjectName(QStringLiteral("controlEmpty"));
    m_empty->setWordWrap(true);
    m_content = new QWidget(body);
    column->addWidget(m_empty);
    column->addWidget(m_content);
    column->addStretch(1);

    auto* parts = new QVBoxLayout(m_content);
    parts->setContentsMargins({});
    parts->setSpacing(10);
    m_mode = new ControlMode(m_content);
    m_dialLayout = new QVBoxLayout;
    m_goal = new ControlGoal(m_content);
    m_fields = new ControlFields(m_content);
    m_write = buildWrite(m_content);
    m_limit = new ControlLimit(settings, m_content);
    m_resultLabel = new QLabel(m_content);
    m_resultLabel->setObjectName(QStringLiteral("controlSaid"));
    m_resultLabel->setWordWrap(true);
    parts->addWidget(m_mode);
    parts->addLayout(m_dialLayout);
    // What was said stands last: its lines come and go.
    for (QWidget* part : {static_cast<QWidget*>(m_goal), static_cast<QWidget*>(m_fields), m_write,
                          static_cast<QWidget*>(m_limit), static_cast<QWidget*>(m_resultLabel)})
        parts->addWidget(part);
}

void ControlPanel::connectParts()
{
    connect(m_torque, &ControlTorque::requested, this, &ControlPanel::requestTorque);
    connect(m_mode, &ControlMode::requested, &m_motion, &session::MotionController::previewMode);
    connect(m_goal, &ControlGoal::goalMoved, this, &ControlPanel::dragTo);
    connect(m_goal, &ControlGoal::dragEnded, this, [this] {
        m_isDragging = false;
        m_motion.endDrag();
        scheduleRefresh();
    });
    connect(m_goal, &ControlGoal::returnPressed, this, &ControlPanel::sendGoalFromField);
    connect(m_goal, &ControlGoal::stopRequested, this, &ControlPanel::stopMove);
    connect(m_goal, &ControlGoal::stepRequested, this, &ControlPanel::step);
    connect(m_goal, &ControlGoal::repeatRequested, this, [this] {
        clearResult();
        m_motion.repeatStep();
    });
    connect(m_goal, &ControlGoal::goalShown, this, &ControlPanel::goalShown);
    connect(m_fields, &ControlFields::returnPressed, this, &ControlPanel::sendGoalFromField);
    connect(m_set, &QPushButton::clicked, this, &ControlPanel::sendGoalFromField);
    connect(m_execute, &QPushButton::clicked, this, [this] {
        clearResult();
        m_motion.startHeldMoves();
    });
    connect(m_writeMode, &QButtonGroup::idClicked, this, &ControlPanel::showWrite);
    connect(m_limit, &ControlLimit::limitRequested, &m_motion,
            &session::MotionController::setTorqueLimit);
    m_dialDragTimer.setSingleShot(true);
    m_dialDragTimer.setInterval(dialDragTimeout);
    connect(&m_dialDragTimer, &QTimer::timeout, m_goal, &ControlGoal::endDialDrag);
}

void ControlPanel::connectDesk()
{
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(refreshDelay);
    connect(&m_refresh, &QTimer::timeout, this, &ControlPanel::refresh);
    const auto concern = [this](session::ServoRef ref) {
        if (ref == m_selection.current())
            scheduleRefresh();
    };
    connect(&m_desk, &session::Desk::servoChanged, this, concern);
    connect(&m_desk, &session::Desk::tableChanged, this, concern);
    connect(&m_desk, &session::Desk::linkChanged, this, [this] {
        m_hint->dismiss();
        scheduleRefresh();
    });
    connect(&m_selection, &Selection::selectedServosChanged, this,
            &ControlPanel::onSelectionChanged);
    connect(&m_motion, &session::MotionController::changed, this, &ControlPanel::scheduleRefresh);
    connect(&m_motion, &session::MotionController::modeSwitched, m_hint, &TorqueHint::dismiss);
    connect(&m_desk, &session::Desk::eventOccurred, this, [this](const session::Event& event) {
        if (event.kind == session::Event::Kind::Started)
            clearResult();
        if (event.kind == session::Event::Kind::Stopped) {
            m_hint->dismiss();
            clearResult();
            m_goal->discardEdit();
            m_fields->discardEdits();
            m_limit->discardEdit();
            scheduleRefresh();
        }
    });
    connect(&m_motion, &session::MotionController::modePreviewed, this,
            &ControlPanel::confirmModeSwitch);
    connect(&m_motion, &session::MotionController::failed, this, &ControlPanel::showError);
    connect(&m_motion, &session::MotionController::noticesReported, this,
            &ControlPanel::showNotices);
    connect(&m_motion, &session::MotionController::moveSent, this, &ControlPanel::onGoalSent);
}

void ControlPanel::setDial(QWidget* dial)
{
    m_dial = dial;
    m_dialLayout->addWidget(dial, 0, Qt::AlignHCenter);
    new PressGuard(dial);
    scheduleRefresh();
}

void ControlPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!event->spontaneous())
        readUnreadTables();
}

void ControlPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}
} // namespace ui
