// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/step/step_form.h"

#include "device/motion/move_limits.h"
#include "ui/common/follow_language.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>

#include <array>

namespace ui {
namespace {
constexpr int maxRepeats = 50;
constexpr int defaultRepeats = 3;
constexpr int maxHold = 10'000; ///< ms
constexpr int holdStep = 100;
constexpr int defaultTurnFraction = 12; ///< 30° of a servo that turns all round

const QString sizeKey = QStringLiteral("step/size");
const QString repeatsKey = QStringLiteral("step/repeats");
const QString holdKey = QStringLiteral("step/hold");
} // namespace

StepForm::StepForm(session::Settings& settings, QWidget* parent)
    : QWidget(parent)
    , m_settings(settings)
    , m_sizeLabel(new QLabel(this))
    , m_size(line("stepSize"))
    , m_fromLabel(new QLabel(this))
    , m_from(line("stepFrom"))
    , m_repeatsLabel(new QLabel(this))
    , m_repeats(new QSpinBox(this))
    , m_holdLabel(new QLabel(this))
    , m_hold(new QSpinBox(this))
    , m_speedLabel(new QLabel(this))
    , m_speed(line("stepSpeed"))
    , m_accelerationLabel(new QLabel(this))
    , m_acceleration(line("stepAcceleration"))
{
    m_repeats->setObjectName(QStringLiteral("stepRepeats"));
    m_repeats->setRange(1, maxRepeats);
    m_repeats->setValue(settings.pageValue(repeatsKey, defaultRepeats).toInt());
    m_hold->setObjectName(QStringLiteral("stepHold"));
    m_hold->setRange(0, maxHold);
    m_hold->setSingleStep(holdStep);
    m_hold->setValue(settings.pageValue(holdKey, 0).toInt());
    const QString size = settings.pageValue(sizeKey, QString()).toString();
    m_size->setText(size);
    m_sizeEdited = !size.isEmpty();
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins({});
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(2);
    const std::array<std::pair<QLabel*, QWidget*>, 6> cells{
        {{m_sizeLabel, m_size},
         {m_fromLabel, m_from},
         {m_repeatsLabel, m_repeats},
         {m_holdLabel, m_hold},
         {m_speedLabel, m_speed},
         {m_accelerationLabel, m_acceleration}}};
    int place = 0; // title above field, two columns
    for (const auto& [label, field] : cells) {
        label->setBuddy(field);
        label->setForegroundRole(QPalette::PlaceholderText);
        field->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // as wide as the panel
        const int row = place / 2 * 2;
        grid->addWidget(label, row, place % 2);
        grid->addWidget(field, row + 1, place++ % 2);
    }
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
    connect(m_size, &QLineEdit::textEdited, this,
            [this](const QString& text) { m_sizeEdited = !text.isEmpty(); });
    connect(m_repeats, &QSpinBox::valueChanged, this, &StepForm::changed);
    connect(m_hold, &QSpinBox::valueChanged, this, &StepForm::changed);
    followLanguage(this, [this] { retranslate(); });
}

QLineEdit* StepForm::line(const char* name)
{
    auto* edit = new QLineEdit(this);
    edit->setObjectName(QString::fromLatin1(name));
    connect(edit, &QLineEdit::textChanged, this, &StepForm::changed);
    return edit;
}

void StepForm::showServo(const session::ServoEntry* entry)
{
    if (entry == nullptr || !entry->servo.profile)
        return;
    const catalog::Profile& profile = *entry->servo.profile;
    if (!m_sizeEdited)
        m_size->setText(QString::number(profile.stepsPerTurn / defaultTurnFraction));
    // The fields of a mode may be known only after the mode was switched.
    const device::MoveFieldSet fields = device::moveFields(entry->servo);
    const bool positions = device::goalKind(entry->servo) == device::GoalKind::Position ||
                           device::goalKind(entry->servo) == device::GoalKind::Turns;
    const bool speed = !positions || fields.speed;
    const bool acceleration = profile.byRole(catalog::Role::Acceleration) != nullptr;
    m_speedLabel->setVisible(speed);
    m_speed->setVisible(speed);
    m_accelerationLabel->setVisible(acceleration);
    m_acceleration->setVisible(acceleration);
}

results::StepSpec StepForm::spec() const
{
    results::StepSpec spec;
    spec.size = m_size->text().trimmed();
    spec.from = m_from->text().trimmed();
    spec.repeats = m_repeats->value();
    spec.hold = std::chrono::milliseconds(m_hold->value());
    if (m_speed->isVisibleTo(this))
        spec.speed = m_speed->text().trimmed();
    if (m_acceleration->isVisibleTo(this))
        spec.acceleration = m_acceleration->text().trimmed();
    return spec;
}

void StepForm::saveSettings()
{
    m_settings.setPageValue(sizeKey, m_sizeEdited ? m_size->text().trimmed() : QString());
    m_settings.setPageValue(repeatsKey, m_repeats->value());
    m_settings.setPageValue(holdKey, m_hold->value());
}

void StepForm::retranslate()
{
    const auto setTexts = [](QLabel* label, QWidget* field, const QString& name,
                             const QString& tip) {
        label->setText(name);
        field->setAccessibleName(name);
        field->setToolTip(tip);
    };
    setTexts(m_sizeLabel, m_size, tr("Step"),
             tr("Raw value, or a value with its unit (30deg); if the value is negative, the servo "
                "first moves toward lower positions"));
    setTexts(m_fromLabel, m_from, tr("Start"),
             tr("Start position of the step; leave empty to use the present position, or the "
                "nearest one with enough room"));
    setTexts(m_repeatsLabel, m_repeats, tr("Repeats"), tr("Number of back-and-forth steps"));
    setTexts(m_holdLabel, m_hold, tr("Wait"),
             tr("Time from one goal to the next; 0: as long as the step takes"));
    setTexts(m_speedLabel, m_speed, tr("Speed"),
             tr("Raw value, or a value with its unit; leave empty for the maximum (the previous "
                "value is restored after the run)"));
    setTexts(m_accelerationLabel, m_acceleration, tr("Acceleration"),
             tr("Raw value, or a value with its unit; leave empty for the maximum (the previous "
                "value is restored after the run)"));
    m_from->setPlaceholderText(tr("present position"));
    m_speed->setPlaceholderText(tr("maximum"));
    m_acceleration->setPlaceholderText(tr("maximum"));
    m_hold->setSuffix(QStringLiteral(" ms"));
    m_hold->setSpecialValueText(tr("automatic"));
}
} // namespace ui
