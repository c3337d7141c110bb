// SPDX-License-Identifier: GPL-3.0-or-later
// Builds the step page, and its texts.
#include "ui/common/widget_style.h"
#include "ui/step/step_form.h"
#include "ui/step/step_gains.h"
#include "ui/step/step_page.h"
#include "ui/step/step_results.h"
#include "ui/widgets/allow_movement_button.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/floating_overlay.h"
#include "ui/widgets/press_guard.h"
#include "ui/widgets/thin_progress.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

namespace ui {
void StepPage::build(session::Settings& settings)
{
    auto* column = new QVBoxLayout(this);
    m_banner = new Banner(this);
    m_banner->setObjectName(QStringLiteral("stepBanner"));
    m_banner->hideMessage();
    // Interrupted writes are resolved elsewhere; then the message is obsolete.
    connect(&m_workbench.recovery(), &session::RecoveryService::openIntentsFound, m_banner,
            [this](const std::vector<jobs::RecoveryResult>& found, const auto& elsewhere) {
                const bool settled =
                    std::any_of(found.begin(), found.end(), [](const jobs::RecoveryResult& one) {
                        return one.done && one.before.intent.kind == base::IntentKind::Trial;
                    });
                if (settled || (found.empty() && elsewhere.empty()))
                    m_banner->hideMessage();
            });
    auto* card = new QWidget(this);
    auto* left = new QVBoxLayout(card);
    left->setSpacing(6);
    makeCard(card);
    m_scroll = new QScrollArea(card);
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setWidget(buildSetup(settings));
    makeTransparent(m_scroll);
    left->addWidget(m_scroll, 1);
    left->addWidget(buildRun());
    m_results =
        new StepResults(m_test, m_workbench.registry(), m_workbench.catalog(), settings, this);
    auto* row = new QHBoxLayout;
    row->setSpacing(cardMargin);
    row->addWidget(card);
    row->addWidget(m_results, 1);
    column->addLayout(row, 1);
    new FloatingOverlay(m_banner, this, FloatingOverlay::Corner::BottomRight);
}

QWidget* StepPage::buildSetup(session::Settings& settings)
{
    m_setup = new QWidget(m_scroll);
    auto* setup = new QVBoxLayout(m_setup);
    setup->setContentsMargins(0, 0, 4, 0);
    m_form = new StepForm(settings, m_setup);
    m_gainsTitle = new QLabel(m_setup);
    makeHeading(m_gainsTitle);
    m_gains = new StepGains(m_setup);
    setup->addWidget(m_form);
    setup->addWidget(m_gainsTitle);
    setup->addWidget(m_gains);
    setup->addStretch();
    return m_setup;
}

QPushButton* StepPage::button(const char* name, QWidget* parent)
{
    auto* made = new QPushButton(parent);
    made->setObjectName(QString::fromLatin1(name));
    return made;
}

/// Always in sight, however long the fields above are.
QWidget* StepPage::buildRun()
{
    auto* box = new QWidget(this);
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins({});
    grid->setSpacing(4);
    m_reasonLabel = new QLabel(box);
    m_reasonLabel->setObjectName(QStringLiteral("stepWhy"));
    m_reasonLabel->setWordWrap(true);
    m_switchMode = new QCheckBox(box);
    m_switchMode->setObjectName(QStringLiteral("stepSwitchMode"));
    m_switchMode->hide();
    m_allow = new AllowMovementButton(m_workbench.emergencyStop(), m_workbench.registry(),
                                      m_workbench.link(), *m_banner, box);
    m_allow->setObjectName(QStringLiteral("stepAllow"));
    m_run = button("stepRun", box);
    makeMainAction(m_run);
    m_try = button("stepTry", box);
    m_stop = button("stepStop", box);
    m_accept = button("stepAccept", box);
    m_back = button("stepBack", box);
    m_progress = new ThinProgress(box);
    m_progress->setObjectName(QStringLiteral("stepProgress"));
    m_progress->setRange(0, 1000);
    // The buttons are last: widgets that come and go above them must not move them.
    grid->addWidget(m_progress, 0, 0, 1, 3);
    grid->addWidget(m_reasonLabel, 1, 0, 1, 3);
    grid->addWidget(m_switchMode, 2, 0, 1, 3);
    grid->addWidget(m_allow, 3, 0, 1, 3);
    grid->addWidget(m_run, 4, 0);
    grid->addWidget(m_try, 4, 1);
    grid->addWidget(m_stop, 4, 2);
    grid->addWidget(m_accept, 5, 0, 1, 2);
    grid->addWidget(m_back, 5, 2);
    for (QWidget* mover : {m_run, m_try})
        new PressGuard(mover);
    return box;
}

void StepPage::retranslate()
{
    setAccessibleName(tr("Step response"));
    m_gainsTitle->setText(tr("Gains"));
    m_run->setText(tr("Measure"));
    m_run->setToolTip(tr("Measures the step with the servo's present gains: the servo will move"));
    m_try->setText(tr("Try gains"));
    m_stop->setText(tr("Stop"));
    m_stop->setToolTip(tr("Ends the run; the servo holds its position"));
    m_accept->setText(tr("Keep gains"));
    m_accept->setToolTip(tr("Permanently writes the values listed under Trial"));
    m_switchMode->setText(tr("Switch to position mode for the run"));
    m_switchMode->setAccessibleName(m_switchMode->text());
    m_switchMode->setToolTip(tr("Switches back after the run; nothing is stored permanently in "
                                "the servo"));
    m_progress->setAccessibleName(tr("Progress of the run"));
    for (QPushButton* one : {m_run, m_try, m_stop, m_accept})
        one->setAccessibleName(one->text());
}
} // namespace ui
