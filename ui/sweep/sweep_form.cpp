// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sweep/sweep_form.h"

#include "device/motion/move_limits.h"
#include "ui/common/follow_language.h"
#include "ui/common/widget_text.h"
#include "ui/sweep/sweep_end_conditions.h"
#include "ui/sweep/sweep_goal_list.h"
#include "ui/widgets/segmented_control.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QVBoxLayout>

#include <cmath>
#include <limits>

namespace ui {
using results::SweepPace;
using results::SweepShape;

namespace {
constexpr std::array shapes{SweepShape::Sweep, SweepShape::Stairs, SweepShape::BothSides,
                            SweepShape::Sine,  SweepShape::Random, SweepShape::Points};
constexpr int columns = 2;
constexpr int maxPause = 3'600'000; // ms
constexpr int maxCycles = 1'000'000;
constexpr double maxMinutes = 7 * 24 * 60;
constexpr int minPeriod = 100; // ms
constexpr double maxPeriod = 3600;
constexpr int maxWarmUp = 24 * 3600;
constexpr int defaultPause = 2000;
constexpr int defaultCycles = 10;
constexpr double defaultMinutes = 10;
constexpr double defaultPeriod = 4;

const QString paceKey = QStringLiteral("sweep/pace");
const QString shapeKey = QStringLiteral("sweep/shape");
const QString cyclesKey = QStringLiteral("sweep/cycles");
const QString minutesKey = QStringLiteral("sweep/minutes");
const QString untilKey = QStringLiteral("sweep/until");
const QString operatorKey = QStringLiteral("sweep/operator");

void setFieldTexts(QLabel* title, QWidget* field, const QString& text, const QString& tip)
{
    title->setText(text);
    title->setToolTip(tip);
    field->setAccessibleName(text);
    field->setToolTip(tip);
}
} // namespace

SweepForm::SweepForm(session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
{
    setObjectName(QStringLiteral("sweepForm"));
    build();
    loadSettings(settings);
    followLanguage(this, [this] { retranslate(); });
    arrange();
}

void SweepForm::build()
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->setSpacing(6);
    m_shapes = new SegmentedControl(this);
    for (const auto shape : shapes)
        m_shapes->addSegment(QStringLiteral("sweepShape_") + results::sweepShapeName(shape));
    connect(m_shapes, &SegmentedControl::chosen, this, [this](int index) {
        selectShape(shapes[static_cast<std::size_t>(index)]);
        Q_EMIT changed();
    });
    m_middle = new QVBoxLayout;
    for (QGridLayout** grid : {&m_grid, &m_extraGrid}) {
        *grid = new QGridLayout;
        (*grid)->setHorizontalSpacing(10);
        (*grid)->setVerticalSpacing(2);
    }
    column->addWidget(m_shapes);
    column->addLayout(m_grid);
    column->addLayout(m_middle);
    buildFields();
    m_endConditions = new SweepEndConditions(this);
    connect(m_endConditions, &SweepEndConditions::changed, this, &SweepForm::changed);
    column->addWidget(m_endConditions);
    column->addLayout(m_extraGrid);
}

void SweepForm::insertServoList(QWidget* servos)
{
    m_middle->addWidget(servos);
    m_inserted = servos;
}

void SweepForm::setLocked(bool locked)
{
    for (auto* child : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (child != m_inserted)
            child->setEnabled(!locked);
    }
}

void SweepForm::add(Cell cell, QWidget* field, const char* name, bool wide)
{
    field->setObjectName(QString::fromLatin1(name));
    field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // as wide as the panel
    auto* title = new QLabel(this);
    title->setBuddy(field);
    title->setForegroundRole(QPalette::PlaceholderText);
    m_cells[cell] = {title, field, wide};
}

QLineEdit* SweepForm::line(Cell cell, const char* name, bool wide)
{
    auto* edit = new QLineEdit(this);
    add(cell, edit, name, wide);
    connect(edit, &QLineEdit::textEdited, this, &SweepForm::changed);
    return edit;
}

void SweepForm::buildFields()
{
    const auto spin = [this](Cell cell, const char* name, int minValue, int maxValue, int value) {
        auto* box = new QSpinBox(this);
        box->setRange(minValue, maxValue);
        box->setValue(value);
        add(cell, box, name);
        connect(box, &QSpinBox::valueChanged, this, &SweepForm::changed);
        return box;
    };
    const auto real = [this](Cell cell, const char* name, double minValue, double maxValue,
                             double value) {
        auto* box = new QDoubleSpinBox(this);
        box->setRange(minValue, maxValue);
        box->setDecimals(1);
        box->setValue(value);
        add(cell, box, name);
        connect(box, &QDoubleSpinBox::valueChanged, this, &SweepForm::changed);
        return box;
    };
    const auto choice = [this](Cell cell, const char* name) {
        auto* box = new QComboBox(this);
        box->addItems({QString(), QString()});
        add(cell, box, name);
        connect(box, &QComboBox::activated, this, [this] {
            retranslate(); // a delay becomes a dwell
            arrange();
            Q_EMIT changed();
        });
        return box;
    };
    m_start = line(Start, "sweepStart");
    m_end = line(End, "sweepEnd");
    m_step = line(Step, "sweepStep");
    m_step->setText(QStringLiteral("256"));
    m_period = real(Period, "sweepPeriod", minPeriod / 1000.0, maxPeriod, defaultPeriod);
    m_seed = spin(Seed, "sweepSeed", 0, std::numeric_limits<int>::max(), 1);
    m_list = new SweepGoalList(m_settings, this);
    add(List, m_list, "sweepList", true);
    connect(m_list, &SweepGoalList::changed, this, &SweepForm::changed);
    m_pace = choice(Pace, "sweepPace");
    m_pause = spin(Pause, "sweepPause", 1, maxPause, defaultPause);
    m_pause->setSingleStep(100);
    m_until = choice(Until, "sweepUntil");
    m_cycles = spin(Cycles, "sweepCycles", 1, maxCycles, defaultCycles);
    m_minutes = real(Minutes, "sweepMinutes", 0.1, maxMinutes, defaultMinutes);
    m_speed = line(Speed, "sweepSpeed");
    m_acceleration = line(Acceleration, "sweepAcceleration");
    m_time = line(Time, "sweepTime");
    m_warmUp = spin(WarmUp, "sweepWarmUp", 0, maxWarmUp, 0);
    m_afterwards = choice(Afterwards, "sweepAfterwards");
    m_operator = line(Operator, "sweepOperator", true);
    m_note = line(Note, "sweepNote", true);
    const auto range = [this] { m_rangeEdited = true; };
    connect(m_start, &QLineEdit::textEdited, this, range);
    connect(m_end, &QLineEdit::textEdited, this, range);
    connect(m_pause, &QSpinBox::valueChanged, this, [this] { m_pauseEdited = true; });
    connect(m_period, &QDoubleSpinBox::valueChanged, this, [this] { m_periodEdited = true; });
}

void SweepForm::loadSettings(session::Settings& settings)
{
    const QString shape = settings.pageValue(shapeKey, QString()).toString();
    selectShape(results::sweepShapeFromName(shape).value_or(SweepShape::Sweep));
    const QSignalBlocker blocker(this);
    m_pace->setCurrentIndex(settings.pageValue(paceKey, 0).toInt() == 1 ? 1 : 0);
    m_until->setCurrentIndex(settings.pageValue(untilKey, 0).toInt() == 1 ? 1 : 0);
    m_cycles->setValue(settings.pageValue(cyclesKey, defaultCycles).toInt());
    m_minutes->setValue(settings.pageValue(minutesKey, defaultMinutes).toDouble());
    m_operator->setText(settings.pageValue(operatorKey, QString()).toString());
}

void SweepForm::saveSettings()
{
    m_settings.setPageValue(shapeKey, results::sweepShapeName(m_shape));
    m_settings.setPageValue(paceKey, m_pace->currentIndex());
    m_settings.setPageValue(untilKey, m_until->currentIndex());
    m_settings.setPageValue(cyclesKey, m_cycles->value());
    m_settings.setPageValue(minutesKey, m_minutes->value());
    m_settings.setPageValue(operatorKey, m_operator->text().trimmed());
}

void SweepForm::selectShape(SweepShape shape)
{
    m_shape = shape;
    m_shapes->select(int(std::find(shapes.begin(), shapes.end(), shape) - shapes.begin()));
    arrange();
}

bool SweepForm::isShown(Cell cell) const
{
    const bool list = m_shape == SweepShape::Points;
    const bool sine = m_shape == SweepShape::Sine;
    switch (cell) {
    case Start:
    case End:
        return !list;
    case Step:
        return m_shape == SweepShape::Stairs;
    case Period:
        return sine;
    case Seed:
        return m_shape == SweepShape::Random;
    case List:
        return list;
    case Pace:
    case Pause:
        return !sine;
    case Cycles:
        return m_until->currentIndex() == 0;
    case Minutes:
        return m_until->currentIndex() == 1;
    case Speed:
        return m_moves[0];
    case Acceleration:
        return m_moves[1];
    case Time:
        return m_moves[2];
    default:
        return true;
    }
}

void SweepForm::arrange()
{
    if (m_cells[Note].field == nullptr)
        return;
    arrange(*m_grid, Start, Time);
    arrange(*m_extraGrid, WarmUp, Note);
}

/// Title above field, two columns.
void SweepForm::arrange(QGridLayout& grid, Cell first, Cell last)
{
    int place = 0;
    for (int i = first; i <= last; ++i) {
        const FieldCell& cell = m_cells[std::size_t(i)];
        grid.removeWidget(cell.title);
        grid.removeWidget(cell.field);
        const bool shown = isShown(static_cast<Cell>(i));
        cell.title->setVisible(shown);
        cell.field->setVisible(shown);
        if (!shown)
            continue;
        if (cell.wide && place % columns != 0)
            ++place;
        const int row = place / columns * 2;
        const int width = cell.wide ? columns : 1;
        grid.addWidget(cell.title, row, place % columns, 1, width);
        grid.addWidget(cell.field, row + 1, place % columns, 1, width);
        place += width;
    }
    for (int column = 0; column < columns; ++column)
        grid.setColumnStretch(column, 1);
}

void SweepForm::showServo(const session::ServoEntry* entry)
{
    if (entry == nullptr || !entry->servo.profile)
        return;
    const device::MoveFieldSet fields = device::moveFields(entry->servo);
    // A mode without positions has none of these fields.
    const std::array moves{fields.speed, fields.acceleration, fields.time};
    if (moves != m_moves && moves != decltype(moves){}) {
        m_moves = moves;
        arrange();
    }
}

SweepForm::UserInput SweepForm::userInput() const
{
    UserInput values;
    if (m_rangeEdited)
        values.range = results::SweepRange{m_start->text(), m_end->text()};
    if (m_pauseEdited)
        values.pause = m_pause->value();
    if (m_periodEdited)
        values.period = m_period->value();
    return values;
}

void SweepForm::setUserInput(const UserInput& values)
{
    m_rangeEdited = values.range.has_value();
    m_pauseEdited = values.pause.has_value();
    m_periodEdited = values.period.has_value();
    const QSignalBlocker pauseBlocker(m_pause);
    const QSignalBlocker periodBlocker(m_period);
    if (values.range) {
        m_start->setText(values.range->from);
        m_end->setText(values.range->to);
    }
    if (values.pause)
        m_pause->setValue(*values.pause);
    if (values.period)
        m_period->setValue(*values.period);
}

void SweepForm::propose(const results::SweepRange& range)
{
    if (m_rangeEdited)
        return;
    m_start->setText(range.from);
    m_end->setText(range.to);
}

void SweepForm::propose(base::Duration enough)
{
    if (enough <= base::Duration::zero())
        return;
    const auto ms = enough / std::chrono::milliseconds(1);
    if (m_shape == SweepShape::Sine && !m_periodEdited) {
        const QSignalBlocker blocker(m_period);
        m_period->setValue(double(ms) / 1000);
    } else if (m_shape != SweepShape::Sine && !m_pauseEdited && m_pace->currentIndex() == 0) {
        const QSignalBlocker blocker(m_pause);
        m_pause->setValue(int(std::min<std::int64_t>(ms, maxPause)));
    }
}

void SweepForm::setPace(base::Duration enough)
{
    (m_shape == SweepShape::Sine ? m_periodEdited : m_pauseEdited) = false;
    propose(enough);
}

results::SweepSpec SweepForm::spec() const
{
    using std::chrono::milliseconds;
    results::SweepSpec spec;
    const auto shown = [this](Cell cell, const QLineEdit* edit) {
        return isShown(cell) ? edit->text().trimmed() : QString();
    };
    spec.shape = m_shape;
    spec.range = {shown(Start, m_start), shown(End, m_end)};
    spec.step = shown(Step, m_step);
    if (isShown(List))
        spec.points = m_list->points();
    spec.seed = std::uint32_t(m_seed->value());
    if (isShown(Period))
        spec.period = milliseconds(std::llround(m_period->value() * 1000));
    spec.pace = m_pace->currentIndex() == 1 ? SweepPace::Dwell : SweepPace::Delay;
    if (isShown(Pause))
        spec.pause = milliseconds(m_pause->value());
    spec.cycles = isShown(Cycles) ? m_cycles->value() : 0;
    if (isShown(Minutes))
        spec.length = milliseconds(std::llround(m_minutes->value() * 60'000));
    spec.speed = shown(Speed, m_speed);
    spec.acceleration = shown(Acceleration, m_acceleration);
    spec.time = shown(Time, m_time);
    spec.warmUp = std::chrono::seconds(m_warmUp->value());
    spec.releaseAtEnd = m_afterwards->currentIndex() == 1;
    m_endConditions->writeTo(spec);
    spec.operatorName = m_operator->text().trimmed();
    spec.note = m_note->text().trimmed();
    return spec;
}

QString SweepForm::inputError() const
{
    return m_list->error();
}

void SweepForm::retranslate()
{
    const std::array names{
        std::pair{tr("Sweep"), tr("Back and forth between start and end")},
        std::pair{tr("Staircase"), tr("From start to end in steps, and back in the same steps")},
        std::pair{tr("Both directions"),
                  tr("Approaches the middle of the range from both directions; shows hysteresis")},
        std::pair{tr("Sine"), tr("The goal follows a sine wave: shows how well the servo follows")},
        std::pair{tr("Random"), tr("Random goals; the same seed gives the same goals")},
        std::pair{tr("List"), tr("Goals from a file, one per line")}};
    for (std::size_t i = 0; i < shapes.size(); ++i)
        setButtonText(m_shapes->segment(int(i)), names[i].first, names[i].second);
    const auto set = [this](Cell cell, const QString& text, const QString& tip) {
        setFieldTexts(m_cells[cell].title, m_cells[cell].field, text, tip);
    };
    const QString place = tr("A raw value, or an angle with its unit, such as 90deg");
    set(Start, tr("Start"), place);
    set(End, tr("End"), place);
    set(Step, tr("Step"), tr("A number of steps, or an angle with its unit, such as 10deg"));
    set(Period, tr("Period"), tr("Duration of one full sine period, to the end and back"));
    set(Seed, tr("Random seed"), tr("The same seed gives the same goals"));
    set(List, tr("Goals"),
        tr("A text file: one goal per line, optionally followed by a comma and a pause in "
           "milliseconds"));
    set(Pace, tr("Next goal"), tr("When the next goal is sent"));
    set(Pause, m_pace->currentIndex() == 1 ? tr("Dwell") : tr("Delay"),
        m_pace->currentIndex() == 1
            ? tr("Pause after the goal is reached")
            : tr("Time from one goal to the next, whether or not the goal is reached"));
    set(Until, tr("End after"), tr("Condition that ends the test"));
    set(Cycles, tr("Cycles"), tr("One cycle goes to the end and back"));
    set(Minutes, tr("Duration"), tr("Counted from the first move"));
    set(Speed, tr("Speed"),
        tr("Raw value, or a value with its unit, such as 30rpm; leave empty to use the present "
           "setting"));
    set(Acceleration, tr("Acceleration"), tr("Raw value; leave empty to use the present setting"));
    set(Time, tr("Travel time"),
        tr("Travel time of a move in milliseconds; leave empty to let the speed determine it"));
    set(WarmUp, tr("Warm-up"), tr("How long the servo moves before measuring starts"));
    set(Afterwards, tr("After the test"),
        tr("State of the servos after the test ends or is stopped"));
    set(Operator, tr("Operator"), tr("Appears in the report"));
    set(Note, tr("Note"), tr("Appears in the report"));
    m_period->setSuffix(tr(" s"));
    m_pause->setSuffix(tr(" ms"));
    m_minutes->setSuffix(tr(" min"));
    m_warmUp->setSuffix(tr(" s"));
    m_speed->setPlaceholderText(tr("unchanged"));
    m_acceleration->setPlaceholderText(tr("unchanged"));
    m_time->setPlaceholderText(tr("set by speed"));
    m_pace->setItemText(0, tr("After a delay"));
    m_pace->setItemText(1, tr("After arrival"));
    m_until->setItemText(0, tr("A number of cycles"));
    m_until->setItemText(1, tr("A set time"));
    m_afterwards->setItemText(0, tr("Hold position"));
    m_afterwards->setItemText(1, tr("Torque off"));
    m_list->retranslate();
    m_endConditions->retranslate();
}
} // namespace ui
