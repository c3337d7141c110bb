// SPDX-License-Identifier: GPL-3.0-or-later
// What the control panel is made of, and who tells whom.
#include "ui/pages/control_fields.h"
#include "ui/pages/control_goal.h"
#include "ui/pages/control_hint.h"
#include "ui/pages/control_limit.h"
#include "ui/pages/control_mode.h"
#include "ui/pages/control_panel.h"
#include "ui/pages/control_torque.h"
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
constexpr auto dialRest = 400ms;
constexpr int margin = 12;
constexpr int leastWidth = 340;
constexpr int mostWidth = 420;
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
                           session::Settings& settings, session::Drive& drive, QWidget* parent)
    : QWidget(parent)
    , m_desk(desk)
    , m_commands(commands)
    , m_selection(selection)
    , m_drive(drive)
{
    setObjectName(QStringLiteral("controlPanel"));
    setMinimumWidth(leastWidth);
    setMaximumWidth(mostWidth);
    build(settings);
    connectParts();
    connectDesk();
    retranslate();
    choose();
}

ControlPanel::~ControlPanel()
{
    m_goal->disconnect(this); // a drag that is under way ends when its slider goes
}

QWidget* ControlPanel::buildHead(QWidget* body)
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
    m_how = new QButtonGroup(this);
    static const char* const names[] = {"howWrite", "howSync", "howAsync"};
    for (int i = 0; i < 3; ++i) {
        auto* button = new SegmentButton(ways);
        button->setObjectName(QString::fromLatin1(names[i]));
        m_how->addButton(button, i);
        ways->layout()->addWidget(button);
    }
    m_how->button(0)->setChecked(true);
    QWidget* deeds = group();
    m_execute = new QPushButton(deeds);
    m_execute->setObjectName(QStringLiteral("execute"));
    m_set = new QPushButton(deeds);
    m_set->setObjectName(QStringLiteral("setGoal"));
    m_set->setProperty("mainAction", true);
    for (QWidget* mover : {m_execute, m_set})
        new PressGuard(mover);
    deeds->layout()->addWidget(m_execute);
    deeds->layout()->addWidget(m_set);
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
    m_hint = new ControlHint(settings, m_messages);
    m_banner = new Banner(m_messages);
    m_banner->setObjectName(QStringLiteral("controlBanner"));
    m_banner->clear();
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
    top->addWidget(buildHead(body));
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
    m_dialPlace = new QVBoxLayout;
    m_goal = new ControlGoal(m_content);
    m_fields = new ControlFields(m_content);
    m_write = buildWrite(m_content);
    m_limit = new ControlLimit(settings, m_content);
    m_said = new QLabel(m_content);
    m_said->setObjectName(QStringLiteral("controlSaid"));
    m_said->setWordWrap(true);
    parts->addWidget(m_mode);
    parts->addLayout(m_dialPlace);
    // What was said stands last: its lines come and go.
    for (QWidget* part : {static_cast<QWidget*>(m_goal), static_cast<QWidget*>(m_fields), m_write,
                          static_cast<QWidget*>(m_limit), static_cast<QWidget*>(m_said)})
        parts->addWidget(part);
}

void ControlPanel::connectParts()
{
    connect(m_torque, &ControlTorque::wanted, this, &ControlPanel::orderTorque);
    connect(m_mode, &ControlMode::wanted, &m_drive, &session::Drive::planMode);
    connect(m_goal, &ControlGoal::moved, this, &ControlPanel::dragTo);
    connect(m_goal, &ControlGoal::dragEnded, this, [this] {
        m_inDrag = false;
        m_drive.endDrag();
        refreshSoon();
    });
    connect(m_goal, &ControlGoal::entered, this, &ControlPanel::set);
    connect(m_goal, &ControlGoal::stopWanted, this, &ControlPanel::halt);
    connect(m_goal, &ControlGoal::stepWanted, this, &ControlPanel::step);
    connect(m_goal, &ControlGoal::againWanted, this, [this] {
        unsay();
        m_drive.again();
    });
    connect(m_goal, &ControlGoal::goalShown, this, &ControlPanel::goalShown);
    connect(m_fields, &ControlFields::entered, this, &ControlPanel::set);
    connect(m_set, &QPushButton::clicked, this, &ControlPanel::set);
    connect(m_execute, &QPushButton::clicked, this, [this] {
        unsay();
        m_drive.execute();
    });
    connect(m_how, &QButtonGroup::idClicked, this, &ControlPanel::showWrite);
    connect(m_limit, &ControlLimit::wanted, &m_drive, &session::Drive::setTorqueLimit);
    m_dialRest.setSingleShot(true);
    m_dialRest.setInterval(dialRest);
    connect(&m_dialRest, &QTimer::timeout, m_goal, &ControlGoal::endPut);
}

void ControlPanel::connectDesk()
{
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(refreshDelay);
    connect(&m_refresh, &QTimer::timeout, this, &ControlPanel::refresh);
    const auto concern = [this](session::ServoRef ref) {
        if (ref == m_selection.current())
            refreshSoon();
    };
    connect(&m_desk, &session::Desk::servoChanged, this, concern);
    connect(&m_desk, &session::Desk::tableChanged, this, concern);
    connect(&m_desk, &session::Desk::linkChanged, this, [this] {
        m_hint->dismiss();
        refreshSoon();
    });
    connect(&m_selection, &Selection::chosenChanged, this, &ControlPanel::choose);
    connect(&m_drive, &session::Drive::changed, this, &ControlPanel::refreshSoon);
    connect(&m_drive, &session::Drive::modeSwitched, m_hint, &ControlHint::dismiss);
    connect(&m_desk, &session::Desk::happened, this, [this](const session::Event& event) {
        if (event.kind == session::Event::Kind::Began)
            unsay();
        if (event.kind == session::Event::Kind::Stopped) {
            m_hint->dismiss();
            unsay();
            m_goal->forgetEdit();
            m_fields->forgetEdits();
            m_limit->forgetEdit();
            refreshSoon();
        }
    });
    connect(&m_drive, &session::Drive::modePlanned, this, &ControlPanel::askForMode);
    connect(&m_drive, &session::Drive::failed, this, &ControlPanel::showError);
    connect(&m_drive, &session::Drive::noted, this, &ControlPanel::showNotices);
    connect(&m_drive, &session::Drive::sent, this, &ControlPanel::goalArrived);
}

void ControlPanel::setDial(QWidget* dial)
{
    m_dial = dial;
    m_dialPlace->addWidget(dial, 0, Qt::AlignHCenter);
    new PressGuard(dial);
    refreshSoon();
}

void ControlPanel::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (!event->spontaneous())
        readUnread();
}

void ControlPanel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}
} // namespace ui
