// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/step/step_gains.h"

#include "jobs/step/step_response.h"
#include "text/language.h"
#include "ui/common/follow_language.h"
#include "ui/common/theme.h"

#include <QGridLayout>
#include <QLabel>
#include <QSpinBox>

#include <limits>

namespace ui {
namespace {
constexpr int nameColumn = 0;
constexpr int nowColumn = 1;
constexpr int trialColumn = 2;

int bounded(std::optional<std::int64_t> value, int otherwise)
{
    return value && *value >= std::numeric_limits<int>::min() &&
                   *value <= std::numeric_limits<int>::max()
               ? int(*value)
               : otherwise;
}
} // namespace

StepGains::StepGains(QWidget* parent)
    : QWidget(parent)
    , m_grid(new QGridLayout(this))
    , m_nowTitle(new QLabel(this))
    , m_trialTitle(new QLabel(this))
    , m_none(new QLabel(this))
{
    setObjectName(QStringLiteral("stepGains"));
    m_grid->setContentsMargins({});
    m_grid->setVerticalSpacing(3);
    m_grid->setColumnStretch(nameColumn, 1);
    m_none->setWordWrap(true);
    m_nowTitle->setAlignment(Qt::AlignRight);
    for (QLabel* title : {m_nowTitle, m_trialTitle})
        title->setForegroundRole(QPalette::PlaceholderText);
    m_grid->addWidget(m_none, 0, nameColumn, 1, 3);
    m_grid->addWidget(m_nowTitle, 1, nowColumn);
    m_grid->addWidget(m_trialTitle, 1, trialColumn);
    followLanguage(this, [this] { retranslate(); });
}

void StepGains::clear()
{
    for (const Row& row : m_rows) {
        delete row.name;
        delete row.now;
        delete row.trial;
    }
    m_rows.clear();
}

void StepGains::build(const session::ServoEntry& entry)
{
    clear();
    m_profile = entry.servo.profile;
    m_servo = entry.ref;
    int line = 2;
    for (const catalog::Register* reg : jobs::loopRegisters(*m_profile)) {
        Row row{reg, new QLabel(this), new QLabel(this), new QSpinBox(this)};
        row.now->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        row.now->setObjectName(QStringLiteral("stepNow_") + reg->key);
        row.trial->setObjectName(QStringLiteral("stepTry_") + reg->key);
        row.trial->setRange(bounded(reg->min, 0), bounded(reg->max, 254));
        row.trial->setFocusPolicy(Qt::StrongFocus);
        row.trial->setEnabled(false);
        row.name->setBuddy(row.trial);
        m_grid->addWidget(row.name, line, nameColumn);
        m_grid->addWidget(row.now, line, nowColumn);
        m_grid->addWidget(row.trial, line++, trialColumn);
        connect(row.trial, &QSpinBox::valueChanged, this, [this, key = reg->key] {
            for (Row& one : m_rows) {
                if (one.reg->key == key)
                    markChanged(one);
            }
            Q_EMIT changed();
        });
        m_rows.push_back(row);
    }
    retranslate();
}

void StepGains::showServo(const session::ServoEntry* entry)
{
    if (entry == nullptr || !entry->servo.profile) {
        clear();
        m_profile.reset();
        m_servo = 0;
        retranslate();
        return;
    }
    if (entry->ref != m_servo || entry->servo.profile != m_profile)
        build(*entry);
    for (Row& row : m_rows) {
        const auto raw = entry->displayedRaw(*row.reg);
        if (raw == row.raw)
            continue;
        row.raw = raw;
        row.now->setText(raw ? QString::number(*raw) : QStringLiteral("–"));
        row.trial->setEnabled(raw.has_value());
        if (raw)
            row.trial->setValue(bounded(raw, row.trial->minimum()));
        markChanged(row);
    }
}

/// Changed values are bold, not only colored.
void StepGains::markChanged(Row& row)
{
    const bool differs = row.raw && row.trial->value() != *row.raw;
    QFont font = row.name->font();
    font.setBold(differs);
    row.name->setFont(font);
    QFont number = row.trial->font();
    number.setBold(differs);
    row.trial->setFont(number);
}

std::vector<results::StepGain> StepGains::trial() const
{
    std::vector<results::StepGain> gains;
    for (const Row& row : m_rows) {
        if (row.raw && row.trial->value() != *row.raw)
            gains.push_back({row.reg->key, row.trial->value()});
    }
    return gains;
}

void StepGains::setTrial(const QString& key, std::int64_t raw)
{
    for (const Row& row : m_rows) {
        if (row.reg->key == key)
            row.trial->setValue(bounded(raw, row.trial->value()));
    }
}

void StepGains::reset()
{
    for (const Row& row : m_rows) {
        if (row.raw)
            row.trial->setValue(bounded(row.raw, row.trial->minimum()));
    }
}

void StepGains::retranslate()
{
    m_nowTitle->setText(tr("Now"));
    m_trialTitle->setText(tr("Trial"));
    m_none->setText(m_profile ? tr("This servo family has no gains to set.")
                              : tr("Select a servo to see its gains."));
    m_none->setVisible(m_rows.empty());
    m_nowTitle->setVisible(!m_rows.empty());
    m_trialTitle->setVisible(!m_rows.empty());
    for (const Row& row : m_rows) {
        const QString name = text::localized(row.reg->name);
        row.name->setText(name);
        row.name->setToolTip(row.reg->key + QStringLiteral("\n") + text::localized(row.reg->help));
        row.trial->setAccessibleName(tr("%1: value to try").arg(name));
        row.trial->setToolTip(tr("%1 … %2; used only for trials until you click Keep gains")
                                  .arg(row.trial->minimum())
                                  .arg(row.trial->maximum()));
    }
}
} // namespace ui
